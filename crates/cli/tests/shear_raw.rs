//! `soilctl shear` from outside: raw records and figures.

mod common;

use common::shear::{STROKE, data, list, number, raw, says, shear};
use common::{json, refused};
use serde_json::Value;

#[test]
fn raw_records_give_their_truth_back() {
    let (code, answer) = raw(&["--soil-name", "synthetic", "--stress", "800"]);
    let soil = &answer["soils"][0];
    assert_eq!((code, &soil["soil"]), (0, &"synthetic".into()));
    for point in list(&soil["points"]) {
        let below = (34_474.0 / number(&point["normal_stress_pa"])).log10().max(0.0);
        assert!((number(&point["friction_angle_deg"]) - 32.0 - 6.0 * below).abs() < 0.3, "{point}");
    }
    assert!((number(&soil["slope_floor"]["floor_deg"]) - 32.0).abs() < 0.2);
    assert!((number(&soil["slope_floor"]["slope_deg_per_decade"]) - 6.0).abs() < 0.3);
    assert!(soil["best"].as_str().unwrap().starts_with("the slope and floor"));
    let records = &answer["raw"];
    assert!((number(&records["machine_friction_n"]) - 0.10).abs() < 0.01);
    assert_eq!((list(&records["loads"]).len(), list(&records["runs"]).len()), (7, 19));
    assert_eq!(records["loads"][0]["dropped"], serde_json::json!(["0.4473kg-d"]));
    assert!((number(&records["runs"][0]["peak_displacement_m"]) - 0.002).abs() < 0.000_45);

    let (_, small) = raw(&["--box-area", "0.00178"]);
    let stress = |answer: &Value| number(&answer["soils"][0]["points"][0]["normal_stress_pa"]);
    assert!((stress(&small) / stress(&answer) - 2.0).abs() < 1e-9);
    let (_, without) = json(&["shear", "--raw", &data("direct_shear_raw/runs.csv"), "--bias", "0.85"]);
    assert!(without["raw"]["machine_friction_n"].is_null());
    says(without["warnings"][0].as_str().unwrap(), &["no friction loop"]);
}

#[test]
fn bad_records_and_options_are_refused() {
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("runs.csv");
    let path = file.to_str().unwrap();
    let header = "run_id,load_kg,displacement_mm,shear_force_n\n";
    std::fs::write(&file, format!("{header}a,1,0,x\n")).unwrap();
    says(&refused(&["shear", "--raw", path]), &["runs.csv, line 2, column `shear_force_n`"]);
    std::fs::write(&file, format!("{header}a,1,0,0\na,1,1,5\n")).unwrap();
    says(&refused(&["shear", "--raw", path]), &["runs.csv, run `a`", "at least 3"]);
    let runs = data("direct_shear_raw/runs.csv");
    says(&refused(&["shear", "--raw", &runs, "--box-area", "0"]), &["area_m2 is 0 m2"]);
    says(&refused(&["shear", "--raw", &runs, "--loop", path]), &["runs.csv", "direction"]);
    says(&refused(&["shear", "--raw", &runs, &runs]), &["cannot be used with"]);
    says(
        &refused(&["shear", &data("direct_shear.csv"), "--loop", &runs]),
        &["--loop", "cannot be used with"],
    );
    says(&refused(&["shear"]), &["FILE"]);
}

#[test]
fn figures_are_written_in_the_form_of_their_name() {
    let dir = tempfile::tempdir().unwrap();
    for (ending, magic) in [("svg", &b"<svg"[..]), ("png", &b"\x89PNG"[..])] {
        for kind in ["fits", "records"] {
            let file = dir.path().join(format!("{kind}.{ending}"));
            assert_eq!(raw(&["--plot-kind", kind, "--plot", file.to_str().unwrap()]).0, 0);
            assert!(std::fs::read(&file).unwrap().starts_with(magic), "{kind}.{ending}");
        }
    }
    let file = dir.path().join("all.svg");
    assert_eq!(shear(&[&["--plot", file.to_str().unwrap()], &STROKE[..]].concat()).0, 0);
    says(
        &std::fs::read_to_string(&file).unwrap(),
        &["nevada_fine", "extrapolated", "stresses of the stroke"],
    );
    let table = data("direct_shear.csv");
    says(&refused(&["shear", &table, "--plot", "x.pdf"]), &[".svg, .png or .csv"]);
    says(&refused(&["shear", &table, "--plot", "x.svg", "--plot-kind", "records"]), &["--raw"]);
}
