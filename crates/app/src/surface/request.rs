//! What is asked of a failure surface.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::TableSource;
use crate::estimate::{self, Beside};
use crate::request::finite;

/// What the crack ahead of the plate says of the soil, beside what the force says.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
#[group(skip)]
pub struct Request {
    /// Stroke table (CSV) with the columns `break_distance_m` and `break_distance_sd_m`
    #[arg(value_hint = clap::ValueHint::AnyPath)]
    pub file: TableSource,

    /// Standard deviation of break distances (m) where the table does not say
    #[arg(long = "break-sd", value_name = "M", value_parser = finite, allow_negative_numbers = true)]
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub break_sd_m: Option<f64>,

    #[command(flatten)]
    #[serde(flatten)]
    #[allow(missing_docs)]
    pub estimate: Beside,
}

impl Default for Request {
    fn default() -> Self {
        Self { file: estimate::Request::default().file, break_sd_m: None, estimate: Beside::default() }
    }
}
