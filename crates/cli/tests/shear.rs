//! `soilctl shear` from outside: fits, extrapolation, messages.

#![allow(clippy::unwrap_used)]

mod common;

use common::shear::{PA_PER_PSI, data, list, number, says, shear};
use common::{json, refused, soilctl};
use serde_json::Value;

const SOILS: [(&str, f64, f64); 4] = [
    ("ticino_loose", 37.647, -0.0538),
    ("nevada_fine", 34.020, -0.0694),
    ("ticino_rained", 43.139, -0.0475),
    ("glass_beads", 26.462, -0.0683),
];
const HEADER: &str = "soil,normal_stress_psi,friction_angle_deg\n";

/// Writes a table; the message with which it is refused.
fn refused_table(bytes: &[u8]) -> String {
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("mine.csv");
    std::fs::write(&file, bytes).unwrap();
    refused(&["shear", file.to_str().unwrap()])
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
