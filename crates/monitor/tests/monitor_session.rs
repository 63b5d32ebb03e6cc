//! A live session on pages: states, commands with and without the right, a session that ends and another that begins.
#![allow(clippy::unwrap_used)]

mod common;

use common::{Page, monitor, noted, session};
use serde_json::json;
use soilctl_monitor::Source;

#[test]
fn commands_need_the_token() {
    let dir = tempfile::tempdir().unwrap();
    let socket = dir.path().join("live");
    let host = session(&socket, None);
    let (monitor, notes) = monitor(Source::Session(socket), true);
    let token = monitor.token().unwrap().to_owned();
    assert!(token.len() == 32 && monitor.url().ends_with(&format!("/#token={token}")));
    let mut page = Page::open(monitor.address());
    assert_eq!(page.next()["type"], "hello");
    let scene = page.next();
    assert!(scene["urdf"].as_str().unwrap().contains("<robot") && scene["commands"] == true);
    assert_eq!(page.line(1, "enable")["problem"], "forbidden");
    page.say(&json!({"type": "authorize", "token": "0".repeat(32)}));
    assert_eq!(page.wait("error", |_| true)["problem"], "forbidden");
    assert_eq!(page.line(2, "enable")["problem"], "forbidden");
    page.say(&json!({"type": "authorize", "token": token}));
    page.wait("authorized", |_| true);
    assert_eq!(page.line(3, "enable")["type"], "ack");
    // The same in the operators' own words.
    page.say(&json!({"type": "command", "id": 4, "command": {"name": "plan_index", "index": 60_000}}));
    let answer = page.wait("error", |error| error["id"] == 4);
    assert_eq!(answer["problem"], "refused");
    assert_eq!(page.line(5, "advance 0.5")["type"], "ack");
    page.wait("state", |state| state["mode"] == "ready" && state["time_s"].as_f64().unwrap() >= 0.5);
    // The right is the page's, not the monitor's.
    let mut other = Page::open(monitor.address());
    assert_eq!(other.line(1, "disable")["problem"], "forbidden");
    for _ in 0..6 {
        other.say(&json!({"type": "authorize", "token": "guess"}));
    }
    assert_eq!(other.closed(), Some(1008));
    assert!(noted(&notes, "the token is wrong") && noted(&notes, "too many wrong tokens"));
    assert_eq!(page.line(6, "end")["type"], "ack");
    host.wait().unwrap();
}

#[test]
fn without_the_flag_there_are_no_commands() {
    let dir = tempfile::tempdir().unwrap();
    let socket = dir.path().join("live");
    let host = session(&socket, None);
    let (monitor, _) = monitor(Source::Session(socket), false);
    assert_eq!(monitor.token(), None);
    let mut page = Page::open(monitor.address());
    page.say(&json!({"type": "authorize", "token": ""}));
    assert_eq!(page.wait("error", |_| true)["problem"], "unavailable");
    assert_eq!(page.line(1, "emergency_stop")["problem"], "unavailable");
    page.say(&json!({"type": "play"}));
    assert_eq!(page.wait("error", |_| true)["problem"], "unavailable");
    host.stopper().stop();
    host.wait().unwrap();
}

#[test]
fn a_session_that_ends_is_said_and_the_next_one_is_found() {
    let dir = tempfile::tempdir().unwrap();
    let socket = dir.path().join("live");
    let host = session(&socket, None);
    let (monitor, _) = monitor(Source::Session(socket.clone()), false);
    let mut pages = [Page::open(monitor.address()), Page::open(monitor.address())];
    for page in &mut pages {
        page.wait("state", |_| true);
    }
    host.stopper().stop();
    host.wait().unwrap();
    for page in &mut pages {
        let link = page.wait("link", |link| link["connected"] == false);
        assert!(!link["message"].as_str().unwrap().is_empty());
    }
    // A page that comes meanwhile is told, too.
    Page::open(monitor.address()).wait("link", |link| link["connected"] == false);
    let host = session(&socket, None);
    for page in &mut pages {
        page.wait("hello", |_| true);
        page.wait("scene", |_| true);
        page.wait("state", |_| true);
    }
    host.stopper().stop();
    host.wait().unwrap();
    assert_eq!(monitor.stop().pages, 3);
}

#[test]
fn the_sand_is_where_the_arm_first_touches_it() {
    let dir = tempfile::tempdir().unwrap();
    let socket = dir.path().join("live");
    let host = session(&socket, None);
    let (monitor, _) = monitor(Source::Session(socket), true);
    let mut page = Page::open(monitor.address());
    let stated = page.wait("scene", |_| true)["sandbox"]["surface_z_m"].as_f64().unwrap();
    page.say(&json!({"type": "authorize", "token": monitor.token().unwrap()}));
    page.wait("authorized", |_| true);
    for (id, line) in ["enable", "start campaign"].iter().enumerate() {
        assert_eq!(page.line(id as u64 + 1, line)["type"], "ack", "{line}");
    }
    // Answered when the time is over; the event comes before.
    page.say(&json!({"type": "line", "id": 3, "text": "advance 20"}));
    let found = page.wait("event", |event| event["kind"] == "surface_found")["value"].as_f64().unwrap();
    assert!(found != stated && (found - stated).abs() < 0.02, "{found} {stated}");
    host.stopper().stop();
    host.wait().unwrap();
    // Whoever comes later is told so at once.
    let scene = Page::open(monitor.address()).wait("scene", |_| true);
    assert_eq!(scene["sandbox"]["surface_z_m"].as_f64().unwrap(), found);
}
