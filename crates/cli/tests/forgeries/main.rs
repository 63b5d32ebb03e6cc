//! Saved solutions that were tampered with: `soilctl certify` refuses each in words, or proves something true and says of what.
//! One solution is made by a small solve; each test alters a copy of it in one way.
#![allow(clippy::unwrap_used, reason = "helpers of tests")]

#[path = "../common/mod.rs"]
mod common;
mod fields;
mod file;
mod statement;

use std::sync::OnceLock;

use common::soilctl;
use serde_json::{Value, json};

/// A footing on sand over clay under ground water, with a surcharge and a load beside it: all that a statement can say has a place.
const PROBLEM: &str = r#"
title = "footing on wet ground"
surcharge_kpa = 4
default_boundary = "free"
objective = { kind = "structure", name = "footing", direction = [0, -1] }
water = { table = [[-6, -1], [6, -1]] }
soil = [
  { name = "sand", phi_deg = 35, cohesion_kpa = 5, unit_weight_kn_m3 = 18 },
  { name = "clay", phi_deg = 0, cohesion_kpa = 30, unit_weight_kn_m3 = 19 },
]
region = [
  { soil = "sand", polygon = [[-6, -2], [6, -2], [6, 0], [-6, 0]] },
  { soil = "clay", polygon = [[-6, -4], [6, -4], [6, -2], [-6, -2]] },
]
boundary = [
  { kind = "fixed", sides = ["bottom"] },
  { kind = "smooth", sides = ["left", "right"] },
  { kind = "load", line = [[2, 0], [4, 0]], pressure_kpa = 10 },
]
structure = [{ name = "footing", edge = [[-1, 0], [1, 0]], delta_deg = 20, adhesion_kpa = 2 }]
"#;

/// The solution before anybody touched it.
fn honest() -> &'static Value {
    static SOLUTION: OnceLock<Value> = OnceLock::new();
    SOLUTION.get_or_init(|| {
        let dir = tempfile::tempdir().unwrap();
        let [problem, saved] = ["p.toml", "p.json"].map(|name| dir.path().join(name));
        std::fs::write(&problem, PROBLEM).unwrap();
        let [problem, path] = [&problem, &saved].map(|path| path.to_str().unwrap());
        let budget = ["--max-gap", "0.5", "--max-elements", "1000"];
        let done = soilctl(&[&["solve", problem, "--save", path][..], &budget].concat());
        assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
        serde_json::from_str(&std::fs::read_to_string(saved).unwrap()).unwrap()
    })
}

/// What `certify` makes of a file: exit code, its answer, and what it writes to stderr.
fn certify(file: &str) -> (i32, Value, String) {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("forged.json");
    std::fs::write(&path, file).unwrap();
    let done = soilctl(&["certify", path.to_str().unwrap(), "--format", "json"]);
    let answer = serde_json::from_slice(&done.stdout).unwrap_or(Value::Null);
    (done.status.code().unwrap(), answer, String::from_utf8(done.stderr).unwrap())
}

fn forged(forge: impl Fn(&mut Value)) -> String {
    let mut solution = honest().clone();
    forge(&mut solution);
    assert_ne!(&solution, honest(), "the forgery changes nothing");
    solution.to_string()
}

/// The file is no solution.
#[track_caller]
fn no_solution(forge: impl Fn(&mut Value), words: &str) {
    let (code, answer, stderr) = certify(&forged(forge));
    assert_eq!((code, &answer), (2, &Value::Null), "{stderr}");
    assert!(stderr.contains(words), "{stderr}");
}

/// What is expected of a bound.
enum Expected {
    /// Nothing is proven, because of this.
    Refused(&'static str),
    /// The bound of the honest solution, be it claimed or not.
    AsBefore,
    /// Another bound, at least and at most so much over the honest one.
    Other(f64, f64),
}
use Expected::{AsBefore, Other, Refused};

/// Checks both bounds, that the answer says for what they hold, and that it counts as certified only if all claims are proven.
#[track_caller]
fn finds(forge: impl Fn(&mut Value), [lower, upper]: [Expected; 2], shown: &[&str]) -> Value {
    let (code, answer, stderr) = certify(&forged(forge));
    assert!(stderr.is_empty(), "{stderr}");
    let mut confirmed = true;
    for (side, expected) in [("lower", lower), ("upper", upper)] {
        let (found, before) = (&answer[side], honest()[side]["claimed"].as_f64().unwrap());
        let (proven, refusal) = (found["proven"].as_f64(), found["refusal"].as_str().unwrap_or_default());
        match expected {
            Refused(words) => assert!(proven.is_none() && refusal.contains(words), "{side}: {found}"),
            AsBefore => assert_eq!(proven, Some(before), "{side}: {refusal}"),
            Other(least, most) => {
                let ratio = proven.unwrap_or(f64::NAN) / before;
                assert!(least <= ratio && ratio <= most, "{side}: {ratio} {refusal}");
            }
        }
        confirmed &= found["confirmed"] == true;
    }
    if let [Some(lower), Some(upper)] = ["lower", "upper"].map(|side| answer[side]["proven"].as_f64()) {
        assert!(lower <= upper, "{lower} {upper}");
    }
    assert_eq!((answer["certified"] == true, code), (confirmed, i32::from(!confirmed)));
    let said: Vec<&str> =
        answer["statement"].as_array().unwrap().iter().map(|said| said["says"].as_str().unwrap()).collect();
    for words in shown {
        assert!(said.iter().any(|said| said.contains(words)), "{words:?} is not in {said:#?}");
    }
    answer
}

fn both(words: &'static str) -> [Expected; 2] {
    [Refused(words), Refused(words)]
}

const SIDES: [&str; 2] = ["lower", "upper"];

/// The soils are sand above the water, sand below it, clay.
fn soil(solution: &mut Value, region: usize) -> &mut Value {
    &mut solution["statement"]["regions"][region]["material"]
}

fn scale(value: &mut Value, by: f64) {
    *value = json!(value.as_f64().unwrap() * by);
}

/// The entry of the boundary whose condition is this, or has this name.
fn boundary<'a>(solution: &'a mut Value, condition: &str) -> &'a mut Value {
    let entries = solution["statement"]["boundaries"].as_array_mut().unwrap();
    let is =
        |entry: &&mut Value| entry["condition"] == condition || entry["condition"].get(condition).is_some();
    entries.iter_mut().find(is).unwrap()
}

#[test]
fn nothing_altered_is_certified() {
    let (code, answer, _) = certify(&honest().to_string());
    assert_eq!((code, &answer["certified"]), (0, &json!(true)));
}
