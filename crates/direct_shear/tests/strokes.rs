//! Equivalent stresses and friction angles of strokes against tables 6.14 and 6.15 of Hong (2001).
#![allow(clippy::unwrap_used)]

mod common;

use common::{fixture, rained_corrected, soil};
use proptest::prelude::*;
use soilctl_direct_shear::{
    DirectShearError, FrictionAt, FrictionCurve, LogLogFit, PointDepth, SlopeFloorFit, StrokeLoad,
    consistent_friction_at_stroke, friction_at_stroke, stress_shift,
};
use soilctl_soil::{Angle, Plate, SoilError, Stroke, units};
use soilctl_tests::shown;

const GRAVITY: f64 = soilctl_soil::STANDARD_GRAVITY_M_S2;

/// A stroke of the thesis: 5 in wide plate, 1 in of slant length.
fn load(density_g_cc: f64, delta_deg: f64, alpha_deg: f64, force_lbf: f64, depth_in: f64) -> StrokeLoad {
    let alpha = Angle::from_degrees(alpha_deg);
    let depth_m = units::inches_to_m(1.0) * alpha.sin();
    let plate = Plate::new(alpha, Angle::ZERO, depth_m, units::inches_to_m(5.0)).unwrap();
    let stroke = Stroke::new(plate, units::lbf_to_n(force_lbf)).unwrap();
    let gamma = units::g_cc_to_kg_m3(density_g_cc) * GRAVITY;
    let point = PointDepth::Metres(units::inches_to_m(depth_in));
    StrokeLoad::new(&stroke, gamma, Angle::from_degrees(delta_deg), point).unwrap()
}

fn number(text: &str) -> f64 {
    text.parse().unwrap()
}

/// The two strokes (70 and 90 deg) of a soil at a depth in inches.
fn strokes(name: &str, depth_in: f64) -> [StrokeLoad; 2] {
    let rows = fixture("strokes.csv");
    let row = rows.iter().find(|row| row[0] == name).unwrap();
    [(70.0, 3), (90.0, 4)]
        .map(|(alpha, cell)| load(number(&row[1]), number(&row[2]), alpha, number(&row[cell]), depth_in))
}

#[test]
fn table_6_14() {
    let mut compared = 0;
    for row in fixture("table_6_14.csv") {
        let (name, phi, depth) = (row[0].as_str(), Angle::from_degrees(number(&row[1])), number(&row[2]));
        let [at70, at90] = strokes(name, depth).map(|load| load.equivalent_stress(phi).unwrap());
        let half = depth < 0.6;
        for (column, ours_pa) in [(3, at70.low_pa), (4, at70.high_pa), (5, at90.high_pa)] {
            let ours = units::pa_to_psi(ours_pa);
            // Cells in which the printed table disagrees with its own formula.
            let expected = match (name, column, half) {
                ("ticino_rained", 3, true) => 0.0354,
                ("glass_beads", 5, true) => 0.080,
                ("glass_beads", 5, false) => 0.106,
                _ => number(&row[column]),
            };
            assert!((ours / expected - 1.0).abs() < 0.013, "{name} {depth} in: {ours} against {expected}");
            compared += 1;
        }
    }
    assert_eq!(compared, 24);
}

#[test]
fn table_6_15_from_the_stresses_of_the_formula() {
    for row in fixture("table_6_15.csv") {
        let (name, depth) = (row[0].as_str(), number(&row[1]));
        // With 43.0 deg at 1.16 psi the rained soil is off by up to 0.65 deg, with 40.0 deg by less than 0.1.
        let (points, allowed) = match name {
            "ticino_rained" => (rained_corrected(), 0.1),
            _ => (soil(name), 0.18),
        };
        let fit = LogLogFit::fit(&points).unwrap();
        let phi = fixture("table_6_14.csv").iter().find(|r| r[0] == name).map(|r| number(&r[1])).unwrap();
        let [at70, at90] = strokes(name, depth)
            .map(|load| friction_at_stroke(&fit, &load, Angle::from_degrees(phi)).unwrap());
        let angles =
            [at70.friction_at_low_stress, at70.friction_at_high_stress, at90.friction_at_high_stress];
        for (cell, angle) in row[2..].iter().zip(angles) {
            // The printed glass value at 90 deg follows from its printed stress, not from the formula's.
            let slack = if name == "glass_beads" && cell == &row[4] { 0.47 } else { allowed };
            assert!(
                (angle.degrees() - number(cell)).abs() < slack,
                "{name} {depth}: {angle:?} against {cell}"
            );
        }
        assert!(at70.low_extrapolated && at70.high_extrapolated && at70.note.contains("extrapolated"));
        // "Except for two of the cases, extrapolation is required": Nevada and rained at 90 deg and 2/3 in.
        let inside = depth > 0.6 && (name == "nevada_fine" || name == "ticino_rained");
        assert_eq!(at90.high_extrapolated, !inside, "{name} {depth}");
    }
}

