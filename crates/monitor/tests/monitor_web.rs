//! What is refused: foreign hosts and origins, what is no request, malformed, huge and flooding messages. It is noted, and the
//! service goes on.
#![allow(clippy::unwrap_used)]

mod common;

use common::{Page, log, monitor, noted, play, raw};
use serde_json::json;
use tungstenite::Message;

#[test]
fn the_page_comes_with_a_policy_and_nothing_else_comes() {
    let dir = tempfile::tempdir().unwrap();
    let (monitor, notes) = monitor(play(&log(dir.path())), false);
    let at = monitor.address();
    let get =
        |path: &str, host: &str| raw(at, format!("GET {path} HTTP/1.1\r\nHost: {host}\r\n\r\n").as_bytes());
    let ours = at.to_string();
    let (first, second) = (get("/", &ours), get("/", &format!("localhost:{}", at.port())));
    let nonce = |answer: &str| answer.split("script-src 'nonce-").nth(1).unwrap()[..32].to_owned();
    for answer in [&first, &second] {
        assert!(
            answer.starts_with("HTTP/1.1 200 ") && answer.contains("<title>soilctl monitor"),
            "{answer:.300}"
        );
        assert!(answer.contains("default-src 'none'") && answer.contains("frame-ancestors 'none'"));
        assert_eq!(answer.matches(&format!("nonce=\"{}\"", nonce(answer))).count(), 2);
    }
    assert_ne!(nonce(&first), nonce(&second));
    let refused = [
        (get("/", "evil.example"), "421"),
        (get("/", &format!("evil.example:{}", at.port())), "421"),
        (get("/etc/passwd", &ours), "404"),
        (get("/socket", &ours), "426"),
        (raw(at, b"GET / HTTP/1.1\r\n\r\n"), "421"),
        (raw(at, format!("POST / HTTP/1.1\r\nHost: {ours}\r\n\r\n").as_bytes()), "405"),
        (raw(at, b"\x00\x01\x02\r\n\r\n"), "400"),
        (raw(at, format!("GET / HTTP/1.1\r\nHost: {ours}\r\nHost: {ours}\r\n\r\n").as_bytes()), "400"),
        (raw(at, format!("GET / HTTP/1.1\r\nX: {}", "x".repeat(9000)).as_bytes()), "431"),
    ];
    for (answer, status) in &refused {
        assert!(answer.starts_with(&format!("HTTP/1.1 {status} ")), "{status}: {answer:.100}");
    }
    assert!(noted(&notes, "evil.example") && noted(&notes, "malformed"));
    assert!(get("/", &ours).starts_with("HTTP/1.1 200 "));
    assert_eq!(monitor.stop().refused, 8);
}

#[test]
fn a_page_of_another_site_is_refused() {
    let dir = tempfile::tempdir().unwrap();
    let (monitor, notes) = monitor(play(&log(dir.path())), false);
    let at = monitor.address();
    for origin in ["http://evil.example", "null", "http://127.0.0.1:1", "https://localhost"] {
        assert_eq!(Page::from_origin(at, Some(origin)).err(), Some(403), "{origin}");
        assert!(noted(&notes, origin));
    }
    // A program that is no browser sends none.
    assert_eq!(Page::from_origin(at, None).unwrap().next()["type"], "hello");
    assert_eq!(Page::open(at).next()["type"], "hello");
    // Through a tunnel, whose end is another port, and behind a proxy that speaks TLS.
    for (host, origin) in [("localhost:9000", "http://localhost:9000"), ("localhost", "https://localhost")] {
        assert_eq!(Page::through(at, host, origin).unwrap().next()["type"], "hello");
    }
    assert_eq!(Page::through(at, "localhost:9000", "http://localhost:9001").err(), Some(403));
    let counts = monitor.stop();
    assert_eq!((counts.pages, counts.refused), (4, 5));
}

