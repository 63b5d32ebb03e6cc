//! Options and answer for raw shear-box records.

use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_direct_shear::DirectShearError;
use soilctl_direct_shear::raw::{
    LoadSummary, RawAnalysis, RawSettings, RunResult, ShearBox, analyse_runs, read_friction_loop, read_runs,
};
use soilctl_soil::STANDARD_GRAVITY_M_S2;

use crate::args::finite;
use crate::error::CliError;

#[derive(Debug, clap::Args)]
pub(super) struct RawArgs {
    /// Raw records instead of FILE: run_id, load_kg, displacement_mm, shear_force_n, vertical_mm (optional)
    #[arg(long, value_name = "RUNS.csv")]
    pub(super) raw: Option<PathBuf>,

    /// Record of the empty box in both directions: displacement_mm, shear_force_n, direction
    #[arg(long = "loop", value_name = "LOOP.csv", requires = "raw")]
    friction_loop: Option<PathBuf>,

    /// Name of the soil in the raw records
    #[arg(long, value_name = "NAME", requires = "raw")]
    pub(super) soil_name: Option<String>,

    /// Area of the shear plane (m2)
    #[arg(long, value_name = "M2", value_parser = finite, allow_negative_numbers = true, requires = "raw",
          default_value_t = ShearBox::default().area_m2)]
    box_area: f64,

    /// Gravity where the box stands (m/s2)
    #[arg(long, value_name = "M/S2", value_parser = finite, allow_negative_numbers = true, requires = "raw",
          default_value_t = STANDARD_GRAVITY_M_S2)]
    box_gravity: f64,

    /// Reading of the load cell without load (N), subtracted from every shear force
    #[arg(long, value_name = "N", value_parser = finite, allow_negative_numbers = true, requires = "raw",
          default_value_t = 0.0)]
    bias: f64,

    /// Forces are smoothed below this normal stress (Pa); 2.5 psi = 17237 Pa if not given
    #[arg(long, value_name = "PA", value_parser = finite, allow_negative_numbers = true, requires = "raw")]
    low_load_limit: Option<f64>,

    /// Of more runs than this at a load, the closest ones are kept
    #[arg(long, value_name = "RUNS", requires = "raw", default_value_t = RawSettings::default().runs_kept)]
    keep: usize,
}

impl RawArgs {
    fn settings(&self) -> RawSettings {
        let usual = RawSettings::default();
        RawSettings {
            shear_box: ShearBox { area_m2: self.box_area, gravity_m_s2: self.box_gravity },
            bias_n: self.bias,
            low_stress_limit_pa: self.low_load_limit.unwrap_or(usual.low_stress_limit_pa),
            runs_kept: self.keep,
            ..usual
        }
    }

    /// Reads and evaluates the records.
    pub(super) fn analyse(&self, path: &Path) -> Result<RawAnalysis, CliError> {
        let settings = self.settings();
        settings.check()?;
        let friction_loop = self.friction_loop.as_ref().map(read_friction_loop).transpose()?;
        // What is wrong with a whole run does not name the file by itself.
        let named = |problem: DirectShearError| match problem {
            DirectShearError::Run { .. } => CliError::Usage(format!("{}, {problem}", path.display())),
            other => other.into(),
        };
        let runs = read_runs(path).map_err(named)?;
        analyse_runs(&runs, friction_loop.as_ref(), &settings).map_err(named)
    }

    pub(super) fn answer(&self, analysis: &RawAnalysis) -> Result<RawAnswer, CliError> {
        let friction_loop = self.friction_loop.as_ref().map(read_friction_loop).transpose()?;
        Ok(RawAnswer {
            box_area_m2: self.box_area,
            box_gravity_m_s2: self.box_gravity,
            bias_n: self.bias,
            machine_friction_n: friction_loop.map(|known| known.half_height_n()),
            low_load_limit_pa: self.settings().low_stress_limit_pa,
            loads: analysis.loads.iter().map(Load::of).collect(),
            runs: analysis.runs.iter().map(Run::of).collect(),
        })
    }
}

/// What raw records show.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct RawAnswer {
    /// Area of the shear plane.
    box_area_m2: f64,
    /// Gravity where the box stands.
    box_gravity_m_s2: f64,
    /// Reading of the load cell without load.
    bias_n: f64,
    /// Half the height of the friction loop; null without one.
    pub(super) machine_friction_n: Option<f64>,
    /// Forces below this normal stress were smoothed.
    low_load_limit_pa: f64,
    /// One entry a load; they are the points of the soil.
    pub(super) loads: Vec<Load>,
    /// One entry a run.
    pub(super) runs: Vec<Run>,
}

/// The kept runs of one load.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Load {
    /// Load.
    pub(super) load_kg: f64,
    /// Normal stress.
    pub(super) normal_stress_pa: f64,
    /// Mean peak friction angle of the kept runs.
    pub(super) friction_angle_deg: f64,
    /// Standard deviation of the kept runs; null for one run.
    pub(super) standard_deviation_deg: Option<f64>,
    /// Largest minus smallest kept angle.
    pub(super) spread_deg: f64,
    /// Names of the kept runs.
    pub(super) kept: Vec<String>,
    /// Names of the dropped runs.
    pub(super) dropped: Vec<String>,
}

impl Load {
    fn of(load: &LoadSummary) -> Self {
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
pub(crate) struct Run {
    /// Name of the run.
    run_id: String,
    /// Load.
    load_kg: f64,
    /// Normal stress.
    normal_stress_pa: f64,
    /// Peak friction angle.
    friction_angle_deg: f64,
    /// By how much machine friction would raise the peak angle; 0 without a friction loop.
    loop_correction_deg: f64,
    /// Displacement at the peak.
    peak_displacement_m: f64,
    /// Whether the peak is the last reading.
    peak_at_end: bool,
    /// Vertical movement up to the peak, upward positive; null if it was not recorded.
    peak_vertical_m: Option<f64>,
    /// Dilation angle at the peak, positive when the soil expands; null if it was not recorded.
    dilation_angle_deg: Option<f64>,
    /// Whether the force was smoothed.
    smoothed: bool,
}

impl Run {
    fn of(run: &RunResult) -> Self {
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
