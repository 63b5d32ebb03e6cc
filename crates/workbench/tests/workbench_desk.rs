//! The workbench without a server: the same answers, one after another; certificates and calculations.
#![allow(clippy::unwrap_used)]

mod common;

use std::sync::Mutex;

use common::{Page, strip_load, workbench};
use serde_json::{Value, json};
use soilctl_workbench::Desk;

/// What the desk of the test that holds the lock has told.
static TOLD: Mutex<Vec<Value>> = Mutex::new(Vec::new());
static ONE: Mutex<()> = Mutex::new(());

fn tell(message: String) {
    TOLD.lock().unwrap().push(serde_json::from_str(&message).unwrap());
}

/// What is told after a message.
fn ask(desk: &mut Desk, message: &Value) -> Vec<Value> {
    TOLD.lock().unwrap().clear();
    desk.obey(&message.to_string());
    TOLD.lock().unwrap().clone()
}

fn last(desk: &mut Desk, message: &Value) -> Value {
    ask(desk, message).pop().unwrap()
}

fn solve(id: u64) -> Value {
    json!({"type": "solve", "id": id, "problem": strip_load(), "budget": {"max_gap": 0.1, "max_seconds": null}})
}

#[test]
fn a_desk_answers_what_a_server_does() {
    let _one = ONE.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
    let (workbench, _) = workbench(None);
    let mut page = Page::open(&workbench);
    let mut desk = Desk::open(tell);
    assert_eq!(TOLD.lock().unwrap().last().unwrap()["type"], "hello");
    let check = json!({"type": "check", "id": 7, "problem": strip_load()});
    assert_eq!(last(&mut desk, &check), page.ask(&check, "checked"));
    let read = json!({"type": "read", "id": 8, "text": "title = 3"});
    assert_eq!(last(&mut desk, &read), page.ask(&read, "read"));
    let here = ask(&mut desk, &solve(9));
    assert_eq!(here[0]["type"], "begun");
    assert!(here.iter().any(|message| message["type"] == "proven"));
    let [here, there] = [here.last().unwrap(), &page.ask(&solve(9), "solved")].map(|it| it.clone());
    for key in ["lower", "upper", "work", "upper_elements", "results"] {
        assert_eq!(here["answer"][key], there["answer"][key], "{key}");
    }
    assert_eq!(here["field"], there["field"]);
    for kind in ["certificate", "report"] {
        let mut message = json!({"type": kind, "id": 10});
        if kind == "report" {
            message["name"] = json!("strip.toml");
        }
        assert_eq!(last(&mut desk, &message), page.ask(&message, kind));
    }
    // There is neither a file nor a token.
    assert_eq!(last(&mut desk, &json!({"type": "authorize", "token": "x"}))["text"], Value::Null);
    let saved = last(&mut desk, &json!({"type": "save", "id": 11, "text": "", "anyway": true}));
    assert_eq!(saved["type"], "not_saved");
    assert!(ask(&mut desk, &json!({"type": "stop"})).is_empty());
    assert_eq!(last(&mut desk, &json!({"type": "nonsense"}))["type"], "error");
}

#[test]
fn a_certificate_is_proven_by_its_fields_and_not_by_its_claim() {
    let _one = ONE.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
    let mut desk = Desk::open(tell);
    let none = last(&mut desk, &json!({"type": "certificate", "id": 1}));
    assert!(none["error"]["words"].as_str().unwrap().contains("solve"), "{none}");
    let none = last(&mut desk, &json!({"type": "report", "id": 1, "name": "x.toml"}));
    assert!(none["html"].is_null() && !none["error"].is_null());
    let bounds = last(&mut desk, &solve(2))["answer"].take();
    let kept = last(&mut desk, &json!({"type": "certificate", "id": 3}))["files"][0].take();
    let text = kept["text"].as_str().unwrap();
    let mut certify =
        |text: &str| last(&mut desk, &json!({"type": "certify", "id": 4, "name": "c.json", "text": text}));
    let found = certify(text);
    assert_eq!(found["sha256"], kept["sha256"]);
    assert_eq!(found["answer"]["certified"], true);
    // One unit of load is 1 kPa, so the proof is of the bounds themselves.
    assert_eq!(found["answer"]["lower"]["proven"], bounds["lower"]);
    let mut other: Value = serde_json::from_str(text).unwrap();
    other["upper"]["claimed"] = json!(other["upper"]["claimed"].as_f64().unwrap() * 0.5);
    let found = certify(&other.to_string());
    assert_eq!(
        (&found["answer"]["certified"], &found["answer"]["upper"]["confirmed"]),
        (&json!(false), &json!(false))
    );
    assert!(!certify("{}")["error"]["words"].as_str().unwrap().is_empty());
    let html = last(&mut desk, &json!({"type": "report", "id": 5, "name": "strip.toml"}))["html"].take();
    let html = html.as_str().unwrap();
    for words in [kept["sha256"].as_str().unwrap(), "Assumptions and limits", "Checked by, date", "clay"] {
        assert!(html.contains(words), "{words}");
    }
    assert!(!html.contains("plotly"));
}

/// What a level line through the ground carries is the weight above it and the load, since smooth sides take nothing of either: the field balances.
#[test]
fn a_section_line_carries_what_is_above_it() {
    let _one = ONE.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
    let mut desk = Desk::open(tell);
    let line = |y: f64| json!({"type": "probe", "id": 6, "from": [-8, y], "to": [8, y]});
    let none = last(&mut desk, &line(-3.0));
    assert!(none["error"]["words"].as_str().unwrap().contains("solve"), "{none}");
    let mut problem = strip_load();
    problem["boundary"][0] = json!({"kind": "smooth", "sides": ["left", "right", "bottom"]});
    let budget = json!({"max_gap": 0.1, "max_seconds": null});
    let bounds = last(&mut desk, &json!({"type": "solve", "id": 2, "problem": problem, "budget": budget}));
    let lower = bounds["answer"]["lower"].as_f64().unwrap();
    for y in [-5.5, -3.0, -0.7] {
        let shown = last(&mut desk, &line(y))["shown"].take();
        let weight = 18.0 * -y * 16.0 + 2.0 * lower;
        let normal = shown["normal_kn_per_m"].as_f64().unwrap();
        assert!((normal / weight - 1.0).abs() < 0.01, "{y}: {normal} {weight}");
        assert_eq!(shown["outside_m"], 0.0);
        // Clay that yields nowhere beyond its cohesion.
        for place in shown["places"].as_array().unwrap() {
            let [major, minor] = ["major_kpa", "minor_kpa"].map(|key| place["stress"][key].as_f64().unwrap());
            assert!(major - minor <= 20.0 * (1.0 + 1e-6), "{place}");
        }
    }
    // A line that leaves the ground says by how much, and one beside it is refused.
    let shown =
        last(&mut desk, &json!({"type": "probe", "id": 6, "from": [0, -4], "to": [0, 4]}))["shown"].take();
    assert!((shown["outside_m"].as_f64().unwrap() - 4.0).abs() < 0.05, "{}", shown["outside_m"]);
    for (from, to) in [([20, 1], [30, 1]), ([1, 1], [1, 1])] {
        let told = last(&mut desk, &json!({"type": "probe", "id": 6, "from": from, "to": to}));
        assert!(told["error"]["words"].as_str().unwrap().len() > 20);
    }
}
