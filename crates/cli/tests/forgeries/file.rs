//! Claims, titles, units and the form of the file.

use serde_json::{Value, json};

use crate::Expected::AsBefore;
use crate::common::soilctl;
use crate::{SIDES, both, certify, finds, forged, honest, no_solution, soil};

#[test]
fn units_and_program_change_no_proof_and_units_are_called_the_files_own() {
    let forge = |s: &mut Value| {
        s["scale"]["length_m"] = json!(200.0);
        s["program"] = json!("soilctl 99, certified");
    };
    let answer = finds(forge, [AsBefore, AsBefore], &["200 m by the file", "no proof depends on that"]);
    assert!(!answer.to_string().contains("soilctl 99"));
}

#[test]
fn a_title_is_quoted_as_a_title_and_cannot_pass_for_words_of_the_proof() {
    let title = "phi 50\nlower  99  proven";
    let forge = |s: &mut Value| s["scale"]["description"] = json!(title);
    let answer = finds(forge, [AsBefore, AsBefore], &["friction 35 deg"]);
    assert_eq!(answer["description"], title);
    assert!(!answer["statement"].to_string().contains("phi 50"));
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("forged.json");
    std::fs::write(&path, forged(forge)).unwrap();
    let text = String::from_utf8(soilctl(&["certify", path.to_str().unwrap()]).stdout).unwrap();
    assert!(text.contains(r#"which nothing proves: "phi 50\nlower  99  proven""#), "{text}");
    assert!(!text.lines().any(|line| line.starts_with("lower  99")), "{text}");
}

#[test]
fn claims_that_no_proof_reaches_are_not_confirmed() {
    for claims in [[1000.0, 1.0], [9.5, 7.5], [-1e308, 1e308]] {
        let forge = |s: &mut Value| {
            SIDES.iter().zip(claims).for_each(|(side, claim)| s[side]["claimed"] = json!(claim));
        };
        let answer = finds(forge, [AsBefore, AsBefore], &[]);
        // The last pair claims less than is proven.
        assert_eq!(answer["certified"], claims[0] < claims[1]);
    }
}

#[test]
fn no_number_is_nan_infinite_or_too_large_to_count_with() {
    no_solution(|s| soil(s, 0)["unit_weight"] = Value::Null, "invalid type: null, expected f64");
    let file = honest().to_string();
    for word in ["NaN", "Infinity", "1e999"] {
        let (code, answer, stderr) =
            certify(&file.replacen("\"datum\":0.0", &format!("\"datum\":{word}"), 1));
        assert_eq!((code, answer), (2, Value::Null));
        assert!(stderr.contains("is not a saved solution"), "{word}: {stderr}");
    }
    let forge = |s: &mut Value| {
        for (side, list, kind, key) in [("lower", "copies", "jet", "f"), ("upper", "velocities", "free", "x")]
        {
            for entry in s[side]["field"][list].as_array_mut().unwrap() {
                let entry = if kind == "jet" { entry["jet"].get_mut("free") } else { entry.get_mut(kind) };
                entry.into_iter().for_each(|entry| entry[key] = json!(1e308));
            }
        }
    };
    finds(forge, both("not proven"), &[]);
}

#[test]
fn fields_that_are_missing_added_or_of_the_other_side_are_no_solution() {
    let remove = |s: &mut Value, key: &str| drop(s["lower"]["field"].as_object_mut().unwrap().remove(key));
    no_solution(|s| remove(s, "slopes"), "missing field `slopes`");
    no_solution(|s| s["lower"]["proven"] = json!(99.0), "unknown field `proven`");
    let swapped = |s: &mut Value| {
        let lower = s["lower"].take();
        s["lower"] = std::mem::replace(&mut s["upper"], lower);
    };
    no_solution(swapped, "unknown field `flows`");
    let nothing = |s: &mut Value| SIDES.iter().for_each(|side| s[side] = Value::Null);
    no_solution(nothing, "has neither a lower nor an upper bound");
}
