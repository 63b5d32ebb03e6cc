//! The model that the options choose.

use soilctl_earth_pressure::{ForceModel, model, table::TableModel};

use super::Args;
use crate::error::CliError;
use crate::verbs::table::read_table;

/// A model and where it comes from.
pub(super) struct Chosen {
    pub(super) model: Box<dyn ForceModel>,
    pub(super) reference: String,
}

impl Chosen {
    pub(super) fn of(args: &Args) -> Result<Self, CliError> {
        if let Some(path) = &args.model_table {
            let (table, sidecar) = read_table(path)?;
            let reference = format!("{} ({})", sidecar.source, sidecar.name);
            let model = TableModel::new("table-file", "a prediction table read from a file", table);
            return Ok(Self { model: Box::new(model), reference });
        }
        let model = model(&args.model)?;
        let reference = model.reference().to_owned();
        Ok(Self { model, reference })
    }
}
