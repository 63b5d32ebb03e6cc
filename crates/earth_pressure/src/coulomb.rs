//! Coulomb's planar wedge (1776), passive and active.
//!
//! `K_H = sin^2(alpha - phi) / (sin^2(alpha) sin(alpha + delta) (1 -/+ q)^2)`,
//! `q = sqrt(sin(phi + delta) sin(phi + beta) / (sin(alpha + delta) sin(alpha + beta)))`; minus for the passive
//! side, plus for the active one (Terzaghi 1943, p. 105; Hong 2001, eqs 4.10 and 4.12).
//!
//! The wedge itself follows from the equilibrium of a sliding triangle whose plane rises at theta:
//! `P sin(alpha+delta+theta+phi) = (W + Q) sin(theta+phi) + c l cos(phi) - c_a L cos(alpha+theta+phi)`,
//! minimised over theta for the weight W. Writing `y = sin(alpha+delta+theta+phi) / sin(theta-beta)`, P is
//! `a y + b + c/y`, which gives the critical plane in closed form.

use std::f64::consts::PI;

use soilctl_soil::Angle;

use crate::model::{DirectSlice, FailureSurface, ForceModel, ModelSlice, ValidRange};
use crate::{Case, EarthPressureError, LoadFactors, Prediction};

const ID: &str = "coulomb";

/// Coulomb's theory of earth pressure.
#[derive(Debug, Clone, Copy, Default)]
pub struct Coulomb;

impl ForceModel for Coulomb {
    fn id(&self) -> &'static str {
        ID
    }

    fn reference(&self) -> &'static str {
        "Coulomb 1776; Terzaghi 1943, Theoretical Soil Mechanics, p. 105; planar failure surface, too high for \
         delta above phi/3"
    }

    fn valid_range(&self) -> ValidRange {
        ValidRange::closed_form()
    }

    fn has_load_terms(&self, _case: &Case) -> bool {
        true
    }

    fn predict(&self, case: &Case) -> Result<Prediction, EarthPressureError> {
        self.valid_range().check(ID, case)?;
        let passive = wedge_factors(case, passive_plane(case)?, 1.0);
        let active = match active_plane(case) {
            Some(theta) => wedge_factors(&case.mirrored(), theta, -1.0),
            None => LoadFactors::default(),
        };
        Ok(Prediction::from_sides(passive, active))
    }

    fn at(
        &self,
        tool_angle: Angle,
        surface_slope: Angle,
    ) -> Result<Box<dyn ModelSlice + '_>, EarthPressureError> {
        self.valid_range().check_geometry(ID, tool_angle, surface_slope)?;
        Ok(Box::new(DirectSlice { model: self, tool_angle, surface_slope }))
    }

    fn failure_surface(&self, case: &Case) -> Result<Option<FailureSurface>, EarthPressureError> {
        self.valid_range().check(ID, case)?;
        let theta = passive_plane(case)?;
        let (alpha, beta) = (case.tool_angle.radians(), case.surface_slope.radians());
        let reach = (alpha + beta).sin() / (theta - beta).sin();
        let tip = (0.0, 0.0);
        Ok(Some(FailureSurface::from_tip(case, vec![tip, (reach * theta.cos(), reach * theta.sin())])))
    }
}

/// Slope of the critical passive plane.
fn passive_plane(case: &Case) -> Result<f64, EarthPressureError> {
    let (alpha, beta, phi, delta) = radians(case);
    let q =
        ((phi + delta).sin() * (phi + beta).sin() / ((alpha + delta).sin() * (alpha + beta).sin())).sqrt();
    if q.is_nan() || q >= 1.0 || (alpha + beta).sin() <= 0.0 {
        return Err(case.singular(
            ID,
            "a plane failure surface can carry any force here (Coulomb's q reaches 1); use chen or log-spiral",
        ));
    }
    Ok(critical_plane(alpha, beta, phi, delta))
}

/// Slope of the critical active plane, or `None` where the soil behind an overhanging plate stands by itself
/// (alpha <= phi) and pushes with no force.
fn active_plane(case: &Case) -> Option<f64> {
    let (alpha, beta, phi, delta) = radians(&case.mirrored());
    (alpha + phi < PI).then(|| critical_plane(alpha, beta, -phi, -delta))
}

