//! The model that a request chooses.

use soilctl_earth_pressure::{ForceModel, model};

use super::Request;
use crate::AppError;
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
}
