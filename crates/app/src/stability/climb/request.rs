//! What a question of slopes that a wheel climbs is asked with.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::super::request::Request as OfStability;
use crate::limits::Budget;
use crate::request::finite;

/// Up to which slope a wheel or a track climbs on every soil that explains the strokes, or that was published.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
pub struct Request {
    /// The soils: the JSON answer of `soilctl estimate`, or of `soilctl soils NAME`
    #[arg(value_name = "REGION", value_hint = clap::ValueHint::FilePath)]
    pub region: PathBuf,

    /// Weight (N) that one wheel bears on level ground there
    #[arg(long = "wheel-load", value_name = "N", value_parser = finite, allow_negative_numbers = true)]
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub wheel_load_n: f64,

    /// Length (m) over which it touches the ground, along its way
    #[arg(long = "contact-length", value_name = "M", value_parser = finite, allow_negative_numbers = true)]
    #[schemars(range(min = 0.001, max = 100.0))]
    pub contact_length_m: f64,

    /// Width (m) of the wheel
    #[arg(long = "wheel-width", value_name = "M", value_parser = finite, allow_negative_numbers = true)]
    #[schemars(range(min = 0.001, max = 100.0))]
    pub wheel_width_m: f64,

    /// Asks about this slope (deg) alone
    #[arg(long = "slope", value_name = "DEG", value_parser = finite, allow_negative_numbers = true)]
    #[schemars(range(min = 0.0, max = 60.0))]
    pub slope_deg: Option<f64>,

    /// Part of the soil's strength that the wheel's face has, 1 with grousers
    #[arg(long = "bond", value_name = "PART", default_value_t = Request::default().bond_factor, value_parser = finite, allow_negative_numbers = true)]
    #[schemars(extend("exclusiveMinimum" = 0.0, "maximum" = 1.0))]
    pub bond_factor: f64,

    /// Slopes are told to this (deg)
    #[arg(long = "within", value_name = "DEG", default_value_t = Request::default().within_deg, value_parser = finite, allow_negative_numbers = true)]
    #[schemars(range(min = 0.05, max = 20.0))]
    pub within_deg: f64,

    /// Gravity (m/s2), which makes the weight of the soil: 3.71 on Mars, 1.62 on the Moon; by default that of the Earth, or of where the published soil
    /// is
    #[arg(long = "gravity", value_name = "M/S2", value_parser = finite, allow_negative_numbers = true)]
    #[schemars(extend("exclusiveMinimum" = 0.0, "maximum" = 1000.0))]
    pub gravity_m_s2: Option<f64>,

    /// Take the friction angle, and the cohesion if it is published, at any stress. A wheel under which stresses are others is
    /// refused otherwise, since friction falls with stress
    #[arg(long)]
    pub constant_friction: bool,

    #[command(flatten)]
    #[serde(flatten)]
    #[allow(missing_docs)]
    pub budget: Budget,
}

impl Default for Request {
    fn default() -> Self {
        Self {
            region: PathBuf::new(),
            wheel_load_n: 0.0,
            contact_length_m: 0.0,
            wheel_width_m: 0.0,
            slope_deg: None,
            bond_factor: 1.0,
            within_deg: 0.5,
            gravity_m_s2: None,
            constant_friction: false,
            budget: Budget { max_gap: 0.1, ..Budget::default() },
        }
    }
}

impl Request {
    /// Mean pressure on level ground.
    pub(super) fn pressure_pa(&self) -> f64 {
        self.wheel_load_n / (self.contact_length_m * self.wheel_width_m)
    }

    /// The same about one problem.
    pub(super) fn of_stability(&self) -> OfStability {
        OfStability {
            region: self.region.clone(),
            gravity_m_s2: self.gravity_m_s2,
            constant_friction: self.constant_friction,
            trials: 0,
            budget: self.budget.clone(),
            ..OfStability::default()
        }
    }
}
