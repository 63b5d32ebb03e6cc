//! What it takes to push the plate in: the soil below its edge bears as below a strip footing as wide as the plate is thick, and both faces rub.
//!
//! `w t (gamma H N_q + 1/2 gamma t N_gamma) s` with Reissner's (1924) `N_q`, Vesic's (1973) `N_gamma = 2 (N_q + 1) tan(phi)`, and a factor `s` for an edge
//! that pushes soil aside; beside it `2 K_0 1/2 gamma H^2 w tan(delta)` with Jaky's (1944) `K_0 = 1 - sin(phi)`. Formulas of practice, no bounds.

use crate::{Bite, Soils};

/// Factor of the bearing of a thin edge. Empirical.
const EDGE: f64 = 1.5;

/// Force in N along the plate that pushes it in, in the strongest of all soils; `thickness_m` (m) is the plate's.
#[must_use]
pub fn insertion_n(soils: &Soils, bite: &Bite, thickness_m: f64) -> f64 {
    let delta_rad = soils.delta_deg()[1].to_radians();
    let corners = soils.corners(true, bite.tool_angle_deg, 0.0);
    corners
        .map(|(case, density)| {
            let (phi, weight) = (case.friction.radians(), density * soils.gravity_m_s2());
            let (tan, root) = (libm::tan(phi), libm::tan(std::f64::consts::FRAC_PI_4 + 0.5 * phi));
            let n_q = libm::exp(std::f64::consts::PI * tan) * root * root;
            let n_gamma = 2.0 * (n_q + 1.0) * tan;
            let edge = weight * bite.depth_m * n_q + 0.5 * weight * thickness_m * n_gamma;
            let rub = (1.0 - libm::sin(phi)) * weight * bite.depth_m * bite.depth_m * libm::tan(delta_rad);
            bite.width_m * (EDGE * thickness_m * edge + rub)
        })
        .fold(0.0, f64::max)
}
