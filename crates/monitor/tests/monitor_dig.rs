//! Sessions that are dug by hand: their page, who may lead and choose, and a log for each soil.
#![allow(clippy::unwrap_used, reason = "tests")]

mod common;

use common::{LONG, Page, monitor, play, raw, session};
use serde_json::{Value, json};
use soilctl_live::Client;
use soilctl_live::protocol::ServerMessage;
use soilctl_monitor::{Dig, DigSettings, MonitorError, Settings, Source};
use soilctl_session::{info, replay};

fn settings() -> Settings {
    Settings {
        listen: "127.0.0.1:0".parse().unwrap(),
        hosts: Vec::new(),
        commands: true,
        note: Box::new(|_| {}),
    }
}

fn status(answer: &str) -> &str {
    answer.split_whitespace().nth(1).unwrap_or_default()
}

/// The answer to a message with an id.
fn ask(page: &mut Page, message: &Value) -> Value {
    page.say(message);
    loop {
        let answer = page.next();
        if answer["id"] == message["id"] {
            return answer;
        }
    }
}

fn follow(id: u64, hand: u64, plate: &Value, up_m: f64) -> Value {
    let z_m = plate["z_m"].as_f64().unwrap() + up_m;
    json!({"type": "command", "id": id, "command": {"name": "follow", "x_m": plate["x_m"], "y_m": plate["y_m"], "z_m": z_m,
        "tool_angle_deg": plate["tool_angle_deg"], "hand": hand}})
}

#[test]
fn soils_follow_one_another_and_each_has_a_log() {
    let dir = tempfile::tempdir().unwrap();
    let wanted = DigSettings {
        soil: "nevada_fine".to_owned(),
        seed: 1,
        log: dir.path().join("dig.mcap"),
        socket: dir.path().join("live"),
        device: None,
    };
    let none = Dig::start(DigSettings { soil: "cheese".to_owned(), ..wanted.clone() }, settings());
    assert!(matches!(none.err(), Some(MonitorError::Campaign(_))));
    let nowhere = DigSettings { log: dir.path().join("none").join("dig.mcap"), ..wanted.clone() };
    assert!(matches!(Dig::start(nowhere, settings()).err(), Some(MonitorError::File { .. })));

    let dig = Dig::start(wanted.clone(), settings()).unwrap();
    let (url, token) = {
        let url = dig.url();
        let token = url.split("#token=").nth(1).unwrap().to_owned();
        (url, token)
    };
    assert!(url.contains("/dig#token=") && token.len() == 32, "{url}");
    let mut page = Page::open(dig.address());
    let scene = page.wait("scene", |_| true);
    assert!(
        scene["hand"]["force_n"].as_f64().unwrap() > 1.0 && scene["hand"]["lease_s"] == 0.2,
        "{}",
        scene["hand"]
    );
    let told = page.wait("dig", |_| true);
    assert!(told["soil"] == "nevada_fine" && told["log"].as_str().unwrap().ends_with("dig.mcap"), "{told}");
    assert!(told["soils"].as_array().unwrap().iter().any(|soil| soil["gravity_m_s2"] == 1.62));

    // Who does not know the token chooses nothing and leads nothing; what is none is said to be none.
    let choose = |id: u64, soil: &str| json!({"type": "choose_soil", "id": id, "soil": soil});
    assert_eq!(ask(&mut page, &choose(1, "mars_drift"))["problem"], "forbidden");
    page.say(&json!({"type": "authorize", "token": token}));
    page.wait("authorized", |_| true);
    let answer = ask(&mut page, &choose(2, "cheese"));
    assert!(
        answer["problem"] == "value" && answer["message"].as_str().unwrap().contains("moon_0_15cm"),
        "{answer}"
    );

    assert_eq!(page.line(3, "enable")["type"], "ack");
    let plate = page.wait("state", |state| state["mode"] == "ready")["plate"].clone();
    assert_eq!(ask(&mut page, &follow(4, 1, &plate, 0.01))["type"], "ack");
    assert_eq!(ask(&mut page, &follow(5, 2, &plate, 0.01))["problem"], "refused");
    for (id, target) in [(6, json!(1e308)), (7, json!("up")), (8, json!(null))] {
        let mut message = follow(id, 1, &plate, 0.0);
        message["command"]["z_m"] = target.clone();
        let answer = ask(&mut page, &message);
        assert_eq!(answer["type"] == "ack", target.is_number(), "{answer}");
    }
    page.wait("event", |event| event["kind"] == "trajectory_ended/follow/let_go");

    page.say(&choose(9, "moon_0_15cm"));
    let told = page.wait("dig", |told| told["soil"] == "moon_0_15cm");
    assert_eq!((told["dug"].as_array().unwrap().len(), &told["problem"]), (1, &json!("")), "{told}");
    page.wait("scene", |scene| scene["soil"].as_str().unwrap().contains("Lunar"));
    page.wait("state", |state| state["mode"] == "off");
    let (dug, _) = dig.stop();
    assert_eq!(
        dug.iter().map(|session| session.soil.as_str()).collect::<Vec<_>>(),
        ["nevada_fine", "moon_0_15cm"]
    );
    for session in &dug {
        assert!(session.problems.is_empty() && session.steps > 0, "{session:?}");
        assert_eq!(info(&session.log).unwrap().problems, Vec::<String>::new());
        assert!(replay(&session.log, 0).unwrap().is_identical(), "{session:?}");
    }
    assert_ne!(dug[0].log, dug[1].log);

    // A session that somebody ends is the end.
    let dig = Dig::start(wanted, settings()).unwrap();
    let mut client = Client::connect(&dir.path().join("live")).unwrap();
    client.commander().unwrap().send(soilctl_live::protocol::Command::End).unwrap();
    while !matches!(client.next(LONG).unwrap(), Some(ServerMessage::End { .. })) {}
    while !dig.is_over() {
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
}

#[test]
fn a_session_has_the_page_and_a_log_has_none() {
    let dir = tempfile::tempdir().unwrap();
    let socket = dir.path().join("live");
    let host = session(&socket, None);
    let (shown, _) = monitor(Source::Session(socket), true);
    let get = |address: std::net::SocketAddr, path: &str| {
        raw(
            address,
            format!("GET {path} HTTP/1.1\r\nHost: {address}\r\nConnection: close\r\n\r\n").as_bytes(),
        )
    };
    let page = get(shown.address(), "/dig");
    assert!(status(&page) == "200" && page.contains("script-src 'self'") && page.contains("/dig/main.js"));
    assert_eq!(status(&get(shown.address(), "/dig/main.js")), "200");
    for path in ["/dig/../dig", "/dig/none.js", "/digger"] {
        assert_eq!(status(&get(shown.address(), path)), "404", "{path}");
    }
    // Its soil is that of its plan.
    let mut page = Page::open(shown.address());
    page.say(&json!({"type": "authorize", "token": shown.token().unwrap()}));
    page.wait("authorized", |_| true);
    assert_eq!(
        ask(&mut page, &json!({"type": "choose_soil", "id": 1, "soil": "mars_drift"}))["problem"],
        "value"
    );
    host.stopper().stop();
    host.wait().unwrap();
    let (played, _) = monitor(play(&common::log(dir.path())), false);
    assert_eq!(status(&get(played.address(), "/dig")), "404");
}
