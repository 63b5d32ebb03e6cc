//! What is refused: foreign hosts and origins, what is no message, and documents that make no sense. The service goes on.
#![allow(clippy::unwrap_used)]

mod common;

use common::{Page, noted, raw, strip_load, workbench};
use serde_json::{Value, json};
use tungstenite::Message;

#[test]
fn the_page_comes_with_a_policy_and_nothing_else_comes() {
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("secret.toml");
    std::fs::write(&file, "title = \"hidden\"\n[objective]\nkind = \"load\"\n").unwrap();
    let (workbench, notes) = workbench(Some(&file));
    let at = workbench.address();
    assert!(at.ip().is_loopback());
    let get =
        |path: &str, host: &str| raw(at, format!("GET {path} HTTP/1.1\r\nHost: {host}\r\n\r\n").as_bytes());
    let ours = at.to_string();
    let page = get("/", &ours);
    assert!(page.starts_with("HTTP/1.1 200 ") && page.contains("<title>soilctl workbench"), "{page:.300}");
    assert!(
        page.contains("default-src 'none'")
            && page.contains("frame-ancestors 'none'")
            && page.contains("no-store")
    );
    assert!(get("/main.js", &ours).contains("text/javascript"));
    for (answer, status) in [
        (get("/", "evil.example"), "421"),
        (get("/main.js", "evil.example"), "421"),
        (get("/secret.toml", &ours), "404"),
        (get("/../secret.toml", &ours), "404"),
        (get("/socket", &ours), "426"),
        (raw(at, format!("POST / HTTP/1.1\r\nHost: {ours}\r\n\r\n").as_bytes()), "405"),
    ] {
        assert!(answer.starts_with(&format!("HTTP/1.1 {status} ")), "{status}: {answer:.100}");
        assert!(!answer.contains("hidden"));
    }
    for origin in ["http://evil.example", "null", "http://127.0.0.1:1"] {
        assert_eq!(Page::from_origin(at, Some(origin)).err(), Some(403), "{origin}");
    }
    assert!(noted(&notes, "evil.example") && noted(&notes, "may not use this workbench"));
    Page::open(&workbench);
}

#[test]
fn the_file_is_for_pages_with_the_token() {
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("it.toml");
    let text = "# ours\ntitle = \"kept\"\n[objective]\nkind = \"load\"\n";
    std::fs::write(&file, text).unwrap();
    let (workbench, _) = workbench(Some(&file));
    let mut stranger = Page::open(&workbench);
    let save = json!({"type": "save", "id": 1, "text": "title = \"theirs\"\n[objective]\nkind = \"load\"\n", "anyway": true});
    let refused = stranger.ask(&save, "not_saved");
    assert!(refused["error"]["words"].as_str().unwrap().contains("token"), "{refused}");
    for _ in 0..6 {
        stranger.say(&json!({"type": "authorize", "token": "0".repeat(32)}));
    }
    assert!((0..100).any(|_| stranger.socket.read().is_err()), "it is sent away");
    assert_eq!(std::fs::read_to_string(&file).unwrap(), text);
    // Without the token the page is of use all the same.
    assert!(Page::open(&workbench).check(&strip_load())["error"].is_null());

    let mut page = Page::open(&workbench);
    let opened = page.authorize(&workbench);
    assert_eq!((opened["text"].as_str(), opened["problem"]["title"].as_str()), (Some(text), Some("kept")));
    let saved = page.ask(&save, "saved");
    assert_eq!(saved["name"], "it.toml");
    assert!(std::fs::read_to_string(&file).unwrap().contains("theirs"));
    std::fs::write(&file, text).unwrap();
    let cautious =
        json!({"type": "save", "id": 2, "text": "[objective]\nkind = \"load\"\n", "anyway": false});
    assert_eq!(page.ask(&cautious, "not_saved")["changed"], true);
    let nonsense = json!({"type": "save", "id": 3, "text": "nonsense", "anyway": true});
    assert_eq!(page.ask(&nonsense, "not_saved")["changed"], false);
    assert_eq!(std::fs::read_to_string(&file).unwrap(), text);
}

