//! Godwin & Spoor's model of a narrow tine (1977, in its later form): plane-strain factors on a width that the two
//! side crescents enlarge.
//!
//! With m the rupture ratio (reach of the failure at the surface over depth), weight, cohesion and surcharge act on
//! `w + d (m - (m - 1) / 3)` instead of w (Godwin & Spoor 1977, Journal of Agricultural Engineering Research 22,
//! 213-228; Godwin & O'Dogherty 2007, Journal of Terramechanics 44). The plane factors are those of `log-spiral`.
//! Limit equilibrium, no bound. In the limit of a wide plate it is `log-spiral`.
//!
//! Godwin & Spoor read m from a chart of measurements. Here it is 2, which is about what they have for an upright
//! tine; a reader with a measured reach can scale the answer.

use soilctl_soil::{Angle, WidthRatio};

use super::LogSpiral;
use crate::model::{DirectSlice, FailureSurface, ForceModel, ModelSlice, ValidRange};
use crate::{Case, EarthPressureError, LoadFactors, Prediction};

const ID: &str = "godwin-spoor";

/// Reach of the failure at the surface over depth.
const RUPTURE_RATIO: f64 = 2.0;

/// Below this width over depth a tine is longer than its critical depth, and soil fails sideways around its lower part.
const NARROWEST: f64 = 0.2;

/// Godwin & Spoor's plane factors on an enlarged width.
#[derive(Debug, Clone, Copy, Default)]
pub struct GodwinSpoor;

impl ForceModel for GodwinSpoor {
    fn id(&self) -> &'static str {
        ID
    }

    fn reference(&self) -> &'static str {
        "Godwin & Spoor 1977, J. Agric. Eng. Res. 22, with rupture ratio 2 and the factors of log-spiral; limit \
         equilibrium, no bound"
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
        if case.width_ratio.finite().is_some_and(|ratio| ratio < NARROWEST) {
            return Err(case.singular(
                ID,
                "the plate is deeper than five times its width, where soil flows around its lower part; use a wider \
                 plate or blocks-3d",
            ));
        }
        let plane = LogSpiral::CORRECT.predict(case)?;
        let (passive, active) = (plane.passive.unwrap_or_default(), plane.active.unwrap_or_default());
        let crescents = RUPTURE_RATIO - (RUPTURE_RATIO - 1.0) / 3.0;
        let wider = 1.0 + crescents * case.width_ratio.depth_over_width();
        let passive = LoadFactors {
            weight: passive.weight * wider,
            surcharge: passive.surcharge * wider,
            cohesion: passive.cohesion * wider,
            adhesion: passive.adhesion,
        };
        let mut prediction = Prediction::from_sides(ID, case, passive, active)?;
        prediction.notes.push("active side after Chen & Liu, in plane strain");
        Ok(prediction)
    }

    fn failure_surface(&self, case: &Case) -> Result<Option<FailureSurface>, EarthPressureError> {
        self.valid_range().check(ID, case)?;
        LogSpiral::CORRECT.failure_surface(case)
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
