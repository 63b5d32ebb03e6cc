//! What a question of stability is asked with.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::limits::Budget;
use crate::request::finite;

/// Whether what a problem file describes stands for every soil that explains the strokes, or that was published.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
pub struct Request {
    /// The soils: the JSON answer of `soilctl estimate`, or of `soilctl soils NAME`
    #[arg(value_name = "REGION", value_hint = clap::ValueHint::FilePath)]
    pub region: PathBuf,

    /// The problem file, .toml or .json, which asks for a factor of safety, a factor on live loads or weights, or the force of a structure
    #[arg(value_name = "PROBLEM", value_hint = clap::ValueHint::FilePath)]
    pub problem: PathBuf,

    /// Which soil of the problem is the one that is asked about; needed if it has several
    #[arg(long, value_name = "NAME")]
    pub soil: Option<String>,

    /// Least factor with which it is said to stand, 1 if not given; of a structure the least force (kN/m) that the soil must bear, which has to be given
    #[arg(long, value_name = "FACTOR|KN/M", value_parser = finite, allow_negative_numbers = true)]
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub required: Option<f64>,

    /// Gravity at the problem (m/s2), which makes the unit weight of the soil: 3.71 on Mars, 1.62 on the Moon; by default that of the Earth, or of
    /// where the published soil is
    #[arg(long = "gravity", value_name = "M/S2", value_parser = finite, allow_negative_numbers = true)]
    #[schemars(extend("exclusiveMinimum" = 0.0, "maximum" = 1000.0))]
    pub gravity_m_s2: Option<f64>,

    /// Keep the unit weight of the problem file, as where the soil is wet there and the strokes were made in dry soil
    #[arg(long)]
    pub keep_weight: bool,

    /// Take the friction angle, and the cohesion if it is published, at any stress. Without a law of stress a problem whose stresses are others is refused
    /// otherwise, since friction falls with stress
    #[arg(long)]
    pub constant_friction: bool,

    /// Further soils to try, between the weakest and the strongest, where the answer depends on the soil
    #[arg(long, value_name = "N", default_value_t = Request::default().trials)]
    #[schemars(range(max = 100))]
    pub trials: u32,

    #[command(flatten)]
    #[serde(flatten)]
    #[allow(missing_docs)]
    pub budget: Budget,
}

impl Default for Request {
    fn default() -> Self {
        Self {
            region: PathBuf::new(),
            problem: PathBuf::new(),
            soil: None,
            required: None,
            gravity_m_s2: None,
            keep_weight: false,
            constant_friction: false,
            trials: 4,
            budget: Budget { max_gap: 0.03, ..Budget::default() },
        }
    }
}
