//! What is asked of places.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::estimate::{self, Beside};
use crate::request::finite;
use crate::{AppError, TableSource};

/// Whether the soil is the same at several places, what it is at each, and what lies between.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
#[group(skip)]
pub struct Request {
    /// Stroke table (CSV) with the columns `place`, or `place_x_m` and `place_y_m`, or all three
    #[arg(value_hint = clap::ValueHint::AnyPath)]
    pub file: TableSource,

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
    pub estimate: Beside,
}

impl Default for Request {
    fn default() -> Self {
        Self {
            file: estimate::Request::default().file,
            false_discovery: 0.05,
            cell_m: None,
            next_places: 3,
            origin_deg: None,
            geojson: None,
            cells: None,
            estimate: Beside::default(),
        }
    }
}

impl Request {
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