#[test]
fn malformed_messages_are_answered_and_the_page_goes_on() {
    let dir = tempfile::tempdir().unwrap();
    let (monitor, notes) = monitor(play(&log(dir.path())), false);
    let mut page = Page::open(monitor.address());
    let lines = [
        "",
        "{",
        "[]",
        "null",
        "\"play\"",
        "{\"type\":\"play\",\"x\":1}",
        "{\"type\":\"seek\"}",
        "{\"type\":\"seek\",\"time_s\":\"x\"}",
        "{\"type\":\"seek\",\"time_s\":1e999}",
        "{\"type\":\"none\"}",
        "{\"type\":\"step\",\"count\":99999999999}",
        "{\"type\":\"authorize\"}",
        "\u{0}\u{7f}",
        "{\"type\":\"command\",\"id\":-1,\"command\":{\"name\":\"enable\"}}",
    ];
    for line in lines {
        page.socket.send(Message::text(line)).unwrap();
        assert_eq!(page.wait("error", |_| true)["problem"], "malformed", "{line:?}");
    }
    page.socket.send(Message::binary(vec![1, 2, 3])).unwrap();
    page.wait("error", |error| error["message"].as_str().unwrap().contains("binary"));
    for (message, problem) in [
        (json!({"type": "speed", "speed": 0.0}), "value"),
        (json!({"type": "speed", "speed": -1e300}), "value"),
        (json!({"type": "line", "id": 1, "text": "dance"}), "value"),
        (json!({"type": "line", "id": 1, "text": "enable"}), "unavailable"),
        (json!({"type": "command", "id": 2, "command": {"name": "enable"}}), "unavailable"),
    ] {
        page.say(&message);
        assert_eq!(page.wait("error", |_| true)["problem"], problem, "{message}");
    }
    page.say(&json!({"type": "seek", "time_s": 1.0}));
    page.wait("state", |state| (state["time_s"].as_f64().unwrap() - 1.0).abs() < 0.05);
    assert!(noted(&notes, "no message of the protocol"));
    drop(page);
    assert!(monitor.stop().refused >= 20);
}

#[test]
fn a_huge_message_ends_its_page_only() {
    let dir = tempfile::tempdir().unwrap();
    let (monitor, notes) = monitor(play(&log(dir.path())), false);
    let (mut other, mut page) = (Page::open(monitor.address()), Page::open(monitor.address()));
    page.socket.send(Message::text("x".repeat(5000))).unwrap();
    assert_eq!(page.closed(), Some(1009));
    // In many small frames it is the same message.
    let mut page = Page::open(monitor.address());
    let sent = page.socket.send(Message::text("y".repeat(1 << 20)));
    assert!(sent.is_err() || page.closed().is_none_or(|code| code == 1009));
    other.say(&json!({"type": "step", "count": 3}));
    other.wait("player", |player| player["time_s"].as_f64().unwrap() > 0.0);
    assert!(noted(&notes, "at most 4096 bytes"));
}

#[test]
fn pings_and_bytes_are_counted_too() {
    let dir = tempfile::tempdir().unwrap();
    let (monitor, notes) = monitor(play(&log(dir.path())), false);
    for message in [Message::Ping(vec![1; 100].into()), Message::binary(vec![1, 2, 3])] {
        let mut page = Page::open(monitor.address());
        // Until it is sent away.
        assert!(
            (0..1_000_000).any(|_| page.socket.send(message.clone()).is_err()),
            "{message} is not counted"
        );
    }
    assert!(noted(&notes, "too many messages"));
    Page::open(monitor.address()).wait("state", |_| true);
}

#[test]
fn a_flood_is_left_out_and_a_long_one_ends() {
    let dir = tempfile::tempdir().unwrap();
    let (monitor, notes) = monitor(play(&log(dir.path())), false);
    let (mut other, mut page) = (Page::open(monitor.address()), Page::open(monitor.address()));
    for _ in 0..1000 {
        page.say(&json!({"type": "pause"}));
    }
    page.wait("error", |error| error["problem"] == "too_fast");
    for _ in 0..1_000_000 {
        if page.socket.send(Message::text("{\"type\":\"pause\"}")).is_err() {
            break;
        }
    }
    assert!(page.closed().is_none_or(|code| code == 1008));
    other.say(&json!({"type": "step", "count": 3}));
    other.wait("player", |player| player["time_s"].as_f64().unwrap() > 0.0);
    assert!(noted(&notes, "messages a second") && noted(&notes, "too many messages"));
}
