//! Strip loads on weightless soil: the solutions of Prandtl (1920) and Reissner (1924).

use std::f64::consts::PI;

use crate::common::soil;
use crate::grounds::strip;
use crate::{brackets, solve};

/// Half of the ground that is modelled, in half-widths: slip lines reach further at high friction angles.
fn size(phi_deg: f64) -> [f64; 2] {
    let phi = phi_deg.to_radians();
    // The spiral's radius grows to this much of the side of the wedge under the strip.
    let reach = (PI / 2.0 * phi.tan()).exp() * (PI / 4.0 + phi / 2.0).tan();
    [2.0 + 2.6 * reach, 1.0 + 1.6 * reach]
}

pub(crate) fn nq(phi_deg: f64) -> f64 {
    let phi = phi_deg.to_radians();
    (PI * phi.tan()).exp() * (1.0 + phi.sin()) / (1.0 - phi.sin())
}

fn nc(phi_deg: f64) -> f64 {
    if phi_deg == 0.0 { 2.0 + PI } else { (nq(phi_deg) - 1.0) / phi_deg.to_radians().tan() }
}

fn check_nq(phi_deg: f64, elements: usize, gap: f64) {
    let bounds = solve(strip(soil(phi_deg, 0.0), 1.0, size(phi_deg)), elements);
    brackets(&format!("Nq {phi_deg}"), &bounds, [nq(phi_deg); 2], gap);
}

fn check_nc(phi_deg: f64, elements: usize, gap: f64) {
    let bounds = solve(strip(soil(phi_deg, 1.0), 0.0, size(phi_deg)), elements);
    brackets(&format!("Nc {phi_deg}"), &bounds, [nc(phi_deg); 2], gap);
}

#[test]
fn a_strip_on_clay_carries_prandtls_load() {
    check_nc(0.0, 900, 0.02);
}

#[test]
fn strips_on_weightless_soil_carry_prandtls_and_reissners_loads() {
    check_nq(20.0, 900, 0.08);
    check_nc(30.0, 900, 0.08);
}

#[test]
#[ignore = "minutes: cargo xtask verify"]
fn exact_strips_from_10_to_40_degrees() {
    check_nc(0.0, 3000, 0.008);
    for phi_deg in [10.0, 20.0, 30.0, 40.0] {
        check_nq(phi_deg, 3000, 0.04);
        check_nc(phi_deg, 3000, 0.04);
    }
}
