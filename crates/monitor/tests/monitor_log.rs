//! A log on pages: each has its own place; time, states and surfaces go together.
#![allow(clippy::unwrap_used)]

mod common;

use std::time::{Duration, Instant};

use common::{LONG, Page, log, monitor, noted, play};
use serde_json::{Value, json};
use tungstenite::Message;

fn time_s(message: &Value) -> f64 {
    message["time_s"].as_f64().unwrap()
}

#[test]
fn every_page_has_its_own_place() {
    let dir = tempfile::tempdir().unwrap();
    let (monitor, _) = monitor(play(&log(dir.path())), false);
    let mut pages: Vec<_> = (0..3).map(|_| Page::open(monitor.address())).collect();
    for page in &mut pages {
        let kinds: Vec<_> = (0..7).map(|_| page.next()["type"].as_str().unwrap().to_owned()).collect();
        assert_eq!(kinds, ["hello", "scene", "log", "soil", "history", "state", "player"]);
    }
    for (number, page) in pages.iter_mut().enumerate() {
        let wanted = 1.0 + number as f64;
        page.say(&json!({"type": "seek", "time_s": wanted}));
        let history = page.wait("history", |history| history["replace"] == true);
        let times: Vec<_> =
            history["time_s"].as_array().unwrap().iter().map(|time| time.as_f64().unwrap()).collect();
        assert!(times.windows(2).all(|pair| pair[0] < pair[1]));
        let state = page.wait("state", |_| true);
        // The last state that is not after it; states are 32 ms apart.
        assert!(time_s(&state) <= wanted && time_s(&state) > wanted - 0.0321, "{}", time_s(&state));
        assert_eq!(times.last(), Some(&time_s(&state)));
        let player = page.wait("player", |_| true);
        assert_eq!((time_s(&player), &player["playing"]), (wanted, &json!(false)));
    }
    // A step back and forth is where it began; beyond the ends are the ends.
    let page = &mut pages[0];
    let mut step = |count: i64| {
        page.say(&json!({"type": "step", "count": count}));
        time_s(&page.wait("state", |_| true))
    };
    let back = step(-1);
    let (here, further) = (step(1), step(1));
    assert!((here - back - 0.032).abs() < 1e-9 && (further - here - 0.032).abs() < 1e-9);
    assert_eq!(step(-100_000), 0.002);
    step(1);
    pages[1].say(&json!({"type": "seek", "time_s": 1e300}));
    assert_eq!(pages[1].wait("player", |_| true)["at_end"], true);
}

#[test]
fn a_page_learns_which_of_its_requests_were_heard() {
    let dir = tempfile::tempdir().unwrap();
    let (monitor, _) = monitor(play(&log(dir.path())), false);
    let mut page = Page::open(monitor.address());
    assert_eq!(page.wait("player", |_| true)["id"], 0);
    // Also if nothing comes of them: it stands still already.
    let requests = [
        json!({"type": "pause"}),
        json!({"type": "speed", "speed": 1.0}),
        json!({"type": "step", "count": 0}),
    ];
    for (request, id) in requests.into_iter().zip(1..) {
        let mut request = request;
        request["id"] = json!(id);
        page.say(&request);
        assert_eq!(page.wait("player", |_| true)["id"], id);
    }
}

#[test]
fn playing_goes_on_to_the_end_without_a_gap_in_the_curves() {
    let dir = tempfile::tempdir().unwrap();
    let (monitor, _) = monitor(play(&log(dir.path())), false);
    let mut page = Page::open(monitor.address());
    let log = page.wait("log", |_| true);
    page.wait("player", |_| true);
    page.say(&json!({"type": "speed", "speed": 20.0}));
    page.say(&json!({"type": "play"}));
    let mut times = vec![0.002];
    loop {
        let message = page.next();
        if message["type"] == "history" {
            assert_eq!(message["replace"], false);
            times.extend(message["time_s"].as_array().unwrap().iter().map(|time| time.as_f64().unwrap()));
        }
        if message["type"] == "player" && message["at_end"] == true {
            assert_eq!(message["playing"], false);
            break;
        }
    }
    let last = times.len() - 1;
    assert!(times[..last].windows(2).all(|pair| (pair[1] - pair[0] - 0.032).abs() < 1e-9));
    assert!((log["to_s"].as_f64().unwrap() - times[last]).abs() < 1e-9);
}

#[test]
fn what_is_no_log_is_refused() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("x.mcap");
    std::fs::write(&path, "hello").unwrap();
    let settings = || soilctl_monitor::Settings {
        listen: "127.0.0.1:0".parse().unwrap(),
        hosts: Vec::new(),
        commands: false,
        note: Box::new(|_| {}),
    };
    assert!(soilctl_monitor::Monitor::start(play(&path), settings()).is_err());
    assert!(soilctl_monitor::Monitor::start(play(&dir.path().join("none")), settings()).is_err());
}

#[test]
fn a_page_that_stops_reading_holds_up_nobody_and_is_sent_away() {
    let dir = tempfile::tempdir().unwrap();
    let (monitor, notes) = monitor(play(&log(dir.path())), false);
    let (mut deaf, mut other) = (Page::open(monitor.address()), Page::open(monitor.address()));
    let begin = Instant::now();
    let mut number = 0;
    // Every jump is answered with curves, until nothing more fits on the way; then its time runs.
    while !noted(&notes, "takes nothing any more") {
        number += 1;
        let wanted = f64::from(1 + number % 3);
        let _ = deaf.socket.send(Message::text(json!({"type": "seek", "time_s": wanted}).to_string()));
        let asked = Instant::now();
        other.say(&json!({"type": "seek", "time_s": wanted}));
        other.wait("player", |player| time_s(player) == wanted);
        assert!(asked.elapsed() < Duration::from_secs(5));
        std::thread::sleep(Duration::from_millis(10));
        assert!(begin.elapsed() < LONG);
    }
    // A page that may wait for twenty seconds is not sent away at once.
    assert!(begin.elapsed() > Duration::from_secs(20));
    assert_eq!(monitor.stop().pages, 2);
}

#[test]
fn a_log_that_stands_still_shows_signs_of_life() {
    let dir = tempfile::tempdir().unwrap();
    let (monitor, _) = monitor(play(&log(dir.path())), false);
    let mut page = Page::open(monitor.address());
    let begin = Instant::now();
    for _ in 0..2 {
        page.wait("heartbeat", |_| true);
    }
    assert!(begin.elapsed() < Duration::from_secs(30));
    drop(monitor);
}
