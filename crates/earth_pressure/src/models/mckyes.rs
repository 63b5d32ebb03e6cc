//! McKyes & Ali's model of a narrow blade (1977): Coulomb's wedge as wide as the plate, and at each end a crescent of
//! soil on the same failure plane, whose radius swings from ahead to the side.
//!
//! With `r = d (cot(alpha) + cot(b))` the reach of the failure plane and `s = d sqrt(cot(b)^2 + 2 cot(alpha) cot(b))`
//! the greatest sideways reach of a crescent, the wedge's factors grow by `1 + 2 s / (3 w)` for weight and `1 + s / w`
//! for cohesion and surcharge; the rise b makes the weight factor least (McKyes & Ali 1977, Journal of Terramechanics
//! 14, 43-51). In the limit of a wide plate it is Coulomb's wedge.
//!
//! As the failure plane becomes upright the crescents vanish, and with them what the ends cost: for a narrow plate in weak
//! soil the least force may be found there. The prediction has a note then.
//!
//! It is no upper bound: the last radial plane of a crescent slides along the soil beside it without dilating.

use soilctl_soil::{Angle, WidthRatio};

use super::wedge_with_ends::{BetweenEnds, failure_surface, predict};
use crate::model::{DirectSlice, FailureSurface, ForceModel, ModelSlice, ValidRange};
use crate::{Case, EarthPressureError, LoadFactors, Prediction};

const ID: &str = "mckyes";

/// A failure plane that leans back over the plate has no crescents.
const STEEPEST: f64 = std::f64::consts::FRAC_PI_2;

/// McKyes & Ali's wedge with crescents.
#[derive(Debug, Clone, Copy, Default)]
pub struct McKyesAli;

impl McKyesAli {
    fn factors(at: &BetweenEnds) -> LoadFactors {
        let b = at.plane_cot;
        // Upright planes are so to rounding.
        let sideways = (b * (b + 2.0 * at.plate_cot)).max(0.0).sqrt() * at.depth_over_width;
        LoadFactors {
            weight: at.wedge.weight * (1.0 + 2.0 / 3.0 * sideways),
            surcharge: at.wedge.surcharge * (1.0 + sideways),
            cohesion: at.wedge.cohesion * (1.0 + sideways),
            adhesion: at.wedge.adhesion,
        }
    }
}

impl ForceModel for McKyesAli {
    fn id(&self) -> &'static str {
        ID
    }

    fn reference(&self) -> &'static str {
        "McKyes & Ali 1977, J. Terramechanics 14; limit equilibrium of a wedge with two crescents, no bound; for \
         plates that lean back (alpha up to 90 deg)"
    }

    /// A plate that leans forward has crescents without a real radius.
    fn valid_range(&self) -> ValidRange {
        ValidRange { alpha_deg: (20.0, 90.0), beta_deg: (0.0, 0.0), ..ValidRange::closed_form() }
    }

    fn has_ends(&self) -> bool {
        true
    }

    fn has_load_terms(&self, _case: &Case) -> bool {
        true
    }

    fn predict(&self, case: &Case) -> Result<Prediction, EarthPressureError> {
        self.valid_range().check(ID, case)?;
        predict(ID, case, STEEPEST, Self::factors)
    }

    fn failure_surface(&self, case: &Case) -> Result<Option<FailureSurface>, EarthPressureError> {
        failure_surface(self, case, STEEPEST, Self::factors)
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
