//! What a conversion is asked with.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_drawing::{Reading, Unit};

use crate::AppError;
use crate::request::finite;

/// Makes a problem file of a drawing, or a drawing of a problem file.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
pub struct Request {
    /// A drawing (.dxf, .geojson, .csv), boreholes (.ags), or a problem file (.toml, .json)
    #[arg(value_name = "FILE", value_hint = clap::ValueHint::FilePath)]
    pub file: PathBuf,

    /// What is written: a problem file of a drawing, a drawing of a problem file
    #[arg(long, value_name = "FILE", required = true)]
    pub out: PathBuf,

    /// Write over a file that is there
    #[arg(long)]
    pub replace: bool,

    /// Strengths and weights (.csv) with the columns name, `phi_deg`, `unit_weight_kn_m3` and, if wanted, other keys of a problem's soil; a
    /// name is that of a layer
    #[arg(long, value_name = "FILE", value_hint = clap::ValueHint::FilePath)]
    pub soils: Option<PathBuf>,

    /// Unit of the drawing's coordinates, whatever it says itself: mm, cm, dm, m, km, in or ft
    #[arg(long, value_name = "UNIT")]
    pub unit: Option<String>,

    /// Layer of the water table; by default one whose name says so, such as water, groundwater, phreatic or gwl
    #[arg(long, value_name = "LAYER")]
    pub water: Option<String>,

    /// Layers that are no part of the section (a list with commas)
    #[arg(long, value_name = "LAYER", value_delimiter = ',')]
    pub leave_out: Vec<String>,

    /// Boreholes of an AGS file that the section goes through, in this order (a list with commas); by default all
    #[arg(long, value_name = "HOLE", value_delimiter = ',')]
    pub holes: Vec<String>,

    /// Corners and ends of lines that are as near as this are one, and a corner that is as near to an edge is on it (m)
    #[arg(long = "join", value_name = "M", value_parser = finite, allow_negative_numbers = true, default_value_t = Request::default().join_m)]
    #[schemars(range(min = 0.0, max = 1.0))]
    pub join_m: f64,

    /// How far chords may be from their arcs (m)
    #[arg(long = "chord", value_name = "M", value_parser = finite, allow_negative_numbers = true, default_value_t = Request::default().chord_m)]
    #[schemars(range(min = 0.0001, max = 10.0))]
    pub chord_m: f64,
}

impl Default for Request {
    fn default() -> Self {
        let Reading { join_m, chord_m, .. } = Reading::default();
        Self {
            file: PathBuf::new(),
            out: PathBuf::new(),
            replace: false,
            soils: None,
            unit: None,
            water: None,
            leave_out: Vec::new(),
            holes: Vec::new(),
            join_m,
            chord_m,
        }
    }
}

impl Request {
    /// The unit that was named.
    pub(super) fn unit(&self) -> Result<Option<Unit>, AppError> {
        self.unit.as_deref().map(str::parse).transpose().map_err(AppError::Request)
    }
}
