//! What can be asked of a demonstration.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_campaign::{SoilPreset, presets};
use soilctl_earth_pressure::model;

use crate::AppError;
use crate::request::{Ends, finite};

/// A simulated campaign from the soil to the estimate, compared with the truth.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
#[group(skip)]
pub struct Request {
    /// The soil: ticino_rained, ticino_loose, nevada_fine, glass_beads, or mars_drift, mars_crusty, mars_blocky,
    /// mars_pathfinder under the gravity of Mars, or moon_0_15cm under that of the Moon
    #[arg(long, value_name = "NAME", default_value_t = Request::default().soil)]
    pub soil: String,

    /// Folder for all files; made if it is not there, otherwise it must be empty or hold this demonstration [default: demo/SOIL]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,

    /// Seed of noise and scatter
    #[arg(long, value_name = "N", default_value_t = Request::default().seed)]
    pub seed: u64,

    /// Batches and logs at a time; results are the same for any number [default: all cores]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1024))]
    #[schemars(range(min = 1, max = 1024))]
    pub threads: Option<u32>,

    /// Force model of the simulated soil and of the estimate [default: table, or chen for soils that it does not cover]
    #[arg(long, value_name = "NAME")]
    pub model: Option<String>,

    /// Whether the plate has ends, in the simulated soil and for the estimate [default: finite if the model knows what ends add]
    #[arg(long, value_name = "ENDS")]
    pub ends: Option<Ends>,

    /// Part of what ends add at most that they add in the simulated soil; the estimate does not know it
    #[arg(long, value_name = "PART", default_value_t = Request::default().end_factor, value_parser = finite)]
    #[schemars(range(min = 0.0, max = 1.0))]
    pub end_factor: f64,

    /// Four strokes instead of sixteen: every step in a quarter of the time, but too few to tell much
    #[arg(long)]
    pub quick: bool,
}

impl Default for Request {
    fn default() -> Self {
        Self {
            soil: "ticino_rained".into(),
            out: None,
            seed: 1,
            threads: None,
            model: None,
            ends: None,
            end_factor: 0.5,
            quick: false,
        }
    }
}

/// Friction angles that the table of certified bounds covers, in deg.
const TABLE_PHI_DEG: std::ops::RangeInclusive<f64> = 25.0..=50.0;

impl Request {
    /// The soil of that name.
    pub(super) fn soil(&self) -> Result<SoilPreset, AppError> {
        presets().into_iter().find(|soil| soil.name == self.soil).ok_or_else(|| {
            let known: Vec<String> = presets().into_iter().map(|soil| soil.name).collect();
            AppError::Request(format!("--soil is {}; it must be one of {}", self.soil, known.join(", ")))
        })
    }

    /// Whether plates have ends, and the part of what they add at most that they add in the simulated soil.
    pub(super) fn ends(&self, model_id: &str) -> Result<(Ends, f64), AppError> {
        let ends = Ends::of(self.ends, model(model_id)?.as_ref(), true)?;
        Ok((ends, if ends == Ends::Finite { self.end_factor } else { 0.0 }))
    }

    /// The force model: the table knows no cohesion.
    pub(super) fn model(&self, soil: &SoilPreset) -> String {
        let covered = soil.cohesion_pa == 0.0 && TABLE_PHI_DEG.contains(&soil.phi_deg);
        self.model.clone().unwrap_or_else(|| if covered { "table" } else { "chen" }.to_owned())
    }
}
