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

use soilctl_soil::{Angle, WidthRatio};

use crate::model::{DirectSlice, FailureSurface, ForceModel, ModelSlice, ValidRange};
use crate::turn::Turn;
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
        Prediction::from_sides(ID, case, Wedge::ahead(case)?.critical(), Self::active(case))
    }

    fn at(
        &self,
        tool_angle: Angle,
        surface_slope: Angle,
        width_ratio: WidthRatio,
    ) -> Result<Box<dyn ModelSlice + '_>, EarthPressureError> {
        DirectSlice::boxed(self, tool_angle, surface_slope, width_ratio)
    }

    fn failure_surface(&self, case: &Case) -> Result<Option<FailureSurface>, EarthPressureError> {
        self.valid_range().check(ID, case)?;
        let wedge = Wedge::ahead(case)?;
        let above_surface = wedge.critical_plane();
        let theta = wedge.beta + above_surface;
        let reach = (wedge.alpha + wedge.beta).sin / above_surface.sin;
        let tip = (0.0, 0.0);
        Ok(Some(FailureSurface::from_tip(case, vec![tip, (reach * theta.cos, reach * theta.sin)])))
    }
}

impl Coulomb {
    /// Active factors. The soil behind an overhanging plate (alpha <= phi) stands by itself and pushes with no force.
    pub(super) fn active(case: &Case) -> LoadFactors {
        let stands = case.tool_angle.radians() <= case.friction.radians();
        if stands { LoadFactors::default() } else { Wedge::of(case).behind().critical() }
    }
}

/// The four angles, as the sliding wedge sees them.
#[derive(Debug, Clone, Copy)]
pub(super) struct Wedge {
    alpha: Turn,
    beta: Turn,
    phi: Turn,
    delta: Turn,
}

impl Wedge {
    pub(super) fn of(case: &Case) -> Self {
        let turn = |angle: Angle| Turn::of(angle.radians());
        Self {
            alpha: turn(case.tool_angle),
            beta: turn(case.surface_slope),
            phi: turn(case.friction),
            delta: turn(case.interface),
        }
    }

    /// The passive wedge, if a plane has a finite force.
    fn ahead(case: &Case) -> Result<Self, EarthPressureError> {
        let wedge = Self::of(case);
        let Self { alpha, beta, phi, delta } = wedge;
        let a = (alpha + beta).sin;
        let q = ((phi + delta).sin * (phi + beta).sin / ((alpha + delta).sin * a)).sqrt();
        // What rounding makes of 1, where the force is infinite, is 1.
        if q.is_nan() || q > 1.0 - 1e-9 || a <= 0.0 {
            return Err(case.singular(
                ID,
                "a plane failure surface can carry any force here (Coulomb's q reaches 1); use chen or log-spiral",
            ));
        }
        Ok(wedge)
    }

    /// The active wedge: mirrored, and friction acts the other way.
    fn behind(self) -> Self {
        Self { alpha: self.alpha.supplement(), beta: -self.beta, phi: -self.phi, delta: -self.delta }
    }

    /// The stationary plane, less the slope of the surface.
    fn critical_plane(&self) -> Turn {
        let Self { alpha, beta, phi, delta } = *self;
        let (a, b, plate) = (alpha + beta, phi + beta, alpha + delta);
        // y = cos(c) + cot(theta - beta) sin(c), stationary at the positive root on both sides.
        let y = (((phi + delta).sin * plate.sin) / (a.sin * b.sin)).max(0.0).sqrt();
        // A smooth plate (phi + delta -> 0) or sin(c) = 0 leaves the closed form; both are limits, reached from
        // a neighbouring angle well below the accuracy of any use.
        let c = plate + b;
        let c = if c.sin.abs() < 1e-9 { c + Turn { sin: 1e-9, cos: 1.0 } } else { c };
        Turn::with_cotangent((y - c.cos) / c.sin)
    }

    fn critical(&self) -> LoadFactors {
        self.factors(self.critical_plane())
    }

    /// Load factors on the plane that is this much steeper than the surface.
    pub(super) fn factors(&self, above_surface: Turn) -> LoadFactors {
        let Self { alpha, beta, phi, delta } = *self;
        let theta = beta + above_surface;
        let (sum, rise) = (alpha + theta, theta + phi);
        let surface = sum.sin / above_surface.sin;
        let plane = (alpha + beta).sin / above_surface.sin;
        let scale = 1.0 / (alpha + delta + rise).sin;
        LoadFactors {
            weight: plane * sum.sin * rise.sin * scale,
            surcharge: surface * rise.sin * scale,
            cohesion: plane * phi.cos * scale,
            adhesion: -(sum + phi).cos * scale,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_support::rel;
    use proptest::prelude::*;
    use std::f64::consts::PI;

    fn radians(case: &Case) -> (f64, f64, f64, f64) {
        let r = Angle::radians;
        (r(case.tool_angle), r(case.surface_slope), r(case.friction), r(case.interface))
    }

    /// The published closed form, as an independent check of the wedge.
    fn published_slant(case: &Case, active: bool) -> f64 {
        let (alpha, beta, phi, delta) = radians(case);
        let q = (libm::sin(phi + delta) * libm::sin(phi + beta)
            / (libm::sin(alpha + delta) * libm::sin(alpha + beta)))
        .sqrt();
        let bracket = if active { 1.0 + q } else { 1.0 - q };
        libm::sin(alpha - phi).powi(2) / (libm::sin(alpha + delta) * bracket * bracket)
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
                    prop_assert!(Wedge::of(&case).factors(Turn::of(theta - b)).weight >= p.passive.unwrap().weight * (1.0 - 1e-9));
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
