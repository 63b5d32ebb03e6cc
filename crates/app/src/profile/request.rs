//! What is asked of a profile.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::estimate::{self, Beside};
use crate::request::finite;
use crate::{AppError, TableSource};

/// Whether the ground changes with depth, by strokes at several depths.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
#[group(skip)]
pub struct Request {
    /// Stroke table (CSV) with strokes at two depths or more, best each at the same tool angles
    #[arg(value_hint = clap::ValueHint::AnyPath)]
    pub file: TableSource,

    /// Depths to consider for the next stroke (m), up to 1.5 times the deepest one; default: six, from half the least depth on
    #[arg(long = "next-depth", value_name = "M,...", value_delimiter = ',', value_parser = finite)]
    pub next_depth_m: Vec<f64>,

    #[command(flatten)]
    #[serde(flatten)]
    #[allow(missing_docs)]
    pub estimate: Beside,
}

impl Default for Request {
    fn default() -> Self {
        Self {
            file: estimate::Request::default().file,
            next_depth_m: Vec::new(),
            estimate: Beside::default(),
        }
    }
}

impl Request {
    /// The estimate of one soil, in which strokes of different depths are not taken together.
    pub(super) fn of_one_soil(&self) -> estimate::Request {
        estimate::Request { tells_depths_apart: true, ..self.estimate.request(&self.file) }
    }

    /// Refuses what the model of layers does not know.
    pub(super) fn check(&self) -> Result<(), AppError> {
        let loads = &self.estimate.loads;
        let given = [
            ("--cohesion", loads.cohesion_pa, "Pa"),
            ("--adhesion", loads.adhesion_pa, "Pa"),
            ("--surcharge", loads.surcharge_pa, "Pa"),
            ("--beta", loads.beta_deg, "deg"),
        ];
        match given.into_iter().find(|(_, value, _)| *value != 0.0) {
            Some((option, value, unit)) => Err(AppError::Request(format!(
                "{option} is {value} {unit}; a profile is of level ground without cohesion, adhesion and surcharge, for which its model of layers was \
                 checked, so it must be 0 {unit}; estimate takes others, for one soil"
            ))),
            None => Ok(()),
        }
    }
}