#[test]
fn without_a_file_nothing_is_saved_anywhere() {
    let (workbench, _) = workbench(None);
    let mut page = Page::open(&workbench);
    page.authorize(&workbench);
    let save = json!({"type": "save", "id": 1, "text": "[objective]\nkind = \"load\"\n", "anyway": true});
    assert!(page.ask(&save, "not_saved")["error"]["words"].as_str().unwrap().contains("download"));
    // A page names no files.
    let named = json!({"type": "save", "id": 1, "text": "", "anyway": true, "path": "/tmp/x.toml"});
    assert!(page.ask(&named, "error")["error"]["words"].as_str().unwrap().contains("path"));
}

/// Documents with one thing wrong: what to change, to what.
fn hostile() -> Vec<Value> {
    let mut all =
        vec![json!(null), json!([]), json!("x"), json!({}), json!({"objective": {"kind": "dance"}})];
    let values = [
        json!(null),
        json!(-1),
        json!(1e308),
        json!(-1e308),
        json!(1e-308),
        json!(""),
        json!([]),
        json!({}),
        json!([[0, 0]]),
        json!([[0, 0], [0, 0], [0, 0]]),
        json!([[0, 0], [1, 1], [1, 0], [0, 1]]),
        json!([[0, 0], [1e300, 0], [0, 1e300]]),
        json!(vec![[0, 0]; 3000]),
        json!("clay\u{0}"),
        json!("x".repeat(100_000)),
        json!([["a", "b"]]),
        json!([1, 2, 3]),
    ];
    let places = [
        "/soil",
        "/soil/0/phi_deg",
        "/soil/0/name",
        "/soil/0/cohesion_kpa",
        "/soil/0/unit_weight_kn_m3",
        "/region",
        "/region/0/polygon",
        "/region/0/soil",
        "/boundary",
        "/boundary/0/sides",
        "/boundary/1/line",
        "/boundary/1/pressure_kpa",
        "/objective",
        "/title",
    ];
    for place in places {
        for value in &values {
            let mut it = strip_load();
            *it.pointer_mut(place).unwrap() = value.clone();
            all.push(it);
        }
    }
    all
}

#[test]
fn documents_that_make_no_sense_get_an_answer() {
    let (workbench, _) = workbench(None);
    let mut page = Page::open(&workbench);
    let mut wrong = 0;
    for (k, document) in hostile().iter().enumerate() {
        // Below the rate that pages are allowed.
        std::thread::sleep(std::time::Duration::from_millis(11));
        let answer = page.check(document);
        let (error, understood) = (&answer["error"], &answer["understood"]);
        assert_ne!(error.is_null(), understood.is_null(), "document {k}: {answer}");
        if !error.is_null() {
            wrong += 1;
            assert!(!error["words"].as_str().unwrap().is_empty());
        }
    }
    assert!(wrong > 150, "{wrong}");
    assert!(page.check(&strip_load())["error"].is_null());
}

#[test]
fn messages_that_are_none_are_refused_and_the_page_goes_on() {
    let (workbench, notes) = workbench(None);
    let mut page = Page::open(&workbench);
    for line in [
        "",
        "{",
        "[]",
        "null",
        "{\"type\":\"dance\"}",
        "{\"type\":\"check\"}",
        "{\"type\":\"solve\",\"id\":-1}",
    ] {
        page.socket.send(Message::text(line)).unwrap();
        page.wait("error");
    }
    page.socket
        .send(Message::text(format!(
            "{{\"type\":\"check\",\"id\":1,\"problem\":{}{}}}",
            "[".repeat(5000),
            "]".repeat(5000)
        )))
        .unwrap();
    page.wait("error");
    page.socket.send(Message::binary(vec![0, 1])).unwrap();
    page.wait("error");
    let mut large = Page::open(&workbench);
    let sent = large.socket.send(Message::text("x".repeat((4 << 20) + 1)));
    assert!(sent.is_err() || (0..100).any(|_| large.socket.read().is_err()));
    assert!(page.check(&strip_load())["error"].is_null());
    assert!(noted(&notes, "no message of a page"));
}
