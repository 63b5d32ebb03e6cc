//! What bounds on a tool's force are asked.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::AlphaOf;
use crate::limits::Budget;
use crate::request::{Loads, finite};
use crate::table::Nodes;

/// A tool in the ground, the soil around it, and how it moves.
#[derive(Debug, Clone, Default, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
pub struct Setting {
    /// Tool file, .toml, .json or .csv: points from tip to top, or an arc
    #[arg(value_name = "TOOL", value_hint = clap::ValueHint::FilePath)]
    pub file: PathBuf,

    /// Turns the tool so that it has this tool angle from the horizontal (deg), below 90 with the tip ahead; as drawn if not given
    #[arg(long = "alpha", value_name = "DEG", value_parser = finite, allow_negative_numbers = true)]
    #[schemars(range(min = -180.0, max = 180.0))]
    pub alpha_deg: Option<f64>,

    /// What --alpha is the angle of
    #[arg(long, value_name = "WHICH", value_enum, default_value_t, requires = "alpha_deg")]
    pub alpha_of: AlphaOf,

    /// Internal friction angle of the soil (deg), above 0 and below 70
    #[arg(long = "phi", value_name = "DEG", value_parser = finite, allow_negative_numbers = true)]
    #[schemars(extend("exclusiveMinimum" = 0.0, "exclusiveMaximum" = 70.0))]
    pub phi_deg: f64,

    /// Friction angle between soil and tool (deg), at most phi, where the tool file says none
    #[arg(long = "delta", value_name = "DEG", value_parser = finite, allow_negative_numbers = true)]
    #[schemars(range(min = 0.0))]
    pub delta_deg: Option<f64>,

    /// Bulk density (kg/m3)
    #[arg(long = "density", value_name = "KG/M3", value_parser = finite, allow_negative_numbers = true)]
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub density_kg_m3: f64,

    /// Vertical depth of the tool's lowest point below the surface (m); with its highest point at the surface if not given
    #[arg(long = "depth", value_name = "M", value_parser = finite, allow_negative_numbers = true)]
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub depth_m: Option<f64>,

    /// Direction in which the tool moves, from the horizontal (deg): above 0 upwards
    #[arg(long = "direction", value_name = "DEG", default_value_t = Setting::default().direction_deg, value_parser = finite,
          allow_negative_numbers = true)]
    #[schemars(range(min = -90.0, max = 90.0))]
    pub direction_deg: f64,

    #[command(flatten)]
    #[serde(flatten)]
    #[allow(missing_docs)]
    pub loads: Loads,
}

/// Proven lower and upper bounds on the force of a curved blade, a bucket, or any other tool in section, by limit analysis.
#[derive(Debug, Clone, Default, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
pub struct Request {
    #[command(flatten)]
    #[serde(flatten)]
    #[allow(missing_docs)]
    pub setting: Setting,

    #[command(flatten)]
    #[serde(flatten)]
    #[allow(missing_docs)]
    pub budget: Budget,

    /// Width of the tool (m): bounds are of a tool with ends, and with the side plates of its file; a tool without ends, per metre, if not given
    #[arg(long = "width", value_name = "M", value_parser = finite, allow_negative_numbers = true, conflicts_with = "problem")]
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub width_m: Option<f64>,

    /// Also bounds the forces that the soil bears on the tool held against turning, with motions in so many directions; 12 take twelve times as long
    #[arg(long, value_name = "COUNT", value_parser = clap::value_parser!(u32).range(3..=72), conflicts_with = "width_m")]
    #[schemars(range(min = 3, max = 72))]
    pub forces: Option<u32>,

    /// Friction angles of the soil for --table (deg); --phi alone if not given
    #[arg(long = "phis", value_name = "FROM:TO:STEP", requires = "table")]
    #[schemars(with = "Option<String>")]
    pub phis_deg: Option<Nodes>,

    /// Friction angles of interfaces that the tool file leaves out, for --table (deg); --delta alone if not given
    #[arg(long = "deltas", value_name = "FROM:TO:STEP", requires = "table")]
    #[schemars(with = "Option<String>")]
    pub deltas_deg: Option<Nodes>,

    /// Also writes the bounds over friction angles as a table (.csv or .parquet); what it was made from goes beside it, with .json added, and a table that
    /// was broken off is gone on with
    #[arg(long, value_name = "FILE")]
    pub table: Option<PathBuf>,

    /// Saves the fields that prove the bounds, for `soilctl certify`; with --width the upper one in a file beside, NAME.front.json or NAME.blocks.json; with --forces NAME.1.json and so on for the other directions
    #[arg(long, value_name = "FILE")]
    pub save: Option<PathBuf>,

    /// Writes the problem as a problem file (.toml), to be changed and solved by `soilctl solve`
    #[arg(long, value_name = "FILE")]
    pub problem: Option<PathBuf>,
}
