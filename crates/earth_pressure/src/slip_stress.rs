//! The normal stress on the slip surfaces ahead of a plate: at which stress the soil's friction is what the plate measures.
//!
//! Where friction depends on stress, the force of a plate is that of a soil with one friction angle: the law's at an equivalent
//! stress. By the theorems of limit analysis a small change of strength changes the limit force by the work that it does in the
//! collapse mechanism. With `gamma'` the rate of slip and `sigma` the normal stress on slip surfaces,
//!
//! ```text
//! dF/dc = integral of gamma'          dF/dtan(phi) = integral of sigma gamma'
//! ```
//!
//! so that their quotient is the mean normal stress where the soil slips, whatever the mechanism. A change of friction that differs from place to
//! place counts by `sigma gamma'`; for a law in the logarithm of stress the equivalent stress is therefore
//! `exp(mean of ln(sigma), weighted by sigma gamma')`. By Jensen's inequality (`x ln x` is convex) it is never below the plain
//! mean. In Rankine's zone, where stress grows evenly from 0 at the surface, it is `2 / sqrt(e) = 1.21` times the mean.

use soilctl_soil::Angle;

use crate::models::{chen_active, chen_passive};
use crate::{Case, EarthPressureError, LoadFactors};

/// Half the step of the derivative by the friction angle, in degrees.
const STEP_DEG: f64 = 0.05;

/// The equivalent stress over the mean normal stress on slip surfaces, between these. Jensen's inequality gives at least 1, Rankine's zone has 1.21,
/// and the fields of both bounds of plates at 60 to 105 deg in soils of 35 to 45 deg have 1.20 to 1.32 (tested in
/// `soilctl-limit-analysis`). What is left on either side is for mechanisms that were not tried, for the soil behind the plate, whose stresses are
/// smaller and friction greater, and for what is not linear in the change of strength: with 1.1 for the lower end, 1,000 laws with forces
/// integrated over Rankine's stresses were not all found.
pub const EQUIVALENT_OVER_MEAN: [f64; 2] = [1.0, 1.5];

/// Mean normal stress on the slip surfaces ahead of a plate over the mean normal pressure that is measured on the plate, ahead less behind,
/// without cohesion and other loads: `(dK / d tan phi) / (K_c K_net cos delta)`, all of Chen & Liu's mechanism ([`crate::ChenLiu`]). Ahead of a
/// smooth upright wall it is `1 - sin phi` (Rankine) times the passive over the net coefficient.
///
/// # Errors
/// As [`crate::ForceModel::predict`] of that model.
pub fn mean_slip_stress_over_pressure(case: &Case) -> Result<f64, EarthPressureError> {
    let phi = case.friction.degrees();
    let delta = case.interface.degrees();
    let passive = |phi: f64| {
        let delta = delta.min(phi);
        let angles = (Angle::from_degrees(phi), Angle::from_degrees(delta));
        chen_passive(&Case { friction: angles.0, interface: angles.1, ..*case })
    };
    let (below, here, above) = (passive(phi - STEP_DEG)?, passive(phi)?, passive(phi + STEP_DEG)?);
    let tangent = |phi: f64| libm::tan(phi.to_radians());
    let by_tangent = (above.weight - below.weight) / (tangent(phi + STEP_DEG) - tangent(phi - STEP_DEG));
    let net = LoadFactors::net(here, chen_active(case)).weight;
    Ok(by_tangent / (here.cohesion * net * libm::cos(case.interface.radians())))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{ChenLiu, ForceModel};
    use proptest::prelude::*;

    #[test]
    fn ahead_of_a_smooth_wall_it_is_rankines() {
        for phi in [20.0, 30.0, 40.0, 48.0] {
            let ratio = mean_slip_stress_over_pressure(&Case::level_deg(90.0, phi, 0.0)).unwrap();
            let sin = libm::sin(f64::to_radians(phi));
            let (passive, active) = ((1.0 + sin) / (1.0 - sin), (1.0 - sin) / (1.0 + sin));
            let rankine = (1.0 - sin) * passive / (passive - active);
            assert!((ratio / rankine - 1.0).abs() < 1e-4, "{phi}: {ratio} {rankine}");
        }
    }

    proptest! {
        /// A soil whose strength is a straight line of stress with cohesion bears, to first order, what one of more friction bears, whose strength
        /// is the same at the mean stress.
        #[test]
        fn a_line_through_the_strength_at_that_stress_bears_the_same(alpha in 50.0..110.0, phi in 25.0..45.0, part in 0.0..0.9) {
            let delta = part * phi;
            prop_assume!(alpha > phi + 5.0);
            let case = Case::level_deg(alpha, phi, delta);
            let ratio = mean_slip_stress_over_pressure(&case).unwrap();
            let force = ChenLiu.predict(&case).unwrap().passive.unwrap();
            // Unit weight and slant length 1: the mean normal pressure.
            let net = ChenLiu.predict(&case).unwrap().net.weight;
            let pressure = 0.5 * net * libm::cos(f64::to_radians(delta));
            let other_phi = phi - 0.02;
            let tangent = |phi: f64| libm::tan(phi.to_radians());
            let cohesion = ratio * pressure * (tangent(phi) - tangent(other_phi));
            let other = ChenLiu.predict(&Case::level_deg(alpha, other_phi, delta)).unwrap().passive.unwrap();
            let bears = 0.5 * other.weight + cohesion * other.cohesion;
            prop_assert!((bears / (0.5 * force.weight) - 1.0).abs() < 1e-5, "{bears} {}", 0.5 * force.weight);
        }
    }
}
