//! Ground without cohesion, against what holds for it exactly: a slope of dry sand bears `tan(phi)/tan(beta)`, whatever its height,
//! since it slides along itself (Taylor 1948), and no proof may say more.
#![allow(clippy::unwrap_used, reason = "helpers of tests")]

mod balance;

use proptest::prelude::*;
use proptest::test_runner::TestRunner;
use soilctl_certificate::{Condition, Jet, prove_lower, prove_upper};
use soilctl_limit_analysis::{Description, Options, SafetyBounds, bound, factor_of_safety};

/// What lies under a slope.
#[derive(Debug, Clone, Copy)]
enum Base {
    Rock,
    Same,
    /// Heavier or lighter, and strong.
    Clay(f64),
}

fn description(phi: f64, beta: f64, height: f64, cohesion: f64, base: Base, far: bool) -> Description {
    serde_json::from_value(problem(phi, beta, height, cohesion, base, far)).unwrap()
}

/// The foot of the slope is at a level of 0.
fn problem(phi: f64, beta: f64, height: f64, cohesion: f64, base: Base, far: bool) -> serde_json::Value {
    let run = height / beta.to_radians().tan();
    let (left, right) = (-2.0 * height, run + 2.0 * height);
    let slope = [[left, height], [0.0, height], [run, 0.0]];
    let mut soils = vec![serde_json::json!({
        "name": "sand", "phi_deg": phi, "cohesion_kpa": cohesion, "unit_weight_kn_m3": 18.0
    })];
    let mut regions = Vec::new();
    let side = if far { "far" } else { "smooth" };
    let mut boundaries = vec![serde_json::json!({"kind": side, "sides": ["left", "right"]})];
    match base {
        Base::Rock => {
            regions.push(
                serde_json::json!({"soil": "sand", "polygon": [[left, 0.0], slope[2], slope[1], slope[0]]}),
            );
            boundaries[0] = serde_json::json!({"kind": "smooth", "sides": ["left"]});
            boundaries.push(serde_json::json!({"kind": "fixed", "sides": ["bottom"]}));
        }
        Base::Same => {
            let polygon = [[left, -height], [right, -height], [right, 0.0], slope[2], slope[1], slope[0]];
            regions.push(serde_json::json!({"soil": "sand", "polygon": polygon}));
            boundaries
                .push(serde_json::json!({"kind": side.replace("smooth", "fixed"), "sides": ["bottom"]}));
        }
        Base::Clay(unit_weight) => {
            soils.push(serde_json::json!({
                "name": "clay", "phi_deg": 0.0, "cohesion_kpa": 18.0 * height, "unit_weight_kn_m3": unit_weight
            }));
            regions.push(
                serde_json::json!({"soil": "sand", "polygon": [[left, 0.0], slope[2], slope[1], slope[0]]}),
            );
            let polygon = [[left, -height], [right, -height], [right, 0.0], [left, 0.0]];
            regions.push(serde_json::json!({"soil": "clay", "polygon": polygon}));
            boundaries[0] = serde_json::json!({"kind": "smooth", "sides": ["left", "right"]});
            boundaries.push(serde_json::json!({"kind": "fixed", "sides": ["bottom"]}));
        }
    }
    serde_json::json!({
        "title": "a slope of sand", "default_boundary": "free", "objective": {"kind": "strength-reduction"},
        "soil": soils, "region": regions, "boundary": boundaries
    })
}

/// A slope of sand of 34 deg, 1 in 2 and 4 m high, with water that stands still up to a level in m.
fn under_water(level: f64, base: Base) -> Description {
    let mut problem = problem(34.0, 26.565, 4.0, 0.0, base, false);
    problem["water"] = serde_json::json!({"table": [[0.0, level]]});
    serde_json::from_value(problem).unwrap()
}

/// Work, not time: the same on every machine.
fn bounds(description: &Description, max_gap: f64) -> SafetyBounds {
    let options = Options { max_gap, max_work: 3_000_000, ..Options::default() };
    factor_of_safety(description, &options, &mut |_, _, _| {}).unwrap()
}

