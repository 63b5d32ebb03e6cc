//! Perumpral, Grisso & Desai's model (1983): a wedge as wide as the plate, held back on its two vertical sides by
//! earth pressure at rest and by cohesion.
//!
//! A side of the wedge is a triangle of area `r d / 2`. On it act the normal force `K_0 gamma (d/3) (r d/2)`, with
//! `K_0 = 1 - sin(phi)`, and along the failure plane the shear force `S = c r d / 2 + K_0 gamma (d/3) (r d/2) tan(phi)`.
//! The two of them add `2 S cos(phi) / sin(alpha + delta + b + phi)` to the force of Coulomb's wedge; the rise b makes
//! the weight factor least (Perumpral, Grisso & Desai 1983, Transactions of the ASAE 26, 991-995). In the limit of a
//! wide plate it is Coulomb's wedge. Limit equilibrium, no bound.

use soilctl_soil::{Angle, WidthRatio};

use super::wedge_with_ends::{BetweenEnds, failure_surface, predict};
use crate::model::{DirectSlice, FailureSurface, ForceModel, ModelSlice, ValidRange};
use crate::{Case, EarthPressureError, LoadFactors, Prediction};

const ID: &str = "perumpral";

/// Sides hold back a wedge on any failure plane.
const STEEPEST: f64 = std::f64::consts::PI;

/// Perumpral, Grisso & Desai's wedge with forces on its sides.
#[derive(Debug, Clone, Copy, Default)]
pub struct Perumpral;

impl Perumpral {
    fn factors(case: &Case, at: &BetweenEnds) -> LoadFactors {
        let (sin_phi, cos_phi) = libm::sincos(case.friction.radians());
        let at_rest = 1.0 - sin_phi;
        // Slant length 1: the width is the depth divided by `depth_over_width`.
        let side = at.depth * at.reach_over_depth() * at.scale * at.depth_over_width;
        LoadFactors {
            weight: at.wedge.weight + 2.0 / 3.0 * at_rest * at.depth * side * sin_phi,
            cohesion: at.wedge.cohesion + side * cos_phi,
            ..at.wedge
        }
    }
}

impl ForceModel for Perumpral {
    fn id(&self) -> &'static str {
        ID
    }

    fn reference(&self) -> &'static str {
        "Perumpral, Grisso & Desai 1983, Trans. ASAE 26; limit equilibrium of a wedge with forces on its sides, no bound"
    }

    fn valid_range(&self) -> ValidRange {
        ValidRange { beta_deg: (0.0, 0.0), ..ValidRange::closed_form() }
    }

    fn has_ends(&self) -> bool {
        true
    }

    fn has_load_terms(&self, _case: &Case) -> bool {
        true
    }

    fn predict(&self, case: &Case) -> Result<Prediction, EarthPressureError> {
        self.valid_range().check(ID, case)?;
        predict(ID, case, STEEPEST, |at| Self::factors(case, at))
    }

    fn failure_surface(&self, case: &Case) -> Result<Option<FailureSurface>, EarthPressureError> {
        failure_surface(self, case, STEEPEST, |at| Self::factors(case, at))
    }

    fn at(
        &self,
        tool_angle: Angle,
        surface_slope: Angle,
        width_ratio: WidthRatio,
    ) -> Result<Box<dyn ModelSlice + '_>, EarthPressureError> {
        DirectSlice::boxed(self, tool_angle, surface_slope, width_ratio)
    }
}
