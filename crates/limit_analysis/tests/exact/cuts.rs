//! Cuts and slopes of one soil.

use soilctl_certificate::{Condition, Linear, Material, Objective, Statement};

use crate::common::soil;
use crate::grounds::slope;
use crate::{brackets, solve};

/// Slope angle, friction angle, and the least stability number of rotating blocks: gamma H / c. Taylor (1937) without
/// friction, Chen (1975) with; upper bounds that are near the truth, to two decimals.
const BLOCKS: [(f64, f64, f64); 7] = [
    (60.0, 0.0, 5.25),
    (75.0, 0.0, 4.57),
    (60.0, 10.0, 7.26),
    (90.0, 10.0, 4.58),
    (45.0, 20.0, 16.16),
    (60.0, 20.0, 10.39),
    (75.0, 20.0, 7.48),
];

fn check(angle_deg: f64, phi_deg: f64, number: f64, elements: usize, gap: f64) {
    let bounds = solve(slope(soil(phi_deg, 1.0), angle_deg), elements);
    let source = if phi_deg == 0.0 { "Taylor 1937" } else { "Chen 1975" };
    brackets(
        &format!("slope of {angle_deg} deg, phi {phi_deg} deg (rotating blocks, {source})"),
        &bounds,
        [0.97 * number, number + 0.01],
        gap,
    );
}

#[test]
fn a_vertical_cut_in_clay_has_its_critical_height() {
    // Martin (2011): between 3.7764 and 3.7776.
    brackets(
        "vertical cut in clay (Martin 2011)",
        &solve(slope(soil(0.0, 1.0), 90.0), 1000),
        [3.7764, 3.7776],
        0.06,
    );
}

#[test]
fn a_slope_with_friction_is_as_high_as_rotating_blocks_say() {
    check(45.0, 20.0, 16.16, 1000, 0.05);
}

/// The slope with its own weight as a dead load; the factor on all that acts is bounded.
fn standing(phi_deg: f64, angle_deg: f64, unit_weight: f64) -> Statement {
    let mut it = slope(soil(phi_deg, 1.0), angle_deg);
    (it.gravity, it.objective) = ([0.0, -1.0], Objective::Everything);
    it.regions[0].material.unit_weight = unit_weight;
    it
}

#[test]
fn the_factor_on_all_that_acts_is_that_on_the_weight_if_nothing_else_does() {
    for (angle_deg, phi_deg, numbers) in [(90.0, 0.0, [3.7764, 3.7776]), (45.0, 20.0, [0.97 * 16.16, 16.17])]
    {
        let all = solve(standing(phi_deg, angle_deg, 1.0), 1000);
        brackets(
            &format!("slope of {angle_deg} deg, phi {phi_deg} deg, factor on all that acts"),
            &all,
            numbers,
            0.06,
        );
    }
}

#[test]
fn a_slope_under_water_stands_as_one_of_soil_that_is_lighter_by_the_water() {
    let (water, surface) = (0.4, 2.0);
    let lighter = solve(standing(10.0, 60.0, 0.6), 800);
    let mut under = standing(10.0, 60.0, 1.0);
    under.regions[0].material.pore_pressure = Linear { at_origin: water * surface, gradient: [0.0, -water] };
    for b in under.boundaries.iter_mut().filter(|b| b.condition == Condition::Free) {
        let line = under.lines[b.line];
        let pressure = [line.from, line.to].map(|p| water * (surface - under.points[p][1]));
        b.condition = Condition::Loaded { pressure, shear: [0.0; 2], live: false };
    }
    let under = solve(under, 800);
    brackets(
        "slope of 60 deg under water, phi 10 deg (rotating blocks, Chen 1975)",
        &under,
        [0.97 * 7.26 / 0.6, 7.27 / 0.6],
        0.08,
    );
    // The stresses differ by the water's only, the flows do not.
    let near = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 2e-3, "{a} {b}");
    near(under.lower.value, lighter.lower.value);
    near(under.upper.value, lighter.upper.value);
}

/// Soil that bears no tension stands `2 c tan(45 + phi / 2)` over its unit weight high: a thin slab at the face topples and is
/// crushed at its foot (Drucker 1953). With a little tension it is higher, but not as high as with what friction and
/// cohesion allow (Martin 2011; Chen 1975).
#[test]
#[ignore = "minutes: cargo xtask verify"]
fn exact_vertical_cut_in_soil_of_little_tension_is_between_those_without_and_with() {
    for (phi_deg, with) in [(0.0, 3.7776), (20.0, 5.51)] {
        let ground = Material { tension: Some(0.01), ..soil(phi_deg, 1.0) };
        let without = 2.0 * (45.0_f64 + 0.5 * phi_deg).to_radians().tan();
        let bounds = solve(slope(ground, 90.0), 1500);
        brackets(
            &format!(
                "vertical cut, tension of a hundredth of the cohesion, phi {phi_deg} deg (Drucker 1953)"
            ),
            &bounds,
            [without, with],
            0.06,
        );
        assert!(bounds.lower.value > without && bounds.upper.value < 0.9 * with);
    }
}

#[test]
#[ignore = "minutes: cargo xtask verify"]
fn exact_cut() {
    brackets(
        "vertical cut in clay (Martin 2011)",
        &solve(slope(soil(0.0, 1.0), 90.0), 4000),
        [3.7764, 3.7776],
        0.015,
    );
}

#[test]
#[ignore = "minutes: cargo xtask verify"]
fn exact_slopes() {
    for (angle_deg, phi_deg, number) in BLOCKS {
        check(angle_deg, phi_deg, number, 2500, 0.025);
    }
}
