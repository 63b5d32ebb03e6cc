//! What is asked of strokes that may come near something buried.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::process::Bag;
use crate::request::finite;

/// Whether something is buried ahead of strokes: where their force rises beyond what the soil explains, and where a rigid block may be then.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
#[group(skip)]
pub struct Request {
    /// Logs (.mcap, .db3, .bag, or the folder of a split bag), or folders with logs: the strokes to judge
    #[arg(required = true, value_name = "LOG")]
    pub logs: Vec<PathBuf>,

    /// Logs, or folders with logs, of the same plate in the same soil with nothing ahead: what the soil explains. Without them each stroke is compared
    /// with the others of its kind that do not alarm
    #[arg(long, value_name = "LOG")]
    pub reference: Vec<PathBuf>,

    /// Probability that a stroke with nothing ahead alarms
    #[arg(long, value_name = "P", default_value_t = Request::default().false_alarms, value_parser = finite, allow_negative_numbers = true)]
    #[schemars(range(min = 1e-6, max = 0.2))]
    pub false_alarms: f64,

    /// Probability that the region of an alarm holds what bounds and scatter allow
    #[arg(long, value_name = "P", default_value_t = Request::default().confidence, value_parser = finite, allow_negative_numbers = true)]
    #[schemars(range(min = 0.5, max = 0.9999))]
    pub confidence: f64,

    /// Friction angle of the soil, from and to (deg), for the region; by default all of the table of bounds, 30,44
    #[arg(long = "phi", value_name = "DEG,DEG", value_delimiter = ',', num_args = 1, value_parser = finite, allow_negative_numbers = true)]
    pub phi_deg: Vec<f64>,

    /// Logs that are read at a time; the answer does not depend on it [default: all processors]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1024))]
    #[schemars(range(min = 1, max = 1024))]
    pub threads: Option<u32>,

    /// Writes the looks at all strokes as a table (.csv or .parquet)
    #[arg(long, value_name = "FILE")]
    pub table: Option<PathBuf>,

    #[command(flatten)]
    #[serde(flatten)]
    #[allow(missing_docs)]
    pub bag: Bag,
}

impl Default for Request {
    fn default() -> Self {
        Self {
            logs: Vec::new(),
            reference: Vec::new(),
            false_alarms: 0.02,
            confidence: 0.95,
            phi_deg: Vec::new(),
            threads: None,
            table: None,
            bag: Bag::default(),
        }
    }
}
