//! `soilctl shear` from outside: fits, extrapolation, strokes, raw records, messages.

mod common;

use std::path::{Path, PathBuf};

use common::{json, refused, soilctl};
use serde_json::Value;

const SOILS: [(&str, f64, f64); 4] = [
    ("ticino_loose", 37.647, -0.0538),
    ("nevada_fine", 34.020, -0.0694),
    ("ticino_rained", 43.139, -0.0475),
    ("glass_beads", 26.462, -0.0683),
];
const PA_PER_PSI: f64 = 6_894.757;
const HEADER: &str = "soil,normal_stress_psi,friction_angle_deg\n";
/// The stroke of the loose soil at 90 deg in Hong (2001), chapter 6: 1.595 lbf on 1 in by 5 in.
const STROKE: [&str; 12] = [
    "--alpha",
    "90",
    "--depth",
    "0.0254",
    "--width",
    "0.127",
    "--density",
    "1430",
    "--delta",
    "23",
    "--force",
    "7.094914",
];

fn data(name: &str) -> String {
    let path: PathBuf = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data").join(name);
    path.to_str().unwrap().to_owned()
}

fn shear(more: &[&str]) -> (i32, Value) {
    json(&[&["shear", &data("direct_shear.csv")], more].concat())
}

fn raw(more: &[&str]) -> (i32, Value) {
    let (runs, empty_box) = (data("direct_shear_raw/runs.csv"), data("direct_shear_raw/loop.csv"));
    json(&[&["shear", "--raw", &runs, "--loop", &empty_box, "--bias", "0.85"], more].concat())
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

fn list(value: &Value) -> &[Value] {
    value.as_array().unwrap_or_else(|| panic!("{value} is no list"))
}

/// Writes a table; the message with which it is refused.
fn refused_table(bytes: &[u8]) -> String {
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("mine.csv");
    std::fs::write(&file, bytes).unwrap();
    refused(&["shear", file.to_str().unwrap()])
}

fn says(message: &str, parts: &[&str]) {
    for part in parts {
        assert!(message.contains(part), "{part:?} is not in: {message}");
    }
}

#[test]
fn power_laws_are_those_of_the_thesis() {
    let (code, answer) = shear(&[]);
    assert_eq!((code, &answer["schema"]), (0, &"soilctl.shear/1".into()));
    assert_eq!((list(&answer["soils"]).len(), list(&answer["warnings"]).len()), (4, 0));
    for (soil, (name, a, b)) in list(&answer["soils"]).iter().zip(SOILS) {
        let fit = &soil["power_law"];
        assert_eq!(
            (&soil["soil"], list(&soil["points"]).len(), &fit["points"]),
            (&name.into(), 7, &4.into())
        );
        assert!((number(&fit["a_deg_at_1_psi"]) / a - 1.0).abs() < 1e-3, "{fit}");
        assert!((number(&fit["b"]) / b - 1.0).abs() < 1e-3, "{fit}");
        assert!(number(&fit["ln_a_standard_error"]) > 0.0 && number(&fit["b_standard_error"]) > 0.0);
        assert!((number(&fit["stress_range_pa"][1]) / (2.33 * PA_PER_PSI) - 1.0).abs() < 1e-6);
        assert!(number(&soil["slope_floor"]["rms_deg"]) < 0.9 && number(&soil["constant"]["rms_deg"]) > 1.9);
        assert!(soil["best"].as_str().unwrap().contains("more loads") && soil["stroke"].is_null());
    }
}

#[test]
fn one_soil_and_another_limit_can_be_chosen() {
    let (_, one) = shear(&["--soil", "glass_beads", "--fit-limit", "1e6"]);
    let soils = list(&one["soils"]);
    assert_eq!((soils.len(), &soils[0]["soil"]), (1, &"glass_beads".into()));
    assert_eq!((&soils[0]["power_law"]["points"], number(&one["fit_limit_pa"])), (&7.into(), 1e6));
    says(
        &refused(&["shear", &data("direct_shear.csv"), "--soil", "clay"]),
        &["clay", "its soils are", "glass_beads"],
    );
    says(&refused(&["shear", &data("direct_shear.csv"), "--fit-limit", "-1"]), &["--fit-limit is -1 Pa"]);
}

#[test]
fn extrapolation_is_flagged_below_the_lowest_load_only() {
    let (_, answer) = shear(&["--stress", "800,3000"]);
    for soil in list(&answer["soils"]) {
        let at = list(&soil["at"]);
        assert_eq!(at.len(), 4);
        for one in at {
            assert_eq!(one["extrapolated"], number(&one["normal_stress_pa"]) < 1000.0, "{one}");
        }
        let fit = &soil["power_law"];
        let law = number(&fit["a_deg_at_1_psi"]) * (800.0 / PA_PER_PSI).powf(number(&fit["b"]));
        assert_eq!(at[0]["curve"], "power law");
        assert!((number(&at[0]["friction_angle_deg"]) / law - 1.0).abs() < 1e-6);
    }
    let warnings = list(&answer["warnings"]);
    assert_eq!(warnings.len(), 4);
    says(warnings[0].as_str().unwrap(), &["ticino_loose", "0.8 kPa", "0.18 psi", "extrapolated"]);

    let text = |stress| {
        let done =
            soilctl(&["shear", &data("direct_shear.csv"), "--soil", "nevada_fine", "--stress", stress]);
        String::from_utf8(done.stdout).unwrap()
    };
    says(&text("800"), &["warning: nevada_fine", "* extrapolated", "psi", "kPa", "34.020", "-0.0694"]);
    assert!(!text("3000").contains("warning"));
    // Above the loads of the power law, but within those of the other curve.
    let (_, high) = shear(&["--soil", "nevada_fine", "--stress", "50000"]);
    let flags: Vec<_> = list(&high["soils"][0]["at"]).iter().map(|at| at["extrapolated"].clone()).collect();
    assert_eq!(flags, [Value::from(true), Value::from(false)]);
}

#[test]
fn stroke_stresses_are_those_of_table_6_14() {
    let given = [&["--soil", "ticino_loose", "--phi", "42.9"], &STROKE[..]].concat();
    let (code, answer) = shear(&given);
    let stroke = &answer["soils"][0]["stroke"];
    assert_eq!((code, list(&stroke["points"]).len(), &stroke["carried"]), (0, 4, &Value::Null));
    for (place, low_psi, high_psi) in [(0, 0.032, 0.118), (2, 0.042, 0.157)] {
        let point = &stroke["points"][place];
        let psi = |key: &str| number(&point[key]) / PA_PER_PSI;
        assert!((psi("low_stress_pa") / low_psi - 1.0).abs() < 0.013, "{point}");
        assert!((psi("high_stress_pa") / high_psi - 1.0).abs() < 0.013, "{point}");
        assert_eq!((&point["low_extrapolated"], &point["high_extrapolated"]), (&true.into(), &true.into()));
    }
    let (_, consistent) =
        shear(&[&["--soil", "ticino_loose", "--point-fraction", "1"], &STROKE[..]].concat());
    let point = &consistent["soils"][0]["stroke"]["points"][0];
    let phi = number(&point["friction_at_low_stress_deg"]).to_radians();
    let low = 1430.0 * 9.80665 * 0.0254 * (1.0 + phi.sin()) * phi.cos();
    assert!((number(&point["low_stress_pa"]) / low - 1.0).abs() < 1e-9 && number(&point["iterations"]) > 0.0);
}

#[test]
fn carrying_the_angle_of_a_stroke_is_warned_of() {
    let (_, answer) = shear(&[&["--soil", "ticino_loose", "--carry-to", "100000"], &STROKE[..]].concat());
    let carried = list(&answer["soils"][0]["stroke"]["carried"]);
    assert_eq!(carried.len(), 4);
    assert!(carried.iter().all(|shift| (-15.0..-9.0).contains(&number(&shift["shift_deg"]))), "{carried:?}");
    let warnings: Vec<_> = list(&answer["warnings"]).iter().map(|text| text.as_str().unwrap()).collect();
    says(warnings.last().unwrap(), &["used at 100000 Pa", "overestimated", "guess"]);
    let file = data("direct_shear.csv");
    let args = [&["shear", &file, "--carry-to", "100000"], &STROKE[..]].concat();
    says(
        &String::from_utf8(soilctl(&args).stdout).unwrap(),
        &["used at 14.5 psi (100 kPa)", "stroke: 7.09491 N"],
    );
}

#[test]
fn a_stroke_is_given_whole_and_possible() {
    let file = data("direct_shear.csv");
    says(
        &refused(&["shear", &file, "--force", "7"]),
        &["--alpha", "--depth", "--width", "--density", "--delta"],
    );
    says(&refused(&["shear", &file, "--alpha", "90"]), &["--depth", "--force"]);
    says(&refused(&["shear", &file, "--carry-to", "1000"]), &["--force"]);
    let with = |more: &[&str]| refused(&[&["shear", &file], more, &STROKE[..]].concat());
    says(&with(&["--phi", "20"]), &["delta is 23 deg", "phi"]);
    says(&with(&["--point-fraction", "1.5"]), &["1.5", "at most 1"]);
    says(&with(&["--gravity", "-1"]), &["gravity is -1"]);
    says(&with(&["--carry-to", "0"]), &["0 Pa"]);
    // Rougher than one of two soils: that one has no stroke, the other one has.
    let rough: Vec<&str> = STROKE.iter().map(|arg| if *arg == "23" { "32" } else { arg }).collect();
    let two = ["--soil", "glass_beads", "--soil", "ticino_rained"];
    let (code, answer) = shear(&[&two[..], &rough].concat());
    let soils = list(&answer["soils"]);
    assert_eq!((code, soils[0]["stroke"].is_null(), soils[1]["stroke"].is_null()), (0, false, true));
    assert!(
        list(&answer["warnings"]).iter().any(|text| text.as_str().unwrap().contains("glass_beads, stroke"))
    );
    let alone = refused(&[&["shear", &file, "--soil", "glass_beads"], &rough[..]].concat());
    says(&alone, &["no soil gives a friction angle for this stroke"]);
}

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
fn a_curve_that_cannot_be_fitted_is_null_and_said_so() {
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("few.csv");
    let path = file.to_str().unwrap();
    std::fs::write(&file, format!("{HEADER}a,1,40\na,2,39\nb,1,35\n")).unwrap();
    let (code, answer) = json(&["shear", path, "--stress", "9000"]);
    let (a, b) = (&answer["soils"][0], &answer["soils"][1]);
    assert_eq!((code, a["slope_floor"].is_null(), list(&a["at"]).len()), (0, true, 1));
    assert!(a["power_law"]["b_standard_error"].is_null() && a["constant"].is_object());
    assert!(b["power_law"].is_null() && b["constant"].is_null() && b["best"].is_null());
    let warned = |text: &str| list(&answer["warnings"]).iter().any(|w| w.as_str().unwrap().contains(text));
    assert!(warned("a: slope and floor needs at least 3") && warned("b: power law needs at least 2"));

    std::fs::write(&file, "normal_stress_pa,friction_angle_deg\n90000,40\n95000,39\n").unwrap();
    let (_, high) = json(&["shear", path, "--stress", "92000"]);
    assert_eq!(
        (&high["soils"][0]["soil"], &high["soils"][0]["at"][0]["curve"]),
        (&Value::Null, &"constant angle".into())
    );
    says(&refused(&["shear", path, "--soil", "a"]), &["no column soil"]);
    std::fs::write(&file, format!("{HEADER}a,1,40\nb,1,35\n")).unwrap();
    says(&refused(&["shear", path]), &["few.csv", "no curve can be fitted", "test at more loads"]);
}

#[test]
fn bad_tables_are_refused_with_file_line_and_column() {
    let cell = |row: &str| refused_table(format!("{HEADER}a,1,30\n{row}\n").as_bytes());
    says(&cell("a,x,30"), &["mine.csv, line 3, column `normal_stress_psi`", "\"x\""]);
    says(&cell("a,0,30"), &["mine.csv, line 3, column `normal_stress_psi`", "\"0\""]);
    says(&cell("a,2,90"), &["mine.csv, line 3, column `friction_angle_deg`", "\"90\"", "below 90 deg"]);
    says(&cell("a,2"), &["mine.csv, line 3", "2 cells"]);
    says(
        &refused_table(b"soil,normal_stress_psi\na,1\n"),
        &["mine.csv, line 1", "`friction_angle_deg` is missing"],
    );
    says(&refused_table(&[HEADER.as_bytes(), b"\xff,1,30\n"].concat()), &["mine.csv, line 2", "UTF-8"]);
    says(&refused_table(b""), &["mine.csv", "no rows"]);
    says(&refused(&["shear", "no/such/file.csv"]), &["no/such/file.csv"]);
    says(&refused(&["shear", &data("direct_shear.csv"), "--stress", "0"]), &["normal_stress_pa is 0 Pa"]);
    says(&refused(&["shear", &data("direct_shear.csv"), "--stress", "nan"]), &["nan", "finite number"]);
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
    says(&refused(&["shear", &data("direct_shear.csv"), "--loop", &runs]), &["--raw"]);
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
    says(&refused(&["shear", &table, "--plot", "x.pdf"]), &[".svg or .png"]);
    says(&refused(&["shear", &table, "--plot", "x.svg", "--plot-kind", "records"]), &["--raw"]);
}
