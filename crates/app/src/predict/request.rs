//! What a prediction is asked.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_earth_pressure::{Loads as SoilLoads, MODEL_IDS};
use soilctl_soil::SoilError;

use crate::request::{Ends, Loads, NumberOrColumn, finite, model_help, slopes};
use crate::{AppError, TableSource};

/// Force and coefficients of a plate from a named model.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
pub struct Request {
    /// Force model
    #[arg(long, value_name = "NAME", default_value_t = Request::default().model, help = model_help())]
    #[schemars(extend("enum" = MODEL_IDS))]
    pub model: String,

    /// A table file (.csv or .parquet) as the model
    #[arg(long, value_name = "FILE", conflicts_with = "model")]
    pub model_table: Option<PathBuf>,

    /// Tool angle from the horizontal (deg)
    #[arg(long = "alpha", value_name = "DEG", value_parser = finite, allow_negative_numbers = true,
          required_unless_present = "strokes", conflicts_with = "strokes")]
    pub alpha_deg: Option<f64>,

    /// A model file, such as the patch of `diagnose`: force model, soil and effects; --phi, --delta and --density
    /// replace its values
    #[arg(long, value_name = "PATCH", conflicts_with_all = ["model", "model_table", "cohesion_pa", "adhesion_pa",
          "surcharge_pa", "beta_deg"])]
    pub model_file: Option<PathBuf>,

    /// Internal friction angle of the soil (deg)
    #[arg(long = "phi", value_name = "DEG", value_parser = finite, allow_negative_numbers = true,
          required_unless_present = "model_file")]
    pub phi_deg: Option<f64>,

    /// Friction falls with stress: by so many degrees a decade of normal stress, between LOW and HIGH. --phi is then the friction angle at
    /// --reference-stress
    #[arg(long, value_name = "LOW:HIGH", value_parser = slopes, conflicts_with_all = ["strokes", "model_file"])]
    pub friction_law: Option<(f64, f64)>,

    /// Normal stress (Pa) at which --phi is the friction angle, with --friction-law
    #[arg(long = "reference-stress", value_name = "PA", value_parser = finite, allow_negative_numbers = true, requires = "friction_law")]
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub reference_stress_pa: Option<f64>,

    /// Friction angle between soil and plate (deg), or `column` for delta_set_deg of --strokes
    #[arg(
        long = "delta",
        value_name = "DEG|column",
        allow_negative_numbers = true,
        required_unless_present = "model_file"
    )]
    pub delta_deg: Option<NumberOrColumn>,

    /// Bulk density (kg/m3), or `column` for density_kg_m3 of --strokes
    #[arg(long = "density", value_name = "KG/M3|column", allow_negative_numbers = true)]
    pub density_kg_m3: Option<NumberOrColumn>,

    /// Vertical depth of the plate's lower edge below the surface (m)
    #[arg(long = "depth", value_name = "M", value_parser = finite, allow_negative_numbers = true,
          conflicts_with = "strokes")]
    pub depth_m: Option<f64>,

    /// Width of the plate (m)
    #[arg(long = "width", value_name = "M", value_parser = finite, allow_negative_numbers = true,
          conflicts_with = "strokes")]
    pub width_m: Option<f64>,

    /// Whether the plate has ends; by default it has them for the models that know ends: mckyes, perumpral, godwin-spoor, ovesen
    /// and blocks-3d, which then take width and depth, and `table` where these are given
    #[arg(long, value_name = "ENDS", conflicts_with = "model_file")]
    pub ends: Option<Ends>,

    #[command(flatten)]
    #[serde(flatten)]
    #[allow(missing_docs)]
    pub loads: Loads,

    /// A stroke table: one prediction a row, with alpha, depth and width from the file
    #[arg(long, value_name = "FILE", value_hint = clap::ValueHint::AnyPath)]
    pub strokes: Option<TableSource>,
}

impl Default for Request {
    fn default() -> Self {
        Self {
            model: "chen".into(),
            model_table: None,
            alpha_deg: None,
            model_file: None,
            phi_deg: None,
            friction_law: None,
            reference_stress_pa: None,
            delta_deg: None,
            density_kg_m3: None,
            depth_m: None,
            width_m: None,
            ends: None,
            loads: Loads::default(),
            strokes: None,
        }
    }
}

impl Request {
    /// The friction angle; required wherever it is asked for.
    pub(super) fn phi(&self) -> Result<f64, AppError> {
        self.phi_deg.ok_or_else(|| AppError::Request("give --phi DEG".into()))
    }

    /// Where the interface friction comes from; required wherever it is asked for.
    pub(super) fn delta(&self) -> Result<NumberOrColumn, AppError> {
        self.delta_deg.ok_or_else(|| AppError::Request("give --delta DEG".into()))
    }

    /// The loads, checked.
    pub(super) fn checked_loads(&self) -> Result<SoilLoads, SoilError> {
        let surcharge = self.loads.surcharge_pa;
        if surcharge < 0.0 {
            return Err(SoilError::OutOfRange {
                quantity: "surcharge",
                value: surcharge,
                unit: "Pa",
                allowed: "at least 0 Pa",
            });
        }
        Ok(self.loads.into())
    }
}
