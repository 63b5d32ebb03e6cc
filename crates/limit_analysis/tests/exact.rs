//! Bounds on problems whose answer is known, through the whole adaptive run.
#![allow(clippy::unwrap_used, reason = "helpers of tests")]

mod common;

use common::{soil, statement};
use soilctl_certificate::{Condition, Material, Objective, Statement, prove_lower, prove_upper};
use soilctl_limit_analysis::{Bounds, Options, Problem, bound};

/// A run to a mesh size, however slow the machine; what it reports is what the checker proves.
fn solve(statement: Statement, max_elements: usize) -> Bounds {
    let problem = Problem::new(statement).unwrap();
    let options = Options { max_gap: 1e-6, max_seconds: 1e9, max_elements, ..Options::default() };
    let bounds = bound(&problem, &options, &mut |level, gap| {
        eprintln!("{:?} {:?} {gap:?}", level.upper.proven, level.lower.and_then(|l| l.proven));
    })
    .unwrap();
    assert_eq!(prove_lower(problem.statement(), &bounds.lower.field).unwrap(), bounds.lower.value);
    assert_eq!(prove_upper(problem.statement(), &bounds.upper.field).unwrap(), bounds.upper.value);
    for level in &bounds.levels {
        if let Some([by_objectives, by_shares]) = level.identity {
            assert!((by_objectives - by_shares).abs() < 1e-3 * by_objectives.abs(), "{level:?}");
        }
    }
    bounds
}

/// The exact value lies between the bounds, and these within a fraction of it.
fn brackets(bounds: &Bounds, [low, high]: [f64; 2], gap: f64) {
    let (lower, upper) = (bounds.lower.value, bounds.upper.value);
    assert!(lower <= high && upper >= low, "{lower} {upper} against {low} {high}");
    assert!(bounds.gap() < gap, "{lower} {upper}");
}

fn pressed(pressure: f64, live: bool) -> Condition {
    Condition::Loaded { pressure: [pressure; 2], shear: [0.0; 2], live }
}

/// Half of a strip load of half-width one on weightless soil, with a pressure beside it.
fn strip(material: Material, beside: f64) -> Statement {
    let points = [[0.0, 0.0], [0.0, -4.0], [8.0, -4.0], [8.0, 0.0], [1.0, 0.0]];
    statement(&[(&[0, 1, 2, 3, 4], material)], &points, Objective::Loads, |[x, y]| {
        if x == 0.0 {
            Condition::Smooth
        } else if y == 0.0 {
            if x < 1.0 { pressed(1.0, true) } else { pressed(beside, false) }
        } else {
            Condition::Fixed
        }
    })
}

#[test]
fn a_strip_on_clay_carries_prandtls_load() {
    let exact = 2.0 + std::f64::consts::PI;
    brackets(&solve(strip(soil(0.0, 1.0), 0.0), 1500), [exact; 2], 0.02);
}

#[test]
fn strips_on_weightless_soil_carry_prandtls_and_reissners_loads() {
    for phi_deg in [20.0_f64, 30.0] {
        let phi = phi_deg.to_radians();
        let nq = (std::f64::consts::PI * phi.tan()).exp() * (1.0 + phi.sin()) / (1.0 - phi.sin());
        brackets(&solve(strip(soil(phi_deg, 0.0), 1.0), 1200), [nq; 2], 0.08);
        let nc = (nq - 1.0) / phi.tan();
        brackets(&solve(strip(soil(phi_deg, 1.0), 0.0), 1200), [nc; 2], 0.08);
    }
}

#[test]
fn a_vertical_cut_in_clay_has_its_critical_height() {
    let points = [[-3.0, 1.0], [-3.0, -1.5], [2.0, -1.5], [2.0, 0.0], [0.0, 0.0], [0.0, 1.0]];
    let material = Material { unit_weight: 1.0, ..soil(0.0, 1.0) };
    let objective = Objective::Body { gravity: [0.0, -1.0] };
    let cut = statement(&[(&[0, 1, 2, 3, 4, 5], material)], &points, objective, |[x, y]| {
        if (x > 0.0 && y == 0.0) || x == 0.0 || y == 1.0 { Condition::Free } else { Condition::Fixed }
    });
    // Martin (2011): between 3.7764 and 3.7776.
    brackets(&solve(cut, 1500), [3.7764, 3.7776], 0.03);
}

#[test]
fn a_slope_with_friction_has_the_factor_of_rotating_blocks() {
    let points = [[-4.0, 1.0], [-4.0, -2.0], [5.0, -2.0], [5.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    let material = Material { unit_weight: 1.0, ..soil(20.0, 1.0) };
    let objective = Objective::Body { gravity: [0.0, -1.0] };
    let slope = statement(&[(&[0, 1, 2, 3, 4, 5], material)], &points, objective, |[x, y]| {
        let face = x > 0.0 && x < 1.0 && y > 0.0;
        if y == 1.0 || y == 0.0 || face { Condition::Free } else { Condition::Fixed }
    });
    let bounds = solve(slope, 1200);
    // Chen (1975): 16.16 for 45 and 20 degrees, an upper bound that is near the truth.
    assert!(
        bounds.lower.value <= 16.17 && bounds.upper.value > 15.6,
        "{} {}",
        bounds.lower.value,
        bounds.upper.value
    );
    assert!(bounds.gap() < 0.03, "{}", bounds.gap());
}
