//! What is asked of direct-shear tests.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_direct_shear::LogLogFit;
use soilctl_soil::units;

use super::{RawRequest, StrokeRequest};
use crate::TableSource;
use crate::request::finite;

/// The friction angle of direct-shear tests against normal stress.
#[derive(Debug, Clone, Default, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
pub struct Request {
    /// Table of friction angles against normal stress
    #[arg(value_name = "FILE", required_unless_present = "raw", conflicts_with = "raw",
          value_hint = clap::ValueHint::AnyPath)]
    pub file: Option<TableSource>,

    /// Only this soil of FILE (may be repeated)
    #[arg(long, value_name = "NAME", conflicts_with = "raw")]
    pub soil: Vec<String>,

    /// The power law is fitted to the loads below this normal stress (Pa); 2.5 psi = 17237 Pa if not given
    #[arg(long = "fit-limit", value_name = "PA", value_parser = finite, allow_negative_numbers = true)]
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub fit_limit_pa: Option<f64>,

    /// Gives the friction angle at this normal stress (Pa; may be repeated, or a list with commas)
    #[arg(long = "stress", value_name = "PA", value_parser = finite, allow_negative_numbers = true, value_delimiter = ',')]
    pub stress_pa: Vec<f64>,

    #[command(flatten, next_help_heading = "Raw records, with --raw instead of FILE")]
    #[serde(flatten)]
    #[allow(missing_docs)]
    pub raw: RawRequest,

    #[command(flatten, next_help_heading = "Stroke of a plate")]
    #[serde(flatten)]
    #[allow(missing_docs)]
    pub stroke: StrokeRequest,
}

impl Request {
    /// The power law is fitted to the loads below this normal stress (Pa).
    pub(super) fn fit_limit_pa(&self) -> f64 {
        self.fit_limit_pa.unwrap_or_else(|| units::psi_to_pa(LogLogFit::DEFAULT_LIMIT_PSI))
    }
}