/// The stationary plane; negative friction angles give the active one.
fn critical_plane(alpha: f64, beta: f64, phi: f64, delta: f64) -> f64 {
    let (a, b, c) = (alpha + beta, phi + beta, alpha + delta + phi + beta);
    // y = cos(c) + cot(theta - beta) sin(c), stationary at the positive root on both sides.
    let y = (((phi + delta).sin() * (alpha + delta).sin()) / (a.sin() * b.sin())).max(0.0).sqrt();
    // A smooth plate (phi + delta -> 0) or sin(c) = 0 leaves the closed form; both are limits, reached from
    // a neighbouring angle well below the accuracy of any use.
    let c = if c.sin().abs() < 1e-9 { c + 1e-9 } else { c };
    let cotangent = (y - c.cos()) / c.sin();
    beta + (1.0_f64).atan2(cotangent)
}

/// Load factors on one plane; `sign` is 1 ahead of the plate and -1 behind it.
fn wedge_factors(case: &Case, theta: f64, sign: f64) -> LoadFactors {
    let (alpha, beta, phi, delta) = radians(case);
    let (phi, delta) = (sign * phi, sign * delta);
    let surface = (alpha + theta).sin() / (theta - beta).sin();
    let plane = (alpha + beta).sin() / (theta - beta).sin();
    let scale = 1.0 / (alpha + delta + theta + phi).sin();
    LoadFactors {
        weight: plane * (alpha + theta).sin() * (theta + phi).sin() * scale,
        surcharge: surface * (theta + phi).sin() * scale,
        cohesion: plane * phi.cos() * scale,
        adhesion: -(alpha + theta + phi).cos() * scale,
    }
}

fn radians(case: &Case) -> (f64, f64, f64, f64) {
    let r = Angle::radians;
    (r(case.tool_angle), r(case.surface_slope), r(case.friction), r(case.interface))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_support::rel;
    use proptest::prelude::*;

    /// The published closed form, as an independent check of the wedge.
    fn published_slant(case: &Case, active: bool) -> f64 {
        let (alpha, beta, phi, delta) = radians(case);
        let q = ((phi + delta).sin() * (phi + beta).sin() / ((alpha + delta).sin() * (alpha + beta).sin()))
            .sqrt();
        let bracket = if active { 1.0 + q } else { 1.0 - q };
        (alpha - phi).sin().powi(2) / ((alpha + delta).sin() * bracket * bracket)
    }

    proptest! {
        #[test]
        fn wedge_equals_the_published_formula(alpha in 45.0..115.0, beta in -15.0..15.0, phi in 16.0..44.0, ratio in 0.0..1.0) {
            let case = Case::from_deg(alpha, beta, phi, ratio * phi);
            if let Ok(p) = Coulomb.predict(&case) {
                let passive = published_slant(&case, false);
                prop_assume!(passive < 1e4);
                prop_assert!(rel(p.passive.unwrap().weight, passive) < 1e-6);
                prop_assert!(rel(p.active.unwrap().weight, published_slant(&case, true)) < 1e-6);
            }
        }

        #[test]
        fn no_other_plane_is_lower_or_pushes_harder(alpha in 45.0..115.0, beta in -15.0..15.0, phi in 16.0..44.0, ratio in 0.01..1.0, t in 0.01..0.99) {
            let case = Case::from_deg(alpha, beta, phi, ratio * phi);
            if let Ok(p) = Coulomb.predict(&case) {
                let (a, b, f, d) = radians(&case);
                let theta = b + t * (PI - a - d - f - b);
                if theta > b {
                    prop_assert!(wedge_factors(&case, theta, 1.0).weight >= p.passive.unwrap().weight * (1.0 - 1e-9));
                }
            }
        }
    }

    #[test]
    fn rankine_with_every_load() {
        // Smooth vertical wall: P = 1/2 gamma H^2 N + q H N + 2 c H sqrt(N), and 1/N, -2c/sqrt(N) behind.
        let case = Case::level_deg(90.0, 30.0, 0.0);
        let p = Coulomb.predict(&case).unwrap();
        let (passive, active) = (p.passive.unwrap(), p.active.unwrap());
        assert!(rel(passive.weight, 3.0) < 1e-9 && rel(passive.surcharge, 3.0) < 1e-9);
        assert!(rel(passive.cohesion, 2.0 * 3f64.sqrt()) < 1e-9);
        assert!(rel(active.weight, 1.0 / 3.0) < 1e-9 && rel(active.cohesion, 2.0 / 3f64.sqrt()) < 1e-9);
    }

    #[test]
    fn singular_corner_of_appendix_c_is_an_error() {
        let error = Coulomb.predict(&Case::level_deg(100.0, 50.0, 30.0)).unwrap_err();
        assert!(matches!(error, EarthPressureError::Singular { .. }), "{error}");
    }
}
