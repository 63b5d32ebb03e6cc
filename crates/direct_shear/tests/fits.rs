//! The fits on exact data, in any order, and on data they must refuse.
#![allow(clippy::unwrap_used)]

mod common;

use common::{point, soil, table_6_13, three_to_one};
use proptest::prelude::*;
use soilctl_direct_shear::{
    ConstantFit, DirectShearError, FrictionCurve, LogLogFit, ShearPoint, SlopeFloorFit, compare_curves,
};
use soilctl_soil::units::psi_to_pa;

#[test]
fn standard_errors_of_a_line_worked_by_hand() {
    // ln sigma = -1, 0, 1 and ln phi = 3, 3.3, 3.3: slope 0.15, mean 3.2, residuals -0.05, 0.1, -0.05, so
    // s2 = 0.015 with one point to spare, error of ln A sqrt(s2 / 3), of b sqrt(s2 / 2).
    let points: Vec<_> = [(-1.0, 3.0), (0.0, 3.3), (1.0, 3.3)]
        .iter()
        .map(|(x, y)| point(f64::exp(*x), f64::exp(*y)))
        .collect();
    let fit = LogLogFit::fit_all(&points, None).unwrap();
    assert!((fit.exponent - 0.15).abs() < 1e-12);
    assert!((fit.ln_friction_standard_error.unwrap() - 0.005f64.sqrt()).abs() < 1e-12);
    assert!((fit.exponent_standard_error.unwrap() - 0.0075f64.sqrt()).abs() < 1e-12);
    let at = fit.friction_at(psi_to_pa(1.0)).unwrap();
    // s2 (1 + 1/3) = 0.02 for one further test in the middle.
    let expected = 3.2f64.exp() * 0.02f64.sqrt();
    assert!((at.standard_error_deg.unwrap() - expected).abs() < 1e-9);
}

#[test]
fn two_points_leave_no_standard_error() {
    let fit = LogLogFit::fit_all(&[point(0.2, 40.0), point(2.0, 36.0)], None).unwrap();
    assert_eq!((fit.exponent_standard_error, fit.ln_friction_standard_error), (None, None));
    assert_eq!(fit.friction_at(psi_to_pa(1.0)).unwrap().standard_error_deg, None);
}

#[test]
fn the_right_curve_wins_when_there_are_enough_loads() {
    let broken = |psi: f64| 30.0 + 6.0 * (2.0 / psi).log10().max(0.0);
    let loads: Vec<f64> = (0..16).map(|i| 0.1 * 1.5f64.powi(i)).collect();
    let points: Vec<_> = loads.iter().map(|psi| point(*psi, broken(*psi))).collect();
    assert_eq!(compare_curves(&points, None).unwrap().best_by_aicc, Some("slope and floor"));
    let points: Vec<_> = loads.iter().map(|psi| point(*psi, 36.0 * psi.powf(-0.05))).collect();
    assert_eq!(compare_curves(&points, None).unwrap().best_by_aicc, Some("power law"));
    let points: Vec<_> = loads.iter().map(|psi| point(*psi, 33.0)).collect();
    assert_eq!(compare_curves(&points, None).unwrap().best_by_aicc, Some("constant angle"));
}

#[test]
fn rising_friction_gives_a_constant_not_a_negative_slope() {
    let fit = SlopeFloorFit::fit(&[point(0.2, 30.0), point(1.0, 32.0), point(5.0, 35.0)], None).unwrap();
    assert_eq!(fit.slope_deg_per_decade, 0.0);
    assert!(!fit.floor_stress_settled && (fit.floor.degrees() - 97.0 / 3.0).abs() < 1e-9, "{fit:?}");
}

#[test]
fn too_few_stresses_and_bad_weights_are_refused() {
    let same = [point(1.0, 40.0), point(1.0, 41.0)];
    let two = [point(1.0, 40.0), point(2.0, 39.0)];
    assert!(matches!(LogLogFit::fit(&[]), Err(DirectShearError::TooFewStresses { found: 0, .. })));
    assert!(matches!(LogLogFit::fit(&same), Err(DirectShearError::TooFewStresses { found: 1, .. })));
    assert!(matches!(ConstantFit::fit(&same, None), Err(DirectShearError::TooFewStresses { .. })));
    assert!(matches!(
        SlopeFloorFit::fit(&two, None),
        Err(DirectShearError::TooFewStresses { needed: 3, .. })
    ));
    assert!(matches!(ConstantFit::fit(&two, Some(&[1.0])), Err(DirectShearError::WeightCount { .. })));
    for weight in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(ConstantFit::fit(&two, Some(&[1.0, weight])).is_err());
    }
    assert!(LogLogFit::fit_below(&two, f64::NAN).is_err());
}