#[test]
fn the_documentation_shows_both_tables_as_they_are_here() {
    let mut lines = Vec::new();
    for (stresses, angles) in fixture("table_6_14.csv").iter().zip(fixture("table_6_15.csv")) {
        let (name, phi, depth) =
            (&stresses[0], Angle::from_degrees(number(&stresses[1])), number(&stresses[2]));
        let fit = LogLogFit::fit(&soil(name)).unwrap();
        let [at70, at90] = strokes(name, depth);
        let [low, high] = [&at70, &at90].map(|load| load.equivalent_stress(phi).unwrap());
        let [at70, at90] = [at70, at90].map(|load| friction_at_stroke(&fit, &load, phi).unwrap());
        for (place, cell, stress_pa, angle) in [
            ("low", 3, low.low_pa, at70.friction_at_low_stress),
            ("high at 70 deg", 4, low.high_pa, at70.friction_at_high_stress),
            ("high at 90 deg", 5, high.high_pa, at90.friction_at_high_stress),
        ] {
            let printed = [number(&stresses[cell]), number(&angles[cell - 1])];
            let numbers = vec![units::pa_to_psi(stress_pa), printed[0], angle.degrees(), printed[1]];
            lines.push((format!("{name},{depth:.4},{place}"), numbers));
        }
    }
    let header = "soil,depth_in,stress,stress_psi,stress_psi_printed,phi_deg,phi_deg_printed";
    shown("direct_shear.csv", header, &lines);
}

#[test]
fn printed_stresses_give_the_printed_angles() {
    for (row, stresses) in fixture("table_6_15.csv").iter().zip(fixture("table_6_14.csv")) {
        if row[0] == "ticino_rained" {
            continue;
        }
        let fit = LogLogFit::fit(&soil(&row[0])).unwrap();
        for (angle, stress) in row[2..].iter().zip(&stresses[3..]) {
            let at = fit.friction_at(units::psi_to_pa(number(stress))).unwrap();
            assert!((at.friction.degrees() - number(angle)).abs() < 0.18, "{row:?} {at:?}");
        }
    }
}

#[test]
fn the_consistent_angles_reproduce_their_own_stresses() {
    for name in ["ticino_loose", "nevada_fine", "ticino_rained", "glass_beads"] {
        let fit = LogLogFit::fit(&soil(name)).unwrap();
        let broken = SlopeFloorFit::fit(&soil(name), None).unwrap();
        for load in strokes(name, 0.5) {
            for fit in [&fit as &dyn FrictionCurve, &broken] {
                let found = consistent_friction_at_stroke(fit, &load).unwrap();
                let low = load.low_stress_pa(found.friction_at_low_stress).unwrap();
                let high = load.high_stress_pa(found.friction_at_high_stress).unwrap();
                assert!((low / found.low_stress_pa - 1.0).abs() < 1e-9);
                assert!((high / found.high_stress_pa - 1.0).abs() < 1e-9);
                assert!(found.iterations > 0 && found.lowest_friction <= found.highest_friction);
            }
        }
    }
}

/// Friction that jumps up where the stress it produces falls: the iteration goes to and fro for ever.
struct Step;

impl FrictionCurve for Step {
    fn name(&self) -> &'static str {
        "step"
    }

    fn stress_range_pa(&self) -> (f64, f64) {
        (100.0, 1000.0)
    }

    fn friction_at(&self, normal_stress_pa: f64) -> Result<FrictionAt, DirectShearError> {
        // sigma_L is 1.299 gamma z at 30 deg and 1.135 gamma z at 50 deg.
        let gamma_z = 1500.0 * GRAVITY * units::inches_to_m(0.5);
        let degrees = if normal_stress_pa > 1.2 * gamma_z { 50.0 } else { 30.0 };
        let friction = Angle::from_degrees(degrees);
        Ok(FrictionAt { normal_stress_pa, friction, extrapolated: false, standard_error_deg: None })
    }
}

#[test]
fn an_iteration_that_cannot_settle_is_an_error() {
    let error = consistent_friction_at_stroke(&Step, &load(1.5, 5.0, 90.0, 0.9, 0.5)).unwrap_err();
    let DirectShearError::NotConverged { iterations, last_change_deg } = error else { panic!("{error}") };
    assert_eq!(iterations, 200);
    assert!((last_change_deg - 20.0).abs() < 1e-9);
}

