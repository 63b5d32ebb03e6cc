//! Cuts and slopes of one soil.

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
    brackets(&format!("slope {angle_deg} {phi_deg}"), &bounds, [0.97 * number, number + 0.01], gap);
}

#[test]
fn a_vertical_cut_in_clay_has_its_critical_height() {
    // Martin (2011): between 3.7764 and 3.7776.
    brackets("cut", &solve(slope(soil(0.0, 1.0), 90.0), 1000), [3.7764, 3.7776], 0.06);
}

#[test]
fn a_slope_with_friction_is_as_high_as_rotating_blocks_say() {
    check(45.0, 20.0, 16.16, 1000, 0.05);
}

#[test]
#[ignore = "minutes: cargo xtask verify"]
fn exact_cut() {
    brackets("cut", &solve(slope(soil(0.0, 1.0), 90.0), 4000), [3.7764, 3.7776], 0.015);
}

#[test]
#[ignore = "minutes: cargo xtask verify"]
fn exact_slopes() {
    for (angle_deg, phi_deg, number) in BLOCKS {
        check(angle_deg, phi_deg, number, 2500, 0.025);
    }
}
