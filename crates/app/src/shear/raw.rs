//! Raw shear-box records: what is asked, and the evaluation.

use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_direct_shear::DirectShearError;
use soilctl_direct_shear::raw::{
    RawAnalysis, RawSettings, ShearBox, analyse_runs, read_friction_loop, read_runs,
};
use soilctl_soil::STANDARD_GRAVITY_M_S2;

use super::raw_answer::{Load, RawAnswer, Run};
use crate::AppError;
use crate::request::finite;

/// Raw shear-box records, instead of a table of angles.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
pub struct RawRequest {
    /// Raw records instead of FILE: run_id, load_kg, displacement_mm, shear_force_n, vertical_mm (optional)
    #[arg(long, value_name = "RUNS.csv")]
    pub raw: Option<PathBuf>,

    /// Record of the empty box in both directions: displacement_mm, shear_force_n, direction
    #[arg(long = "loop", value_name = "LOOP.csv", conflicts_with = "file")]
    pub friction_loop: Option<PathBuf>,

    /// Name of the soil in the raw records
    #[arg(long, value_name = "NAME", conflicts_with = "file")]
    pub soil_name: Option<String>,

    /// Area of the shear plane (m2)
    #[arg(long = "box-area", value_name = "M2", value_parser = finite, allow_negative_numbers = true, conflicts_with = "file",
          default_value_t = RawRequest::default().box_area_m2)]
    pub box_area_m2: f64,

    /// Gravity where the box stands (m/s2)
    #[arg(long = "box-gravity", value_name = "M/S2", value_parser = finite, allow_negative_numbers = true,
          conflicts_with = "file", default_value_t = RawRequest::default().box_gravity_m_s2)]
    pub box_gravity_m_s2: f64,

    /// Reading of the load cell without load (N), subtracted from every shear force
    #[arg(long = "bias", value_name = "N", value_parser = finite, allow_negative_numbers = true, conflicts_with = "file",
          default_value_t = RawRequest::default().bias_n)]
    pub bias_n: f64,

    /// Forces are smoothed below this normal stress (Pa); 2.5 psi = 17237 Pa if not given
    #[arg(long = "low-load-limit", value_name = "PA", value_parser = finite, allow_negative_numbers = true,
          conflicts_with = "file")]
    pub low_load_limit_pa: Option<f64>,

    /// Of more runs than this at a load, the closest ones are kept
    #[arg(long, value_name = "RUNS", conflicts_with = "file", default_value_t = RawRequest::default().keep)]
    pub keep: usize,
}

impl Default for RawRequest {
    fn default() -> Self {
        let shear_box = ShearBox::default();
        Self {
            raw: None,
            friction_loop: None,
            soil_name: None,
            box_area_m2: shear_box.area_m2,
            box_gravity_m_s2: STANDARD_GRAVITY_M_S2,
            bias_n: 0.0,
            low_load_limit_pa: None,
            keep: RawSettings::default().runs_kept,
        }
    }
}

/// Evaluated records.
pub(super) struct Evaluated {
    pub(super) analysis: RawAnalysis,
    /// Half the height of the friction loop, if there is one.
    machine_friction_n: Option<f64>,
}

impl RawRequest {
    fn settings(&self) -> RawSettings {
        let usual = RawSettings::default();
        RawSettings {
            shear_box: ShearBox { area_m2: self.box_area_m2, gravity_m_s2: self.box_gravity_m_s2 },
            bias_n: self.bias_n,
            low_stress_limit_pa: self.low_load_limit_pa.unwrap_or(usual.low_stress_limit_pa),
            runs_kept: self.keep,
            ..usual
        }
    }

    /// Reads and evaluates the records.
    pub(super) fn analyse(&self, path: &Path) -> Result<Evaluated, AppError> {
        let settings = self.settings();
        settings.check()?;
        let friction_loop = self.friction_loop.as_ref().map(read_friction_loop).transpose()?;
        // What is wrong with a whole run does not name the file by itself.
        let named = |problem: DirectShearError| match problem {
            DirectShearError::Run { .. } => AppError::Request(format!("{}, {problem}", path.display())),
            other => other.into(),
        };
        let runs = read_runs(path).map_err(named)?;
        let analysis = analyse_runs(&runs, friction_loop.as_ref(), &settings).map_err(named)?;
        Ok(Evaluated { analysis, machine_friction_n: friction_loop.map(|known| known.half_height_n()) })
    }

    /// The answer to evaluated records.
    pub(super) fn answer(&self, evaluated: &Evaluated) -> RawAnswer {
        let settings = self.settings();
        RawAnswer {
            box_area_m2: settings.shear_box.area_m2,
            box_gravity_m_s2: settings.shear_box.gravity_m_s2,
            bias_n: settings.bias_n,
            machine_friction_n: evaluated.machine_friction_n,
            low_load_limit_pa: settings.low_stress_limit_pa,
            loads: evaluated.analysis.loads.iter().map(Load::of).collect(),
            runs: evaluated.analysis.runs.iter().map(Run::of).collect(),
        }
    }
}
