//! What is asked of places.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_earth_pressure::MODEL_IDS;

use crate::estimate::{self, Uncertainty};
use crate::request::{Ends, Loads, NumberOrColumn, finite, model_help};
use crate::{AppError, TableSource};

/// Whether the soil is the same at several places, what it is at each, and what lies between.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
#[group(skip)]
pub struct Request {
    /// Stroke table (CSV) with the columns `place`, or `place_x_m` and `place_y_m`, or all three
    #[arg(value_hint = clap::ValueHint::AnyPath)]
    pub file: TableSource,

    /// Force model; `table` is the bracket of proven bounds
    #[arg(long, value_name = "NAME", default_value_t = Request::default().model, help = model_help())]
    #[schemars(extend("enum" = MODEL_IDS))]
    pub model: String,

    /// Whether plates have ends, each its own width; by default they have them for the models that know ends
    #[arg(long, value_name = "ENDS")]
    pub ends: Option<Ends>,

    /// Friction angle between soil and plate (deg), or `column` for what the table says of each place
    #[arg(long = "delta", value_name = "DEG|column", default_value_t = Request::default().delta_deg, allow_negative_numbers = true)]
    pub delta_deg: NumberOrColumn,

    /// Half width of what is known of delta (deg)
    #[arg(long = "delta-tol", value_name = "DEG", default_value_t = Request::default().delta_tol_deg, value_parser = finite,
          allow_negative_numbers = true)]
    #[schemars(range(min = 0.0))]
    pub delta_tol_deg: f64,

    /// Bulk density (kg/m3) everywhere, or `column` for density_kg_m3 of each place; left out: unknown
    #[arg(long = "density", value_name = "KG/M3|column", allow_negative_numbers = true)]
    pub density_kg_m3: Option<NumberOrColumn>,

    /// Relative half width of what is known of the density
    #[arg(long, value_name = "FRACTION", default_value_t = Request::default().density_tol, value_parser = finite,
          allow_negative_numbers = true)]
    #[schemars(range(min = 0.0), extend("exclusiveMaximum" = 1.0))]
    pub density_tol: f64,

    /// What the uncertainty of a force means
    #[arg(long, value_name = "KIND", value_enum, default_value_t = Request::default().uncertainty)]
    pub uncertainty: Uncertainty,

    /// Probability with which all bands of a place together hold their true forces, and with which the value between places is in its
    /// interval
    #[arg(long, value_name = "P", value_parser = finite, allow_negative_numbers = true, default_value_t = Request::default().confidence)]
    #[schemars(extend("exclusiveMinimum" = 0.0, "exclusiveMaximum" = 1.0))]
    pub confidence: f64,

    /// Part of the differences that are told which may be none, on average (Benjamini and Hochberg); without meaning for bounds
    #[arg(long, value_name = "PART", value_parser = finite, allow_negative_numbers = true, default_value_t = Request::default().false_discovery)]
    #[schemars(extend("exclusiveMinimum" = 0.0, "exclusiveMaximum" = 1.0))]
    pub false_discovery: f64,

    /// Side of the cells between places (m) [default: about a thirtieth of the ground]
    #[arg(long = "cell", value_name = "M", value_parser = finite, allow_negative_numbers = true)]
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub cell_m: Option<f64>,

    /// How many places to name where a stroke would tell most
    #[arg(long, value_name = "N", default_value_t = Request::default().next_places)]
    #[schemars(range(min = 0, max = 20))]
    pub next_places: u32,

    /// Latitude and longitude (deg, WGS 84) of x = 0 and y = 0, x to the east: coordinates of --geojson are then geographic, as programs
    /// expect them
    #[arg(long, value_name = "LAT,LON", value_delimiter = ',', num_args = 1, value_parser = finite, allow_hyphen_values = true)]
    pub origin_deg: Option<Vec<f64>>,

    /// Writes places and cells as GeoJSON
    #[arg(long, value_name = "FILE")]
    pub geojson: Option<PathBuf>,

    /// Writes the cells as a table (CSV)
    #[arg(long, value_name = "FILE")]
    pub cells: Option<PathBuf>,

    #[command(flatten)]
    #[serde(flatten)]
    #[allow(missing_docs)]
    pub loads: Loads,
}

impl Default for Request {
    fn default() -> Self {
        let of = estimate::Request::default();
        Self {
            file: of.file,
            model: of.model,
            ends: of.ends,
            delta_deg: of.delta_deg,
            delta_tol_deg: of.delta_tol_deg,
            density_kg_m3: of.density_kg_m3,
            density_tol: of.density_tol,
            uncertainty: of.uncertainty,
            confidence: 0.95,
            false_discovery: 0.05,
            cell_m: None,
            next_places: 3,
            origin_deg: None,
            geojson: None,
            cells: None,
            loads: of.loads,
        }
    }
}

impl Request {
    /// The request of an estimate at a place.
    pub(super) fn of_place(&self) -> estimate::Request {
        estimate::Request {
            file: self.file.clone(),
            model: self.model.clone(),
            ends: self.ends,
            delta_deg: self.delta_deg,
            delta_tol_deg: self.delta_tol_deg,
            density_kg_m3: self.density_kg_m3,
            density_tol: self.density_tol,
            uncertainty: self.uncertainty,
            confidence: self.is_statistical().then_some(self.confidence),
            loads: self.loads,
            ..estimate::Request::default()
        }
    }

    /// Whether bands have a probability.
    pub(super) const fn is_statistical(&self) -> bool {
        match self.uncertainty {
            Uncertainty::Sigma => true,
            Uncertainty::Bounds => false,
        }
    }

    /// Latitude and longitude of the origin in deg, if they are given.
    pub(super) fn origin(&self) -> Result<Option<[f64; 2]>, AppError> {
        let Some(given) = &self.origin_deg else { return Ok(None) };
        match given[..] {
            // Near the poles a degree of longitude is no length.
            [lat, lon] if lat.abs() <= 89.0 && lon.abs() <= 180.0 => Ok(Some([lat, lon])),
            _ => Err(AppError::Request(
                "--origin-deg must be LAT,LON in degrees, the latitude -89 to 89 and the longitude -180 to 180, such as 48.15,11.57"
                    .into(),
            )),
        }
    }
}
