//! The model that a request chooses.

use soilctl_earth_pressure::{EarthPressureError, ForceModel, model};
use soilctl_soil::{Plate, WidthRatio};

use super::Request;
use crate::AppError;
use crate::request::Ends;
use crate::table_file::read_model;

/// A model and where it comes from.
pub(super) struct Chosen {
    pub(super) model: Box<dyn ForceModel>,
    pub(super) reference: String,
}

impl Chosen {
    pub(super) fn of(request: &Request) -> Result<Self, AppError> {
        if let Some(path) = &request.model_table {
            let (model, reference) = read_model(path)?;
            return Ok(Self { model, reference });
        }
        let model = model(&request.model)?;
        let reference = model.reference().to_owned();
        Ok(Self { model, reference })
    }

    /// Whether the plate has ends, and its width over depth as the model is asked.
    pub(super) fn ends(
        &self,
        request: &Request,
        plate: Option<&Plate>,
    ) -> Result<(Ends, WidthRatio), EarthPressureError> {
        let model = self.model.as_ref();
        match (Ends::of(request.ends, model, plate.is_some())?, plate) {
            (Ends::None, _) => Ok((Ends::None, WidthRatio::PLANE_STRAIN)),
            (Ends::Finite, Some(plate)) => Ok((Ends::Finite, plate.width_ratio())),
            (Ends::Finite, None) => Err(EarthPressureError::NeedsEnds {
                model: model.id(),
                advice: "give --width and --depth, or --ends none for plane strain",
            }),
        }
    }
}