#[test]
fn impossible_questions_are_refused() {
    let fit = LogLogFit::fit(&soil("ticino_loose")).unwrap();
    for stress in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e12] {
        assert!(matches!(fit.friction_at(stress), Err(DirectShearError::OutOfRange { .. })), "{stress}");
    }
    let steep = LogLogFit::fit_all(&[point(1.0, 60.0), point(2.0, 30.0)], None).unwrap();
    assert!(matches!(steep.friction_at(1.0), Err(DirectShearError::ImpossibleFriction { .. })));
}

proptest! {
    #[test]
    fn power_laws_are_recovered(a in 20.0..45.0f64, b in -0.1..0.1f64, n in 2usize..8) {
        let points: Vec<_> = (0..n).map(|i| 0.1 * 1.6f64.powi(i32::try_from(i).unwrap()))
            .map(|psi| point(psi, a * psi.powf(b))).collect();
        let fit = LogLogFit::fit_all(&points, None).unwrap();
        prop_assert!((fit.friction_at_1_psi_deg - a).abs() < 1e-9 && (fit.exponent - b).abs() < 1e-10);
        prop_assert!(fit.misfit.rms_deg < 1e-9);
    }

    #[test]
    fn slopes_with_a_floor_are_recovered(floor in 20.0..40.0f64, slope in 1.0..9.0f64, at in 0.4..6.0f64) {
        let loads = [0.1, 0.2, 0.35, 1.0, 2.0, 7.0, 11.0, 19.0];
        let points: Vec<_> = loads.iter()
            .map(|psi| point(*psi, floor + slope * (at / psi).log10().max(0.0))).collect();
        let fit = SlopeFloorFit::fit(&points, None).unwrap();
        prop_assert!((fit.floor.degrees() - floor).abs() < 1e-8, "{:?}", fit);
        prop_assert!((fit.slope_deg_per_decade - slope).abs() < 1e-7, "{:?}", fit);
        prop_assert!((fit.floor_stress_pa / psi_to_pa(at) - 1.0).abs() < 1e-7, "{:?}", fit);
        prop_assert!(fit.floor_stress_settled);
    }

    #[test]
    fn order_of_the_points_does_not_matter(order in Just((0..7).collect::<Vec<usize>>()).prop_shuffle()) {
        for series in table_6_13() {
            let mixed: Vec<_> = order.iter().map(|i| series.points[*i]).collect();
            prop_assert_eq!(LogLogFit::fit(&mixed).unwrap(), LogLogFit::fit(&series.points).unwrap());
            prop_assert_eq!(
                SlopeFloorFit::fit(&mixed, Some(&three_to_one(&mixed))).unwrap(),
                SlopeFloorFit::fit(&series.points, Some(&three_to_one(&series.points))).unwrap()
            );
        }
    }

    #[test]
    fn no_numbers_that_are_not_numbers(
        raw in prop::collection::vec((1e-5..1e8f64, 1e-3..89.999f64), 0..6), stress in 1e-5..1e8f64,
    ) {
        let points: Vec<_> = raw.iter()
            .map(|(s, a)| ShearPoint::new(*s, soilctl_soil::Angle::from_degrees(*a)).unwrap()).collect();
        let answers = [
            LogLogFit::fit_all(&points, None).and_then(|fit| fit.friction_at(stress)),
            SlopeFloorFit::fit(&points, None).and_then(|fit| fit.friction_at(stress)),
            ConstantFit::fit(&points, None).and_then(|fit| fit.friction_at(stress)),
        ];
        for answer in answers.into_iter().flatten() {
            prop_assert!(answer.friction.degrees() > 0.0 && answer.friction.degrees() < 90.0);
            prop_assert!(answer.standard_error_deg.is_none_or(f64::is_finite));
        }
    }
}
