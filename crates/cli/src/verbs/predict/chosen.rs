//! The model that the options choose.

use soilctl_earth_pressure::{ForceModel, model};

use super::Args;
use crate::error::CliError;
use crate::verbs::table::read_model;

/// A model and where it comes from.
pub(super) struct Chosen {
    pub(super) model: Box<dyn ForceModel>,
    pub(super) reference: String,
}

impl Chosen {
    pub(super) fn of(args: &Args) -> Result<Self, CliError> {
        if let Some(path) = &args.model_table {
            let (model, reference) = read_model(path)?;
            return Ok(Self { model, reference });
        }
        let model = model(&args.model)?;
        let reference = model.reference().to_owned();
        Ok(Self { model, reference })
    }
}
