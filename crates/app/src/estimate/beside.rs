//! What is asked of an estimate that something else is held against: other places, or the crack ahead of the plate.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_earth_pressure::MODEL_IDS;

use super::{Request, Uncertainty};
use crate::TableSource;
use crate::request::{Ends, Loads, NumberOrColumn, finite, model_help};

/// The options of such an estimate: those of [`Request`] that others have too.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
#[group(skip)]
pub struct Beside {
    /// Force model; `table` is the bracket of proven bounds
    #[arg(long, value_name = "NAME", default_value_t = Beside::default().model, help = model_help())]
    #[schemars(extend("enum" = MODEL_IDS))]
    pub model: String,

    /// Whether plates have ends, each its own width; by default they have them for the models that know ends
    #[arg(long, value_name = "ENDS")]
    pub ends: Option<Ends>,

    /// Friction angle between soil and plate (deg), or `column` for what the table says
    #[arg(long = "delta", value_name = "DEG|column", default_value_t = Beside::default().delta_deg, allow_negative_numbers = true)]
    pub delta_deg: NumberOrColumn,

    /// Half width of what is known of delta (deg)
    #[arg(long = "delta-tol", value_name = "DEG", default_value_t = Beside::default().delta_tol_deg, value_parser = finite,
          allow_negative_numbers = true)]
    #[schemars(range(min = 0.0))]
    pub delta_tol_deg: f64,

    /// Bulk density (kg/m3), or `column` for density_kg_m3 of the table; left out: unknown
    #[arg(long = "density", value_name = "KG/M3|column", allow_negative_numbers = true)]
    pub density_kg_m3: Option<NumberOrColumn>,

    /// Relative half width of what is known of the density
    #[arg(long, value_name = "FRACTION", default_value_t = Beside::default().density_tol, value_parser = finite,
          allow_negative_numbers = true)]
    #[schemars(range(min = 0.0), extend("exclusiveMaximum" = 1.0))]
    pub density_tol: f64,

    /// What uncertainties of measurements mean; as bounds, a deviation is a half width
    #[arg(long, value_name = "KIND", value_enum, default_value_t = Beside::default().uncertainty)]
    pub uncertainty: Uncertainty,

    /// Probability with which all bands together hold their true values, at each place; that of intervals between places too
    #[arg(long, value_name = "P", value_parser = finite, allow_negative_numbers = true, default_value_t = Beside::default().confidence)]
    #[schemars(extend("exclusiveMinimum" = 0.0, "exclusiveMaximum" = 1.0))]
    pub confidence: f64,

    #[command(flatten)]
    #[serde(flatten)]
    #[allow(missing_docs)]
    pub loads: Loads,
}

impl Default for Beside {
    fn default() -> Self {
        let of = Request::default();
        Self {
            model: of.model,
            ends: of.ends,
            delta_deg: of.delta_deg,
            delta_tol_deg: of.delta_tol_deg,
            density_kg_m3: of.density_kg_m3,
            density_tol: of.density_tol,
            uncertainty: of.uncertainty,
            confidence: 0.95,
            loads: of.loads,
        }
    }
}

impl Beside {
    /// The request of the estimate from a table.
    pub(crate) fn request(&self, file: &TableSource) -> Request {
        Request {
            file: file.clone(),
            model: self.model.clone(),
            ends: self.ends,
            delta_deg: self.delta_deg,
            delta_tol_deg: self.delta_tol_deg,
            density_kg_m3: self.density_kg_m3,
            density_tol: self.density_tol,
            uncertainty: self.uncertainty,
            confidence: self.is_statistical().then_some(self.confidence),
            loads: self.loads,
            ..Request::default()
        }
    }

    /// Whether deviations have a probability.
    pub(crate) const fn is_statistical(&self) -> bool {
        match self.uncertainty {
            Uncertainty::Sigma => true,
            Uncertainty::Bounds => false,
        }
    }
}
