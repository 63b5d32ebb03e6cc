//! The fits against table 6.13 of Hong (2001) and the numbers printed for it.
#![allow(clippy::unwrap_used)]

mod common;

use common::{rained_corrected, soil, table_6_13, three_to_one};
use soilctl_direct_shear::{
    ConstantFit, FrictionCurve, LogLogFit, ShearPoint, SlopeFloorFit, compare_curves,
};
use soilctl_soil::units::{pa_to_psi, psi_to_pa};

#[test]
fn power_laws_of_the_thesis() {
    let expected = [(37.647, -0.0538), (34.020, -0.0694), (43.139, -0.0475), (26.462, -0.0683)];
    for (series, (a, b)) in table_6_13().iter().zip(expected) {
        let fit = LogLogFit::fit(&series.points).unwrap();
        assert!((fit.friction_at_1_psi_deg / a - 1.0).abs() < 2e-5, "{fit:?}");
        assert!((fit.exponent - b).abs() < 5.1e-5 && (fit.exponent / b - 1.0).abs() < 1e-3, "{fit:?}");
        assert_eq!(fit.misfit.points, 4);
    }
}

#[test]
fn power_law_marks_extrapolation_on_both_sides() {
    let fit = LogLogFit::fit(&soil("ticino_loose")).unwrap();
    for (psi, extrapolated) in [(0.179, true), (0.18, false), (1.0, false), (2.33, false), (6.95, true)] {
        assert_eq!(fit.friction_at(psi_to_pa(psi)).unwrap().extrapolated, extrapolated, "{psi} psi");
    }
}

/// Weighted 3 to 1, table 6.13 as printed is met within 0.9 deg in the weighted RMS sense. In the unweighted RMS sense
/// the rained soil misses by 0.97 deg because of its suspicious 43.0 deg; single residuals reach 1.8 deg.
#[test]
fn slope_and_floor_describe_table_6_13() {
    // (soil, weighted RMS, unweighted RMS, worst residual), from a grid search over the break.
    let expected = [
        ("ticino_loose", 0.762, 0.766, 1.39),
        ("nevada_fine", 0.358, 0.396, -0.75),
        ("ticino_rained", 0.806, 0.970, -1.845),
        ("glass_beads", 0.258, 0.308, 0.50),
    ];
    for (name, weighted, unweighted, worst) in expected {
        let points = soil(name);
        let fit = SlopeFloorFit::fit(&points, Some(&three_to_one(&points))).unwrap();
        assert!(fit.misfit.weighted_rms_deg < 0.9, "{name} {fit:?}");
        assert!((fit.misfit.weighted_rms_deg - weighted).abs() < 2e-3, "{name} {fit:?}");
        assert!((fit.misfit.rms_deg - unweighted).abs() < 2e-3, "{name} {fit:?}");
        assert!((fit.misfit.worst_residual_deg.abs() - f64::abs(worst)).abs() < 1e-2, "{name} {fit:?}");
        let equal = SlopeFloorFit::fit(&points, None).unwrap();
        assert!(equal.misfit.rms_deg < 0.9, "{name} {equal:?}");
    }
}

#[test]
fn without_the_suspicious_value_the_rained_soil_is_met_too() {
    let points = rained_corrected();
    let fit = SlopeFloorFit::fit(&points, Some(&three_to_one(&points))).unwrap();
    assert!(fit.misfit.rms_deg < 0.6 && fit.misfit.worst_residual_deg.abs() < 1.0, "{fit:?}");
}

#[test]
fn a_constant_misses_table_6_13_by_degrees() {
    let expected = [(4.1, 3.8), (2.7, 2.6), (2.6, 2.5), (2.0, 1.9)];
    for (series, (weighted, equal)) in table_6_13().iter().zip(expected) {
        let weights = three_to_one(&series.points);
        let fit = ConstantFit::fit(&series.points, Some(&weights)).unwrap();
        assert!((fit.misfit.rms_deg - weighted).abs() < 0.06, "{fit:?}");
        let fit = ConstantFit::fit(&series.points, None).unwrap();
        assert!((fit.misfit.rms_deg - equal).abs() < 0.06, "{fit:?}");
    }
}

#[test]
fn no_break_of_a_fine_grid_beats_the_exact_one() {
    for series in table_6_13() {
        for weights in [three_to_one(&series.points), vec![1.0; 7]] {
            let fit = SlopeFloorFit::fit(&series.points, Some(&weights)).unwrap();
            let best = fit.misfit.weighted_rms_deg;
            for step in 0..=2000 {
                let at = 10f64.powf(0.18f64.log10() + f64::from(step) / 2000.0 * (18.82f64 / 0.18).log10());
                assert!(rms_with_break_at(&series.points, &weights, at) >= best - 1e-9);
            }
        }
    }
}

/// Weighted RMS of the best slope and floor for a break at a given stress in psi.
fn rms_with_break_at(points: &[ShearPoint], weights: &[f64], break_psi: f64) -> f64 {
    let h = |p: &ShearPoint| (break_psi / pa_to_psi(p.normal_stress_pa())).log10().max(0.0);
    let rows: Vec<_> = points.iter().zip(weights).map(|(p, w)| (h(p), p.friction().degrees(), *w)).collect();
    let total: f64 = rows.iter().map(|r| r.2).sum();
    let mean = |f: &dyn Fn(&(f64, f64, f64)) -> f64| rows.iter().map(|r| r.2 * f(r)).sum::<f64>() / total;
    let (mh, my) = (mean(&|r| r.0), mean(&|r| r.1));
    let (shh, shy) = (mean(&|r| (r.0 - mh).powi(2)), mean(&|r| (r.0 - mh) * (r.1 - my)));
    let slope = if shh > 0.0 { (shy / shh).max(0.0) } else { 0.0 };
    mean(&|r| (r.1 - my - slope * (r.0 - mh)).powi(2)).sqrt()
}

/// Seven loads are few: AICc settles for two parameters everywhere, BIC mostly asks for the floor, and the verdict
/// says that the tests do not decide.
#[test]
fn verdicts_on_table_6_13_say_that_more_loads_are_needed() {
    for series in table_6_13() {
        let comparison = compare_curves(&series.points, None).unwrap();
        assert_eq!(comparison.best_by_aicc, Some("power law"));
        assert_eq!(comparison.best_by_bic, "slope and floor");
        assert!(comparison.verdict.contains("more loads"), "{}", comparison.verdict);
    }
    let loose = soil("ticino_loose");
    let verdict = compare_curves(&loose, Some(&three_to_one(&loose))).unwrap().verdict;
    assert!(verdict.contains("0.3 behind in BIC"), "{verdict}");
}

#[test]
fn verdicts_on_table_6_13_are_never_for_a_constant() {
    for series in table_6_13() {
        let comparison = compare_curves(&series.points, None).unwrap();
        assert_ne!(comparison.best_by_aicc, Some("constant angle"));
        assert_ne!(comparison.best_by_bic, "constant angle");
        assert!(comparison.verdict.contains("deg"), "{}", comparison.verdict);
    }
}
