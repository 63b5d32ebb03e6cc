//! What can be asked of logs.

use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_jobs::Shard;
use soilctl_soil::STANDARD_GRAVITY_M_S2;

use crate::TableSource;
use crate::request::finite;
use crate::topics::Topics;

/// Failure forces of the strokes in logs, and what they say together.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
#[group(skip)]
pub struct Request {
    /// Logs (.mcap, .db3, .bag, or the folder of a split bag), or folders with logs
    #[arg(required = true, value_name = "LOG")]
    pub logs: Vec<PathBuf>,

    /// Stroke table to write (.csv or .parquet)
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,

    /// Logs that are read at a time; the answer does not depend on it [default: all processors]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1024))]
    #[schemars(range(min = 1, max = 1024))]
    pub threads: Option<u32>,

    /// Reads only each N-th log, starting with the I-th, and writes no table: the same command without this one then takes what
    /// all shards have read, wherever they ran
    #[arg(long, value_name = "I/N", requires = "out")]
    #[schemars(with = "Option<String>")]
    pub shard: Option<Shard>,

    /// Samples a second in traces.csv
    #[arg(long = "trace-rate", value_name = "HZ", default_value_t = Request::default().trace_rate_hz,
          value_parser = finite)]
    #[schemars(extend("exclusiveMinimum" = 0.0, "maximum" = 1e6))]
    pub trace_rate_hz: f64,

    #[command(flatten)]
    #[serde(flatten)]
    #[allow(missing_docs)]
    pub bag: Bag,

    #[command(flatten)]
    #[serde(flatten)]
    #[allow(missing_docs)]
    pub analysis: AnalysisRequest,
}

impl Default for Request {
    fn default() -> Self {
        Self {
            logs: Vec::new(),
            out: None,
            threads: None,
            shard: None,
            trace_rate_hz: 50.0,
            bag: Bag::default(),
            analysis: AnalysisRequest::default(),
        }
    }
}

impl Request {
    /// All logs of a folder, with what they say themselves, into a stroke table.
    #[must_use]
    pub fn of_folder(folder: &Path, out: &Path) -> Self {
        Self { logs: vec![folder.to_owned()], out: Some(out.to_owned()), ..Self::default() }
    }
}

/// What a bag of another program does not say.
#[derive(Debug, Clone, Default, Serialize, Deserialize, JsonSchema, clap::Args)]
#[command(next_help_heading = "Bags of other programs")]
#[serde(default)]
#[group(skip)]
pub struct Bag {
    #[command(flatten)]
    #[serde(flatten)]
    #[allow(missing_docs)]
    pub topics: Topics,

    /// Link at the plate's lower edge, its z axis down along the plate [default: plate_tip]
    #[arg(long, value_name = "LINK")]
    pub plate_frame: Option<String>,

    /// Tool angle (deg) [default: that of the plate frame]
    #[arg(long = "alpha", value_name = "DEG", value_parser = finite)]
    pub alpha_deg: Option<f64>,

    /// Width of the plate (m)
    #[arg(long = "width", value_name = "M", value_parser = finite)]
    pub width_m: Option<f64>,

    /// Interface friction that the controller was set to (deg)
    #[arg(long = "delta-set", value_name = "DEG", value_parser = finite)]
    pub delta_set_deg: Option<f64>,

    /// Readings in free air: FX,FY,FZ or FX,FY,FZ,MX,MY,MZ (N, N m) [default: what free air in the log tells]
    #[arg(long, value_name = "N,N,N", value_delimiter = ',', value_parser = finite, allow_hyphen_values = true)]
    pub tare: Option<Vec<f64>>,

    /// Weight of what the sensor carries (N); it turns with the sensor [default: what free air in several postures tells]
    #[arg(long = "tool-weight", value_name = "N", value_parser = finite)]
    pub tool_weight_n: Option<f64>,

    /// Topic of clouds of points (sensor_msgs/PointCloud2): those before and after each stroke tell where the ground broke, in the columns
    /// `break_distance_m` and `break_distance_sd_m` [default: /points, or the only one]
    #[arg(long, value_name = "TOPIC")]
    pub scan_topic: Option<String>,

    /// What the wrenches are, if not the force of the soil on the plate: then all readings, `--tare` too, change their sign
    #[arg(long, value_enum, value_name = "SENSE", default_value_t)]
    pub wrench_sense: WrenchSense,

    /// CSV with the columns start and end of each push (s, on the clock of the stamps) [default: strokes are looked for]
    #[arg(long, value_name = "FILE")]
    pub strokes: Option<TableSource>,
}

/// Whose force on whom a sensor's driver tells.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema, clap::ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum WrenchSense {
    /// The force of the soil on the plate
    #[default]
    SoilOnPlate,
    /// The force of the plate on the soil
    PlateOnSoil,
}

/// What is made of the strokes.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema, clap::Args)]
#[command(next_help_heading = "Campaign")]
#[serde(default)]
#[group(skip)]
pub struct AnalysisRequest {
    /// Slant length to which forces are scaled (m)
    #[arg(long = "slant", value_name = "M", value_parser = finite, default_value_t = AnalysisRequest::default().slant_m)]
    pub slant_m: f64,

    /// Logs of rubbing a sand-covered plate: the check of the interface friction
    #[arg(long, value_name = "LOG")]
    pub rubbing: Vec<PathBuf>,

    /// Density of the soil (kg/m3): matches a friction angle to the mean force of each tool angle
    #[arg(long = "density", value_name = "KG/M3", value_parser = finite)]
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub density_kg_m3: Option<f64>,

    /// Friction angle (deg) for which the model's forces are compared; needs --density
    #[arg(long = "phi", value_name = "DEG", value_parser = finite, requires = "density_kg_m3")]
    pub phi_deg: Option<f64>,

    /// Interface friction for the comparison (deg) [default: the estimate from the sweep, or the mean set-point]
    #[arg(long = "delta", value_name = "DEG", value_parser = finite)]
    pub delta_deg: Option<f64>,

    /// Gravity for the comparison (m/s2)
    #[arg(long = "gravity", value_name = "M/S2", value_parser = finite,
          default_value_t = AnalysisRequest::default().gravity_m_s2)]
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub gravity_m_s2: f64,

    /// Force model for the comparison
    #[arg(long, value_name = "NAME", default_value_t = AnalysisRequest::default().model)]
    pub model: String,
}

impl Default for AnalysisRequest {
    fn default() -> Self {
        Self {
            slant_m: 0.0254,
            rubbing: Vec::new(),
            density_kg_m3: None,
            phi_deg: None,
            delta_deg: None,
            gravity_m_s2: STANDARD_GRAVITY_M_S2,
            model: "table".to_owned(),
        }
    }
}
