//! What `soilctl solve` says beside bounds: what a run that proves one side knows, and values that hardly anybody means.
#![allow(clippy::unwrap_used, reason = "helpers of tests")]

mod common;

use common::{refused, soilctl};
use serde_json::Value;

const FOOTING: &str = r#"
default_boundary = "free"
objective = { kind = "structure", name = "footing", direction = [0, -1] }
soil = [{ name = "sand", phi_deg = 30, cohesion_kpa = 1, unit_weight_kn_m3 = 18, tension_kpa = 0 }]
region = [{ soil = "sand", polygon = [[0, -2.5], [5, -2.5], [5, 0], [0, 0]] }]
boundary = [{ kind = "symmetric", sides = ["left"] }, { kind = "fixed", sides = ["bottom", "right"] }]
structure = [{ name = "footing", edge = [[0, 0], [1, 0]], delta_deg = 30 }]
"#;

fn file(dir: &tempfile::TempDir, text: &str) -> String {
    let path = dir.path().join("problem.toml");
    std::fs::write(&path, text).unwrap();
    path.to_str().unwrap().to_owned()
}

/// Without any tension a stress field has no room for its proof along the free ground.
#[test]
fn a_run_that_proves_one_side_says_what_it_is_and_why_there_is_no_other() {
    let dir = tempfile::tempdir().unwrap();
    let budget = ["--max-elements", "1000", "--max-work", "3000"];
    let stderr = refused(&[&["solve", &file(&dir, FOOTING)][..], &budget].concat());
    let words = "only one side is proven: the force in kN/m is at most ";
    let rest = stderr.split(words).nth(1).unwrap_or_else(|| panic!("{stderr}"));
    let upper: f64 = rest.split(';').next().unwrap().parse().unwrap();
    // Half of a rough strip of 2 m: more than its weight alone bears, with N_gamma = 14.75, and not twice what Terzaghi's sum says.
    let [weight, cohesion] = [0.5 * 18.0 * 2.0 * 14.7543, 30.14];
    assert!(weight < upper && upper < 2.0 * (weight + cohesion), "{upper}");
    assert!(stderr.contains("no pair of bounds") && stderr.contains("no tension at all"), "{stderr}");
}

#[test]
fn values_that_hardly_anybody_means_are_told_and_kept_as_notes() {
    let dir = tempfile::tempdir().unwrap();
    let odd = FOOTING
        .replace("phi_deg = 30, cohesion_kpa = 1", "phi_deg = 0.4, cohesion_kpa = 12000")
        .replace("unit_weight_kn_m3 = 18", "unit_weight_kn_m3 = 19000")
        .replace("delta_deg = 30", "delta_deg = 0.4");
    let found = soilctl(&["solve", &file(&dir, &odd), "--check", "--format", "json"]);
    assert!(found.status.success());
    let answer: Value = serde_json::from_slice(&found.stdout).unwrap();
    let notes: Vec<&str> =
        answer["notes"].as_array().unwrap().iter().map(|note| note.as_str().unwrap()).collect();
    let stderr = String::from_utf8(found.stderr).unwrap();
    for words in [
        "is it in N/m3?",
        "0.4 rad are 22.9 deg",
        "cohesion_kpa is 12000",
        "structure \"footing\": delta_deg",
    ] {
        assert!(notes.iter().any(|note| note.contains(words)), "{words}: {notes:?}");
        assert!(stderr.contains(words), "{words}: {stderr}");
    }
    assert_eq!(notes.len(), 4);
    // A load that ends beside sand: N_c of 30 degrees is 30.14.
    let edge = r#"
        objective = {kind = "strength-reduction"}
        soil = [{name = "sand", phi_deg = 30, cohesion_kpa = 0.5, unit_weight_kn_m3 = 18}]
        region = [{soil = "sand", polygon = [[0, 0], [10, 0], [10, 4], [4, 4]]}]
        default_boundary = "fixed"
        boundary = [{kind = "free", line = [[6, 4], [4, 4], [0, 0]]}, {kind = "load", line = [[10, 4], [6, 4]], pressure_kpa = 20}]
    "#;
    let found = soilctl(&["solve", &file(&dir, edge), "--check"]);
    let stderr = String::from_utf8(found.stderr).unwrap();
    assert!(stderr.contains("ends at (6, 4) beside free ground, which bears 15.07 kPa"), "{stderr}");
    let usual = soilctl(&["solve", &file(&dir, FOOTING), "--check"]);
    assert!(usual.status.success() && usual.stderr.is_empty());
}
