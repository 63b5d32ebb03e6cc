//! `soilctl shear` from outside: stresses and angles of a plate's stroke.

mod common;

use common::shear::{PA_PER_PSI, STROKE, data, list, number, says, shear};
use common::{refused, soilctl};
use serde_json::Value;

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
