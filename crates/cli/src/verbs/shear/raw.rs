//! Raw shear-box records: the options and the evaluation.

use std::path::{Path, PathBuf};

use soilctl_direct_shear::DirectShearError;
use soilctl_direct_shear::raw::{
    RawAnalysis, RawSettings, ShearBox, analyse_runs, read_friction_loop, read_runs,
};
use soilctl_soil::STANDARD_GRAVITY_M_S2;

use super::raw_answer::{Load, RawAnswer, Run};
use crate::args::finite;
use crate::error::CliError;

#[derive(Debug, clap::Args)]
pub(super) struct RawArgs {
    /// Raw records instead of FILE: run_id, load_kg, displacement_mm, shear_force_n, vertical_mm (optional)
    #[arg(long, value_name = "RUNS.csv")]
    pub(super) raw: Option<PathBuf>,

    /// Record of the empty box in both directions: displacement_mm, shear_force_n, direction
    #[arg(long = "loop", value_name = "LOOP.csv", conflicts_with = "file")]
    friction_loop: Option<PathBuf>,

    /// Name of the soil in the raw records
    #[arg(long, value_name = "NAME", conflicts_with = "file")]
    pub(super) soil_name: Option<String>,

    /// Area of the shear plane (m2)
    #[arg(long, value_name = "M2", value_parser = finite, allow_negative_numbers = true, conflicts_with = "file",
          default_value_t = ShearBox::default().area_m2)]
    box_area: f64,

    /// Gravity where the box stands (m/s2)
    #[arg(long, value_name = "M/S2", value_parser = finite, allow_negative_numbers = true, conflicts_with = "file",
          default_value_t = STANDARD_GRAVITY_M_S2)]
    box_gravity: f64,

    /// Reading of the load cell without load (N), subtracted from every shear force
    #[arg(long, value_name = "N", value_parser = finite, allow_negative_numbers = true, conflicts_with = "file",
          default_value_t = 0.0)]
    bias: f64,

    /// Forces are smoothed below this normal stress (Pa); 2.5 psi = 17237 Pa if not given
    #[arg(long, value_name = "PA", value_parser = finite, allow_negative_numbers = true, conflicts_with = "file")]
    low_load_limit: Option<f64>,

    /// Of more runs than this at a load, the closest ones are kept
    #[arg(long, value_name = "RUNS", conflicts_with = "file", default_value_t = RawSettings::default().runs_kept)]
    keep: usize,
}

/// Evaluated records.
pub(super) struct Evaluated {
    pub(super) analysis: RawAnalysis,
    /// Half the height of the friction loop, if there is one.
    machine_friction_n: Option<f64>,
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
    pub(super) fn analyse(&self, path: &Path) -> Result<Evaluated, CliError> {
        let settings = self.settings();
        settings.check()?;
        let friction_loop = self.friction_loop.as_ref().map(read_friction_loop).transpose()?;
        // What is wrong with a whole run does not name the file by itself.
        let named = |problem: DirectShearError| match problem {
            DirectShearError::Run { .. } => CliError::Usage(format!("{}, {problem}", path.display())),
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