#[test]
fn points_and_angles_out_of_range_are_refused() {
    let load = load(1.5, 23.0, 90.0, 1.0, 0.5);
    let error = load.high_stress_pa(Angle::from_degrees(20.0)).unwrap_err();
    assert!(matches!(error, DirectShearError::Soil(SoilError::InterfaceRougherThanSoil { .. })), "{error}");
    for phi in [0.0, 90.0, -5.0, f64::NAN] {
        assert!(load.equivalent_stress(Angle::from_degrees(phi)).is_err(), "{phi}");
    }
    let plate = Plate::new(Angle::from_degrees(90.0), Angle::ZERO, 0.0254, 0.127).unwrap();
    let stroke = Stroke::new(plate, 4.0).unwrap();
    let delta = Angle::from_degrees(20.0);
    for point in [PointDepth::Metres(0.03), PointDepth::Metres(0.0), PointDepth::FractionOfPlate(1.1)] {
        assert!(StrokeLoad::new(&stroke, 15_000.0, delta, point).is_err(), "{point:?}");
    }
    let whole = PointDepth::FractionOfPlate(1.0);
    assert!(StrokeLoad::new(&stroke, 0.0, delta, whole).is_err());
    assert!(StrokeLoad::new(&stroke, 15_000.0, Angle::from_degrees(-1.0), whole).is_err());
}

#[test]
fn carrying_an_angle_to_high_stress_is_warned_of() {
    let fit = SlopeFloorFit::fit(&soil("ticino_loose"), None).unwrap();
    let shift = stress_shift(&fit, units::psi_to_pa(0.18), units::psi_to_pa(10.0)).unwrap();
    assert!((-10.5..-9.0).contains(&shift.shift_deg), "{shift:?}");
    assert!(!shift.measured_extrapolated && !shift.used_extrapolated);
    assert!(shift.warning.contains("overestimated") && !shift.warning.contains("guess"), "{}", shift.warning);
    let back = stress_shift(&fit, units::psi_to_pa(10.0), units::psi_to_pa(0.05)).unwrap();
    assert!(back.shift_deg > 0.0 && back.used_extrapolated && back.warning.contains("guess"), "{back:?}");
}

proptest! {
    /// Where the plate presses at least as hard as the Rankine zone needs, the stress beside it is the larger one.
    #[test]
    fn high_stress_is_above_low_stress(
        phi in 15.0..50.0f64, ratio in 0.0..1.0f64, excess in 1.0..20.0f64, alpha in 60.0..110.0f64,
    ) {
        let (phi, delta) = (Angle::from_degrees(phi), Angle::from_degrees(phi * ratio));
        let passive = (1.0 + phi.sin()) / (1.0 - phi.sin());
        let plate = Plate::new(Angle::from_degrees(alpha), Angle::ZERO, 0.0254, 0.127).unwrap();
        let gamma = 15_000.0;
        let pressure = excess * passive * gamma * 0.0127 / delta.cos();
        let force = pressure * plate.width_m() * plate.slant_length_m();
        let stroke = Stroke::new(plate, force).unwrap();
        let load = StrokeLoad::new(&stroke, gamma, delta, PointDepth::FractionOfPlate(0.5)).unwrap();
        let stress = load.equivalent_stress(phi).unwrap();
        prop_assert!((load.plate_pressure_pa() / pressure - 1.0).abs() < 1e-12);
        prop_assert!(stress.high_pa >= stress.low_pa);
        prop_assert!(stress.high_pa >= load.low_tangent_stress_pa(phi).unwrap() * (1.0 - 1e-12));
    }

    /// The circle with its tangent point at sigma_U passes through the stresses on the plate.
    #[test]
    fn high_stress_is_a_tangent_point(phi in 20.0..50.0f64, ratio in 0.0..0.99f64, force in 1.0..20.0f64) {
        let (phi, delta) = (Angle::from_degrees(phi), Angle::from_degrees(phi * ratio));
        let plate = Plate::new(Angle::from_degrees(90.0), Angle::ZERO, 0.0254, 0.127).unwrap();
        let stroke = Stroke::new(plate, force).unwrap();
        let load = StrokeLoad::new(&stroke, 15_000.0, delta, PointDepth::FractionOfPlate(0.5)).unwrap();
        let sigma = load.high_stress_pa(phi).unwrap();
        let centre = sigma / phi.cos().powi(2);
        let normal = (1.0 - phi.sin()) * 15_000.0 * load.point_depth_m() + load.plate_pressure_pa() * delta.cos();
        let shear = load.plate_pressure_pa() * delta.sin();
        let radius = (normal - centre).hypot(shear);
        prop_assert!((radius / (centre * phi.sin()) - 1.0).abs() < 1e-6);
    }
}
