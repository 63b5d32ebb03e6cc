//! Rigid footings on heavy sand, smooth and rough: the values of Martin (2005), by the method of characteristics.

use crate::common::soil;
use crate::grounds::{footing, heavy};
use crate::{brackets, solve};

/// Friction angle in degrees, and N_gamma for smooth and rough footings.
const MARTIN: [(f64, f64, f64); 4] = [
    (10.0, 0.280_894, 0.433_187),
    (20.0, 1.578_62, 2.838_94),
    (30.0, 7.653_00, 14.754_3),
    (40.0, 43.186_6, 85.565_6),
];

/// Half of the ground that is modelled, in half-widths.
fn size(phi_deg: f64) -> [f64; 2] {
    match phi_deg {
        phi if phi <= 20.0 => [5.0, 3.0],
        phi if phi <= 30.0 => [8.0, 4.0],
        _ => [16.0, 8.0],
    }
}

fn check(phi_deg: f64, rough: bool, elements: usize, gap: f64) {
    let (_, smooth_value, rough_value) = MARTIN[MARTIN.iter().position(|m| m.0 == phi_deg).unwrap()];
    let (delta_deg, value) = if rough { (phi_deg, rough_value) } else { (0.0, smooth_value) };
    let bounds = solve(footing(heavy(soil(phi_deg, 0.0)), delta_deg, 0.0, size(phi_deg)), elements);
    // The load on a half-width of one is N_gamma; six figures are published.
    let digits = 1e-5 * value;
    let kind = if rough { "rough" } else { "smooth" };
    brackets(
        &format!("{kind} footing on sand, N_gamma, phi {phi_deg} deg (Martin 2005)"),
        &bounds,
        [value - digits, value + digits],
        gap,
    );
}

#[test]
fn footings_on_sand_carry_martins_loads() {
    check(30.0, false, 900, 0.13);
    check(30.0, true, 900, 0.13);
}

#[test]
#[ignore = "minutes: cargo xtask verify"]
fn exact_footings_from_10_to_40_degrees() {
    for (phi_deg, gap) in [(10.0, 0.05), (20.0, 0.05), (30.0, 0.05), (40.0, 0.1)] {
        for rough in [false, true] {
            check(phi_deg, rough, 4000, gap);
        }
    }
}
