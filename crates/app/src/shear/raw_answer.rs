//! The answer to raw shear-box records.

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_direct_shear::raw::{LoadSummary, RunResult};

/// What raw records show.
#[derive(Debug, Serialize, JsonSchema)]
pub struct RawAnswer {
    /// Area of the shear plane.
    pub box_area_m2: f64,
    /// Gravity where the box stands.
    pub box_gravity_m_s2: f64,
    /// Reading of the load cell without load.
    pub bias_n: f64,
    /// Half the height of the friction loop; null without one.
    pub machine_friction_n: Option<f64>,
    /// Forces below this normal stress were smoothed.
    pub low_load_limit_pa: f64,
    /// One entry a load; they are the points of the soil.
    pub loads: Vec<Load>,
    /// One entry a run.
    pub runs: Vec<Run>,
}

/// The kept runs of one load.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Load {
    /// Load.
    pub load_kg: f64,
    /// Normal stress.
    pub normal_stress_pa: f64,
    /// Mean peak friction angle of the kept runs.
    pub friction_angle_deg: f64,
    /// Standard deviation of the kept runs; null for one run.
    pub standard_deviation_deg: Option<f64>,
    /// Largest minus smallest kept angle.
    pub spread_deg: f64,
    /// Names of the kept runs.
    pub kept: Vec<String>,
    /// Names of the dropped runs.
    pub dropped: Vec<String>,
}

impl Load {
    pub(super) fn of(load: &LoadSummary) -> Self {
        Self {
            load_kg: load.load_kg,
            normal_stress_pa: load.normal_stress_pa,
            friction_angle_deg: load.friction.degrees(),
            standard_deviation_deg: load.standard_deviation_deg,
            spread_deg: load.spread_deg,
            kept: load.kept.clone(),
            dropped: load.dropped.clone(),
        }
    }
}

/// What one run shows.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Run {
    /// Name of the run.
    pub run_id: String,
    /// Load.
    pub load_kg: f64,
    /// Normal stress.
    pub normal_stress_pa: f64,
    /// Peak friction angle.
    pub friction_angle_deg: f64,
    /// By how much machine friction would raise the peak angle; 0 without a friction loop.
    pub loop_correction_deg: f64,
    /// Displacement at the peak.
    pub peak_displacement_m: f64,
    /// Whether the peak is the last reading.
    pub peak_at_end: bool,
    /// Vertical movement up to the peak, upward positive; null if it was not recorded.
    pub peak_vertical_m: Option<f64>,
    /// Dilation angle at the peak, positive when the soil expands; null if it was not recorded.
    pub dilation_angle_deg: Option<f64>,
    /// Whether the force was smoothed.
    pub smoothed: bool,
}

impl Run {
    pub(super) fn of(run: &RunResult) -> Self {
        Self {
            run_id: run.run_id.clone(),
            load_kg: run.load_kg,
            normal_stress_pa: run.normal_stress_pa,
            friction_angle_deg: run.friction.degrees(),
            loop_correction_deg: run.loop_correction_deg,
            peak_displacement_m: run.peak_displacement_m,
            peak_at_end: run.peak_at_end,
            peak_vertical_m: run.peak_vertical_m,
            dilation_angle_deg: run.dilation.map(|angle| angle.degrees()),
            smoothed: run.smoothed,
        }
    }
}
