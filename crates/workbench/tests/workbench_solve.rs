//! What is understood of a problem, where its faults are, and bounds as they come.
#![allow(clippy::unwrap_used)]

mod common;

use common::{Page, strip_load, workbench};
use serde_json::{Value, json};
use soilctl_app::Unwatched;
use soilctl_app::limits::Budget;
use soilctl_app::solve::{self, Request};
use soilctl_limit_analysis::Description;

fn solve(problem: &Value, id: u64, max_gap: f64) -> Value {
    json!({"type": "solve", "id": id, "problem": problem, "budget": {"max_gap": max_gap, "max_seconds": null}})
}

#[test]
fn what_is_understood_is_what_check_says() {
    let (workbench, _) = workbench(None);
    let mut page = Page::open(&workbench);
    let answer = page.check(&strip_load());
    assert!(answer["error"].is_null(), "{answer}");
    let understood = &answer["understood"];
    let kinds: Vec<_> =
        understood["sides"].as_array().unwrap().iter().map(|side| side["kind"].as_str().unwrap()).collect();
    assert_eq!(kinds.iter().filter(|kind| **kind == "far").count(), 3);
    assert!(kinds.contains(&"free"));
    assert_eq!(understood["loads"][0]["pressure"], json!([1.0, 1.0]));
    assert_eq!(understood["loads"][0]["live"], true);
    assert_eq!(answer["answer"]["quantity"], "load_factor");
    // The text is the same problem again.
    let toml = answer["toml"].as_str().unwrap();
    let read = page.ask(&json!({"type": "read", "id": 3, "text": toml}), "read");
    let [again, first] = [&read["problem"], &strip_load()]
        .map(|it| serde_json::from_value::<Description>(it.clone()).unwrap());
    assert_eq!(again, first);
}

#[test]
fn what_the_page_has_no_field_for_survives() {
    let text =
        std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/problems/cut_cases.toml"))
            .unwrap();
    let (workbench, _) = workbench(None);
    let mut page = Page::open(&workbench);
    let problem = page.ask(&json!({"type": "read", "id": 1, "text": text}), "read")["problem"].take();
    let toml = page.check(&problem)["toml"].take();
    assert_eq!(
        Description::from_toml(toml.as_str().unwrap()).unwrap(),
        Description::from_toml(&text).unwrap()
    );
}

#[test]
fn faults_and_notes_know_their_place() {
    let (workbench, _) = workbench(None);
    let mut page = Page::open(&workbench);
    let mut changed = |place: &str, value: Value| {
        let mut it = strip_load();
        *it.pointer_mut(place).unwrap() = value;
        page.check(&it)
    };
    let error = changed("/soil/0/phi_deg", json!(95))["error"].take();
    assert_eq!(
        (&error["entries"][0]["section"], &error["entries"][0]["index"], &error["key"]),
        (&json!("soil"), &json!(0), &json!("phi_deg"))
    );
    let error = changed("/region/0/soil", json!("sand"))["error"].take();
    assert_eq!((&error["entries"][0]["section"], &error["key"]), (&json!("region"), &json!("soil")));
    let region = json!({"soil": "clay", "polygon": [[0, -1], [9, -1], [9, 1]]});
    let error = changed("/region", json!([strip_load()["region"][0], region]))["error"].take();
    assert_eq!(error["entries"].as_array().unwrap().len(), 2, "{error}");
    assert_eq!(error["points"].as_array().unwrap().len(), 1, "{error}");
    let error = changed("/boundary/1/line", json!([[-1, -1], [1, -1]]))["error"].take();
    assert_eq!(
        (&error["entries"][0]["section"], &error["entries"][0]["index"]),
        (&json!("boundary"), &json!(1))
    );
    let error = changed("/default_boundary", json!(null))["error"].take();
    assert_eq!(
        (&error["entries"][0]["section"], &error["key"]),
        (&json!("problem"), &json!("default_boundary")),
        "{error}"
    );
    let notes = changed("/soil/0/unit_weight_kn_m3", json!(1800))["notes"].take();
    assert_eq!(
        (&notes[0]["entries"][0]["section"], &notes[0]["key"]),
        (&json!("soil"), &json!("unit_weight_kn_m3"))
    );
}

#[test]
fn bounds_come_level_by_level_and_are_those_of_the_use_case() {
    let (workbench, _) = workbench(None);
    let mut page = Page::open(&workbench);
    page.say(&solve(&strip_load(), 5, 0.03));
    let (mut levels, mut last) = (0, [f64::NEG_INFINITY, f64::INFINITY]);
    let solved = loop {
        let message = page.next();
        match message["type"].as_str().unwrap() {
            "proven" => {
                levels += 1;
                let now = [
                    message["lower"].as_f64().unwrap_or(last[0]),
                    message["upper"].as_f64().unwrap_or(last[1]),
                ];
                assert!(now[0] >= last[0] && now[1] <= last[1], "{message}");
                last = now;
            }
            "solved" => break message,
            other => assert!(["begun", "heartbeat"].contains(&other), "{message}"),
        }
    };
    assert!(levels > 0);
    let description: Description = serde_json::from_value(strip_load()).unwrap();
    let budget = Budget { max_gap: 0.03, ..Budget::default() };
    let found = solve::of(description, &Request { budget, ..Request::default() }, &Unwatched).unwrap();
    for (key, value) in [("lower", found.answer.lower), ("upper", found.answer.upper)] {
        assert_eq!(solved["answer"][key].as_f64().unwrap().to_bits(), value.to_bits(), "{key}");
    }
    let exact = 10.0 * (2.0 + std::f64::consts::PI);
    assert!(found.answer.lower <= exact && exact <= found.answer.upper);
    let field = &solved["field"];
    let triangles = field["triangles"].as_array().unwrap();
    assert_eq!(triangles.len(), field["velocities"].as_array().unwrap().len());
    assert_eq!(triangles.len() as u64, solved["answer"]["upper_elements"].as_u64().unwrap());
}

#[test]
fn a_run_is_stopped_and_another_one_follows() {
    let (workbench, _) = workbench(None);
    let mut page = Page::open(&workbench);
    page.say(&solve(&strip_load(), 1, 1e-6));
    page.wait("proven");
    // While it runs, the page checks.
    assert!(page.check(&strip_load())["error"].is_null());
    page.say(&json!({"type": "stop"}));
    let ended = loop {
        let message = page.next();
        if message["type"] == "solved" || message["type"] == "failed" {
            break message;
        }
    };
    assert_eq!(ended["id"], 1);
    page.say(&solve(&json!({"objective": {"kind": "load"}}), 2, 0.1));
    assert!(!page.wait("failed")["error"]["words"].as_str().unwrap().is_empty());
    page.say(&solve(&strip_load(), 3, -1.0));
    assert!(page.wait("failed")["error"]["words"].as_str().unwrap().contains("max_gap"));
    page.say(&solve(&strip_load(), 4, 0.1));
    assert_eq!(page.wait("solved")["id"], 4);
}
