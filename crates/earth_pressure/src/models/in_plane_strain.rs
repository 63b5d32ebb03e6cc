//! A model asked about plates without ends.

use soilctl_soil::{Angle, Provenance, WidthRatio};

use crate::model::{FailureSurface, ForceModel, ModelSlice, ValidRange};
use crate::{Case, EarthPressureError, Prediction};

/// A model that is asked about plane strain, however wide the plates are.
pub struct InPlaneStrain(Box<dyn ForceModel>);

impl InPlaneStrain {
    /// The model without ends; itself if it has none.
    #[must_use]
    pub fn of(model: Box<dyn ForceModel>) -> Box<dyn ForceModel> {
        if model.has_ends() { Box::new(Self(model)) } else { model }
    }
}

fn plane(case: &Case) -> Case {
    case.with_width_ratio(WidthRatio::PLANE_STRAIN)
}

impl ForceModel for InPlaneStrain {
    fn id(&self) -> &'static str {
        self.0.id()
    }

    fn reference(&self) -> &'static str {
        self.0.reference()
    }

    fn provenance(&self) -> Provenance {
        self.0.provenance()
    }

    fn valid_range(&self) -> ValidRange {
        self.0.valid_range()
    }

    fn is_slow(&self) -> bool {
        self.0.is_slow()
    }

    fn has_load_terms(&self, case: &Case) -> bool {
        self.0.has_load_terms(&plane(case))
    }

    fn interpolates(&self) -> bool {
        self.0.interpolates()
    }

    fn predict(&self, case: &Case) -> Result<Prediction, EarthPressureError> {
        self.0.predict(&plane(case))
    }

    fn failure_surface(&self, case: &Case) -> Result<Option<FailureSurface>, EarthPressureError> {
        self.0.failure_surface(&plane(case))
    }

    fn at(
        &self,
        tool_angle: Angle,
        surface_slope: Angle,
        _width_ratio: WidthRatio,
    ) -> Result<Box<dyn ModelSlice + '_>, EarthPressureError> {
        self.0.at(tool_angle, surface_slope, WidthRatio::PLANE_STRAIN)
    }
}