/// Proves both sides anew, and checks the stresses from outside.
fn is_proven(bounds: &SafetyBounds) {
    let lower = &bounds.lower;
    let proven = prove_lower(&lower.described.statement, &lower.bound.field).unwrap();
    assert!(proven >= 1.0, "{proven}");
    let upper = &bounds.upper;
    let proven = prove_upper(&upper.described.statement, &upper.bound.field).unwrap();
    assert!(proven < 1.0, "{proven}");
    let regions: Vec<usize> = lower.bound.field.mesh.triangles.iter().map(|t| t.region).collect();
    let worst = balance::worst(&lower.described.statement, &lower.bound.field, &regions);
    assert!(worst.inside < 1e-8 && worst.edges < 1e-9 && worst.strength < 1e-9, "{worst:?}");
}

/// Friction angle and slope in degrees, what is below, and whether the sides are far away.
fn slopes_bear_the_ratio_of_tangents(slopes: &[(f64, f64, Base, bool)]) {
    for &(phi, beta, base, far) in slopes {
        let bounds = bounds(&description(phi, beta, 4.0, 0.0, base, far), 0.03);
        let exact = phi.to_radians().tan() / beta.to_radians().tan();
        let name = format!("{phi} {beta} {base:?}: {} to {}", bounds.lower.factor, bounds.upper.factor);
        assert!(bounds.lower.factor <= exact && exact <= bounds.upper.factor, "{name} {exact}");
        assert!(bounds.gap() <= 0.04, "{name}");
        is_proven(&bounds);
    }
}

#[test]
fn a_slope_of_sand_bears_the_ratio_of_tangents() {
    slopes_bear_the_ratio_of_tangents(&[
        (40.0, 25.0, Base::Same, true),
        (38.0, 33.69, Base::Clay(17.0), false),
    ]);
}

#[test]
#[ignore = "a minute: cargo xtask verify"]
fn exact_ratio_of_tangents_of_one_in_two() {
    slopes_bear_the_ratio_of_tangents(&[
        (34.0, 26.565, Base::Rock, false),
        (34.0, 26.565, Base::Clay(20.0), false),
    ]);
    slopes_under_water_bear_the_ratio_of_tangents(&[(0.0, Base::Same)]);
}

/// Still water takes a part of the weight of the grains, and nothing else. Levels are in m above the foot.
fn slopes_under_water_bear_the_ratio_of_tangents(slopes: &[(f64, Base)]) {
    let exact = 34.0_f64.to_radians().tan() / 26.565_f64.to_radians().tan();
    for &(level, base) in slopes {
        let bounds = bounds(&under_water(level, base), 0.03);
        let name = format!("{level} {base:?}: {} to {}", bounds.lower.factor, bounds.upper.factor);
        assert!(bounds.lower.factor <= exact && exact <= bounds.upper.factor, "{name} {exact}");
        assert!(bounds.gap() <= 0.04, "{name}");
        is_proven(&bounds);
    }
}

#[test]
fn a_slope_under_water_bears_the_ratio_of_tangents() {
    slopes_under_water_bear_the_ratio_of_tangents(&[(5.0, Base::Same), (9.3, Base::Rock)]);
}

/// Where water stands at a part of its height, a slope bears less than dry or drowned: what lies above weighs more than what holds it.
#[test]
fn a_slope_half_under_water_bears_less() {
    let exact = 34.0_f64.to_radians().tan() / 26.565_f64.to_radians().tan();
    let bounds = bounds(&under_water(2.0, Base::Same), 0.08);
    assert!(
        bounds.upper.factor < exact && bounds.gap() <= 0.08,
        "{} {}",
        bounds.lower.factor,
        bounds.upper.factor
    );
    is_proven(&bounds);
}

