//! A force model that stops answering when the user wants an end: what asks it then ends soon.

use std::sync::atomic::{AtomicBool, Ordering};

use soilctl_earth_pressure::{
    Case, EarthPressureError, FailureSurface, ForceModel, ModelSlice, NetFactors, Prediction, ValidRange,
};
use soilctl_soil::{Angle, Provenance, WidthRatio};

/// A model and the flag that is set when its answers are no longer wanted.
pub(crate) struct Watched<'a> {
    pub(crate) model: &'a dyn ForceModel,
    pub(crate) stop: &'a AtomicBool,
}

struct WatchedSlice<'a> {
    slice: Box<dyn ModelSlice + 'a>,
    stop: &'a AtomicBool,
}

fn wanted(stop: &AtomicBool) -> Result<(), EarthPressureError> {
    if !stop.load(Ordering::Relaxed) {
        return Ok(());
    }
    // Nobody reads it: the exception that set the flag is what is raised.
    Err(EarthPressureError::UnknownModel { name: "stopped".into(), known: String::new() })
}

impl ForceModel for Watched<'_> {
    fn id(&self) -> &'static str {
        self.model.id()
    }

    fn reference(&self) -> &'static str {
        self.model.reference()
    }

    fn provenance(&self) -> Provenance {
        self.model.provenance()
    }

    fn valid_range(&self) -> ValidRange {
        self.model.valid_range()
    }

    fn has_load_terms(&self, case: &Case) -> bool {
        self.model.has_load_terms(case)
    }

    fn has_ends(&self) -> bool {
        self.model.has_ends()
    }

    fn bounds_ends(&self) -> bool {
        self.model.bounds_ends()
    }

    fn is_for_plane_strain(&self) -> bool {
        self.model.is_for_plane_strain()
    }

    fn is_slow(&self) -> bool {
        self.model.is_slow()
    }

    fn interpolates(&self) -> bool {
        self.model.interpolates()
    }

    fn predict(&self, case: &Case) -> Result<Prediction, EarthPressureError> {
        wanted(self.stop)?;
        self.model.predict(case)
    }

    fn failure_surface(&self, case: &Case) -> Result<Option<FailureSurface>, EarthPressureError> {
        self.model.failure_surface(case)
    }

    fn at(
        &self,
        tool_angle: Angle,
        surface_slope: Angle,
        width_ratio: WidthRatio,
    ) -> Result<Box<dyn ModelSlice + '_>, EarthPressureError> {
        let slice = self.model.at(tool_angle, surface_slope, width_ratio)?;
        Ok(Box::new(WatchedSlice { slice, stop: self.stop }))
    }
}

impl ModelSlice for WatchedSlice<'_> {
    fn net(&self, phi_deg: f64, delta_deg: f64) -> Result<NetFactors, EarthPressureError> {
        wanted(self.stop)?;
        self.slice.net(phi_deg, delta_deg)
    }
}
