//! `soilctl bound` and `soilctl certify` as a user runs them.
#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use assert_cmd::Command;
use serde_json::Value;

fn soilctl(args: &[&str]) -> (i32, Value, String) {
    let output =
        Command::cargo_bin("soilctl").unwrap().args(args).args(["--format", "json"]).output().unwrap();
    let json = serde_json::from_slice(&output.stdout).unwrap_or(Value::Null);
    (output.status.code().unwrap(), json, String::from_utf8(output.stderr).unwrap())
}

const PLATE: [&str; 9] = ["bound", "--alpha", "90", "--phi", "30", "--delta", "0", "--max-elements", "1500"];

#[test]
fn bounds_are_proven_saved_and_proven_again() {
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("plate.json");
    let file = file.to_str().unwrap();
    let (code, answer, _) = soilctl(&[&PLATE[..], &["--max-gap", "0.2", "--save", file]].concat());
    assert_eq!(code, 0);
    assert_eq!(answer["schema"], "soilctl.bound/1");
    assert_eq!(answer["certified"], true);
    let (lower, upper) = (answer["lower"].as_f64().unwrap(), answer["upper"].as_f64().unwrap());
    assert!(lower <= 8.0 / 3.0 && 8.0 / 3.0 <= upper, "{lower} {upper}");
    let (code, proof, _) = soilctl(&["certify", file]);
    assert_eq!(code, 0);
    assert_eq!(proof["certified"], true);
    // The plate is at right angles and smooth: K = 2 F.
    assert!((2.0 * proof["lower"]["proven"].as_f64().unwrap() - lower).abs() < 1e-12);

    let mut saved: Value = serde_json::from_slice(&std::fs::read(file).unwrap()).unwrap();
    saved["upper"]["claimed"] = Value::from(1.0);
    std::fs::write(file, saved.to_string()).unwrap();
    let (code, proof, _) = soilctl(&["certify", file]);
    assert_eq!(code, 1);
    assert_eq!(proof["upper"]["confirmed"], false);
    assert_eq!(proof["lower"]["confirmed"], true);
}

#[test]
fn a_budget_that_ends_first_is_exit_code_3_with_the_best_bounds() {
    let (code, answer, _) = soilctl(&[&PLATE[..], &["--max-gap", "1e-9"]].concat());
    assert_eq!(code, 3);
    assert_eq!(answer["ended"], "elements");
    assert_eq!(answer["certified"], true);
}

#[test]
fn forces_are_coefficients_in_newtons() {
    let sizes = ["--depth", "0.1", "--width", "0.5", "--density", "1600", "--max-gap", "0.2"];
    let (_, answer, _) = soilctl(&[&PLATE[..], &sizes].concat());
    let newtons = 0.5 * 1600.0 * 9.80665 * 0.1 * 0.1 * 0.5;
    let force = answer["force_lower_n"].as_f64().unwrap();
    assert!((force / (newtons * answer["lower"].as_f64().unwrap()) - 1.0).abs() < 1e-12);
}

#[test]
fn bad_input_is_refused_in_words() {
    for (args, words) in [
        (["bound", "--alpha", "90", "--phi", "30", "--delta", "31"].as_slice(), "interface friction"),
        (["bound", "--alpha", "90", "--phi", "0", "--delta", "0"].as_slice(), "friction angle"),
        (["bound", "--alpha", "90", "--phi", "30", "--delta", "0", "--cohesion", "5"].as_slice(), "--depth"),
        (["bound", "--alpha", "90", "--phi", "30", "--delta", "0", "--max-gap", "0"].as_slice(), "above 0"),
        (["certify", "no-such-file.json"].as_slice(), "no-such-file.json"),
    ] {
        let (code, _, stderr) = soilctl(args);
        assert_eq!(code, 2, "{args:?}");
        assert!(stderr.contains(words), "{args:?}: {stderr}");
    }
}