/// With the pore pressure a part of the overburden, an infinite slope bears `(1 - r / cos(beta)^2) tan(phi) / tan(beta)` (Skempton and
/// DeLory 1957), and one with a foot no more.
#[test]
fn water_in_the_pores_takes_its_part() {
    let (phi, beta, ratio) = (34.0_f64, 26.565_f64, 0.25);
    let mut problem = problem(phi, beta, 4.0, 0.0, Base::Rock, false);
    problem["soil"][0]["pore_pressure_ratio"] = serde_json::json!(ratio);
    let bounds = bounds(&serde_json::from_value(problem).unwrap(), 0.13);
    let (phi, beta) = (phi.to_radians(), beta.to_radians());
    let infinite = (1.0 - ratio / beta.cos().powi(2)) * phi.tan() / beta.tan();
    let name = format!("{} to {}, {infinite}", bounds.lower.factor, bounds.upper.factor);
    assert!(bounds.lower.factor <= infinite && bounds.gap() <= 0.13, "{name}");
    is_proven(&bounds);
}

/// The soil goes on below the wall's foot, and is held there.
#[test]
fn a_smooth_wall_that_gives_way_bears_rankine_s_pressure() {
    let problem = serde_json::json!({
        "default_boundary": "free", "objective": {"kind": "structure", "name": "wall", "direction": [-1, 0]},
        "soil": [{"name": "sand", "phi_deg": 35, "cohesion_kpa": 0, "unit_weight_kn_m3": 2}],
        "region": [{"soil": "sand", "polygon": [[0, -6], [12, -6], [12, 0], [0, 0], [0, -1]]}],
        "boundary": [
            {"kind": "fixed", "sides": ["bottom", "right"]}, {"kind": "fixed", "line": [[0, -6], [0, -1]]}
        ],
        "structure": [{"name": "wall", "edge": [[0, -1], [0, 0]], "delta_deg": 0}]
    });
    let described = serde_json::from_value::<Description>(problem).unwrap().described().unwrap();
    let options = Options { max_gap: 0.01, max_work: 3_000_000, ..Options::default() };
    let bounds = bound(&described.problem().unwrap(), &options, &mut |_, _| {}).unwrap();
    let [lower, upper] = described.in_units([bounds.lower.value, bounds.upper.value]);
    let exact = -(45.0_f64 - 17.5).to_radians().tan().powi(2);
    assert!(lower <= exact && exact <= upper && bounds.gap() <= 0.01, "{lower} {exact} {upper}");
}

#[test]
fn a_slope_steeper_than_its_friction_falls() {
    let bounds = bounds(&description(30.0, 35.0, 3.0, 0.0, Base::Same, true), 0.03);
    assert!(bounds.upper.factor < 1.0, "{}", bounds.upper.factor);
    is_proven(&bounds);
}

#[test]
fn a_little_cohesion_is_a_little_better_than_none() {
    // At least what there is without, and at most what a plane through the foot bears (Culmann 1866).
    let (phi, beta, height) = (34.0_f64, 26.565_f64, 4.0);
    let mut last = phi.to_radians().tan() / beta.to_radians().tan();
    for cohesion in [0.5, 2.0] {
        let bounds = bounds(&description(phi, beta, height, cohesion, Base::Rock, false), 0.05);
        let culmann = |factor: f64| {
            let (beta, phi) = (beta.to_radians(), (phi.to_radians().tan() / factor).atan());
            4.0 * cohesion / factor * beta.sin() * phi.cos() / (1.0 - (beta - phi).cos()) / (18.0 * height)
        };
        assert!(culmann(bounds.lower.factor) >= 1.0, "{cohesion} {}", bounds.lower.factor);
        assert!(bounds.upper.factor > last, "{cohesion} {} {last}", bounds.upper.factor);
        assert!(bounds.gap() < 0.06, "{cohesion} {}", bounds.gap());
        last = bounds.lower.factor;
        is_proven(&bounds);
    }
}

#[test]
fn altered_fields_are_refused_or_still_balance() {
    for ground in [description(38.0, 30.0, 4.0, 0.0, Base::Clay(20.0), false), under_water(5.0, Base::Rock)] {
        alterations_are_refused_or_still_balance(&bounds(&ground, 0.1));
    }
}

