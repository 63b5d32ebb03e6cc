//! Exact bearing capacity factors of weightless soil, and how much ground they need.

use std::f64::consts::PI;

/// Half of the ground that is modelled, in half-widths: slip lines reach further at high friction angles.
pub(crate) fn size(phi_deg: f64) -> [f64; 2] {
    let phi = phi_deg.to_radians();
    // The spiral's radius grows to this much of the side of the wedge under the strip.
    let reach = (PI / 2.0 * phi.tan()).exp() * (PI / 4.0 + phi / 2.0).tan();
    [2.0 + 2.6 * reach, 1.0 + 1.6 * reach]
}

pub(crate) fn nq(phi_deg: f64) -> f64 {
    let phi = phi_deg.to_radians();
    (PI * phi.tan()).exp() * (1.0 + phi.sin()) / (1.0 - phi.sin())
}

pub(crate) fn nc(phi_deg: f64) -> f64 {
    if phi_deg == 0.0 { 2.0 + PI } else { (nq(phi_deg) - 1.0) / phi_deg.to_radians().tan() }
}
