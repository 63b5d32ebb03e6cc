//! Ovesen & Brinch Hansen's shape factor of an upright anchor slab.
//!
//! Of a slab that reaches to the surface and has no neighbours, Ovesen's tests (1964, Danish Geotechnical Institute,
//! Bulletin 16) fit Brinch Hansen's
//!
//! ```text
//! M = 1 + 1.6 (Kp - Ka)^(2/3) / (1 + 5 w/H)
//! ```
//!
//! times the net force in plane strain; two more terms of it are for slabs whose top is buried, and vanish here. Kp and Ka are
//! the coefficients across the slab; here they are those of `log-spiral` and Chen & Liu's active side. Duncan & Mokwa (2001,
//! Journal of Geotechnical and Geoenvironmental Engineering 127) use it for pile caps and do not let it grow above 2. A fit to
//! tests, no bound. In the limit of a wide plate it is `log-spiral`.

use soilctl_soil::{Angle, WidthRatio};

use super::LogSpiral;
use crate::model::{DirectSlice, FailureSurface, ForceModel, ModelSlice, ValidRange};
use crate::{Case, EarthPressureError, LoadFactors, Prediction};

const ID: &str = "ovesen";

/// Shape factor above which practice does not follow the formula.
const USED_UP_TO: f64 = 2.0;

/// Ovesen & Brinch Hansen's factor on plane strain.
#[derive(Debug, Clone, Copy, Default)]
pub struct Ovesen;

impl ForceModel for Ovesen {
    fn id(&self) -> &'static str {
        ID
    }

    fn reference(&self) -> &'static str {
        "Ovesen 1964, Bulletin 16, Danish Geotechnical Institute, with Brinch Hansen's shape factor of anchor slabs on the \
         coefficients of log-spiral; a fit to tests, no bound"
    }

    fn valid_range(&self) -> ValidRange {
        ValidRange { alpha_deg: (90.0, 90.0), beta_deg: (0.0, 0.0), ..ValidRange::closed_form() }
    }

    fn has_ends(&self) -> bool {
        true
    }

    fn predict(&self, case: &Case) -> Result<Prediction, EarthPressureError> {
        self.valid_range().check(ID, case)?;
        let plane = LogSpiral::CORRECT.predict(case)?;
        let (passive, active) = (plane.passive.unwrap_or_default(), plane.active.unwrap_or_default());
        let net = passive.weight - active.weight;
        let across = net * case.interface.cos();
        let shape =
            1.0 + 1.6 * libm::pow(across, 2.0 / 3.0) / (1.0 + 5.0 / case.width_ratio.depth_over_width());
        // Weight alone: the tests were made in dry sand without surcharge.
        let weight = |weight: f64| LoadFactors { weight, ..LoadFactors::default() };
        let passive = weight(active.weight + shape * net);
        let mut prediction = Prediction::from_sides(ID, case, passive, weight(active.weight))?;
        prediction.notes.push("active side after Chen & Liu, in plane strain");
        if shape > USED_UP_TO {
            prediction.notes.push("the shape factor is above 2, beyond what it is used for");
        }
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