fn alterations_are_refused_or_still_balance(found: &SafetyBounds) {
    let statement = &found.lower.described.statement;
    let field = &found.lower.bound.field;
    let regions: Vec<usize> = field.mesh.triangles.iter().map(|t| t.region).collect();
    let mut refused = 0;
    let mut tried = 0;
    for copy in 0..field.copies.len() {
        for by in [1e-7, -0.3, 5.0] {
            let mut altered = field.clone();
            match &mut altered.copies[copy].jet {
                Jet::Free { f, .. }
                | Jet::ManyApexes { f, .. }
                | Jet::OneApex { f, .. }
                | Jet::OneLine { f, .. } => {
                    *f += by * f.abs().max(1e-3);
                }
                other
                @ (Jet::Gauge { .. } | Jet::Zero { .. } | Jet::TwoLines { .. } | Jet::Kinked { .. }) => {
                    *other = Jet::Free { base: 0, f: by, fx: 0.0, fy: by };
                }
            }
            tried += 1;
            match prove_lower(statement, &altered) {
                Ok(_) => {
                    let worst = balance::worst(statement, &altered, &regions);
                    assert!(
                        worst.inside < 1e-8 && worst.edges < 1e-9 && worst.strength < 1e-9,
                        "{copy} {by} {worst:?}"
                    );
                }
                Err(_) => refused += 1,
            }
        }
    }
    assert!(refused > tried / 2, "{refused} of {tried}");
    // A slope a hair steeper is another problem.
    let mut steeper = statement.clone();
    let foot = steeper
        .points
        .iter()
        .map(|p| p[0])
        .enumerate()
        .filter(|(i, _)| steeper.points[*i][1] < steeper.datum);
    let foot = foot.min_by(|a, b| a.1.abs().total_cmp(&b.1.abs())).unwrap().0;
    steeper.points[foot][0] -= 0.01;
    assert!(prove_lower(&steeper, field).is_err());
    // So is one from which the open water is gone, but not the pore water.
    let mut drained = statement.clone();
    let wet = drained.boundaries.iter_mut().filter(|b| b.condition == Condition::Submerged);
    let count = wet.map(|b| b.condition = Condition::Free).count();
    assert!(count == 0 || prove_lower(&drained, field).is_err());
}

/// With friction that differs, whatever lies below: no proof says more than sliding along the slope allows.
#[allow(clippy::print_stdout, reason = "what `--nocapture` is for")]
fn no_proof_says_more(cases: u32) {
    let slopes = (25.0..45.0_f64, 12.0..40.0_f64, 0.5..20.0_f64, 0..4_usize, 14.0..24.0_f64);
    let mut runner =
        TestRunner::new(ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() });
    let gaps = std::cell::RefCell::new(Vec::new());
    let tried = runner.run(&slopes, |(phi, beta, height, kind, weight)| {
        let base = [Base::Rock, Base::Same, Base::Clay(weight), Base::Clay(18.0)][kind];
        let bounds = bounds(&description(phi, beta, height, 0.0, base, matches!(base, Base::Same)), 0.05);
        let exact = phi.to_radians().tan() / beta.to_radians().tan();
        prop_assert!(bounds.lower.factor <= exact, "{} {exact}", bounds.lower.factor);
        prop_assert!(bounds.upper.factor >= bounds.lower.factor);
        is_proven(&bounds);
        gaps.borrow_mut().push(bounds.gap());
        Ok(())
    });
    tried.unwrap();
    let mut gaps = gaps.into_inner();
    gaps.sort_by(f64::total_cmp);
    println!(
        "{} slopes, median gap {:.3}, widest {:.3}",
        gaps.len(),
        gaps[gaps.len() / 2],
        gaps[gaps.len() - 1]
    );
}

#[test]
fn no_proof_says_more_than_the_ratio_of_tangents() {
    no_proof_says_more(1);
}

#[test]
#[ignore = "minutes: cargo xtask verify"]
fn exact_ratio_of_tangents_of_thirty_slopes() {
    no_proof_says_more(30);
}
