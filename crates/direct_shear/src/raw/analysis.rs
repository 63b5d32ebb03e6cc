use serde::Serialize;
use soilctl_soil::Angle;

use super::peak::{RunResult, evaluate};
use super::select::{closest, mean_and_deviation};
use super::{FrictionLoop, RawRun, RawSettings};
use crate::degrees;
use crate::error::DirectShearError;
use crate::point::{ShearPoint, ShearSeries};

/// Loads in kg that agree to this fraction are the same load.
const SAME_LOAD: f64 = 1e-6;
/// Spread of repeated tests that the thesis found and Lambe & Whitman call usual (Hong 2001, section 6.6).
const USUAL_SPREAD_DEG: f64 = 2.0;

/// The kept runs of one load.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LoadSummary {
    /// Load in kg.
    pub load_kg: f64,
    /// Normal stress in Pa.
    pub normal_stress_pa: f64,
    /// Mean peak friction angle of the kept runs.
    #[serde(rename = "friction_angle_deg", serialize_with = "degrees::one")]
    pub friction: Angle,
    /// Standard deviation of the kept runs in degrees; `None` for one run. Dropping the odd run makes it smaller than
    /// that of all runs.
    pub standard_deviation_deg: Option<f64>,
    /// Largest minus smallest kept angle in degrees.
    pub spread_deg: f64,
    /// Names of the kept runs.
    pub kept: Vec<String>,
    /// Names of the dropped runs.
    pub dropped: Vec<String>,
}

/// A set of runs, evaluated.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RawAnalysis {
    /// Every run, in the order given.
    pub runs: Vec<RunResult>,
    /// Every load, in increasing order.
    pub loads: Vec<LoadSummary>,
    /// What a reader of the results should know.
    pub warnings: Vec<String>,
}

impl RawAnalysis {
    /// One shear point a load, ready for the fits.
    ///
    /// # Errors
    /// [`DirectShearError::OutOfRange`] if a normal stress is outside the range of [`ShearPoint::new`].
    pub fn series(&self, soil: Option<String>) -> Result<ShearSeries, DirectShearError> {
        let points: Result<_, _> =
            self.loads.iter().map(|load| ShearPoint::new(load.normal_stress_pa, load.friction)).collect();
        Ok(ShearSeries { soil, points: points? })
    }

    /// Number of kept runs behind each point of [`RawAnalysis::series`]: weights for the fits.
    #[must_use]
    #[allow(clippy::cast_precision_loss)]
    pub fn weights(&self) -> Vec<f64> {
        self.loads.iter().map(|load| load.kept.len() as f64).collect()
    }
}

/// Evaluates runs: corrections, peaks, dilation, and the closest runs of each load.
///
/// From every shear force the bias and half the height of the friction loop are subtracted.
///
/// # Errors
/// [`DirectShearError::OutOfRange`] for impossible settings, [`DirectShearError::Run`] if a run has no positive peak,
/// two runs have the same name, or there are none.
pub fn analyse_runs(
    runs: &[RawRun],
    friction_loop: Option<&FrictionLoop>,
    settings: &RawSettings,
) -> Result<RawAnalysis, DirectShearError> {
    settings.check()?;
    if runs.is_empty() {
        let problem = "there are no runs; give at least one".to_owned();
        return Err(DirectShearError::Run { run_id: String::new(), problem });
    }
    for (index, run) in runs.iter().enumerate() {
        if runs[..index].iter().any(|earlier| earlier.run_id() == run.run_id()) {
            let problem = "two runs have this name; rename one".to_owned();
            return Err(DirectShearError::Run { run_id: run.run_id().to_owned(), problem });
        }
    }
    let machine_friction_n = friction_loop.map_or(0.0, |friction_loop| friction_loop.half_height_n());
    let results: Result<Vec<RunResult>, _> =
        runs.iter().map(|run| evaluate(run, machine_friction_n, settings)).collect();
    let results = results?;
    let loads = summarise(&results, settings.runs_kept);
    let mut warnings = Vec::new();
    run_warnings(&results, friction_loop, &mut warnings);
    load_warnings(&loads, settings, &mut warnings);
    Ok(RawAnalysis { runs: results, loads, warnings })
}

fn summarise(results: &[RunResult], keep: usize) -> Vec<LoadSummary> {
    let mut by_load: Vec<&RunResult> = results.iter().collect();
    by_load.sort_by(|a, b| a.load_kg.total_cmp(&b.load_kg));
    by_load
        .chunk_by(|a, b| b.load_kg <= a.load_kg * (1.0 + SAME_LOAD))
        .map(|group| {
            let angles: Vec<f64> = group.iter().map(|run| run.friction.degrees()).collect();
            let (kept, dropped) = closest(&angles, keep);
            let chosen: Vec<f64> = kept.iter().map(|index| angles[*index]).collect();
            let (mean, deviation) = mean_and_deviation(&chosen);
            let names =
                |indices: &[usize]| indices.iter().map(|index| group[*index].run_id.clone()).collect();
            LoadSummary {
                load_kg: group[0].load_kg,
                normal_stress_pa: group[0].normal_stress_pa,
                friction: Angle::from_degrees(mean),
                standard_deviation_deg: deviation,
                spread_deg: chosen.iter().fold(f64::MIN, |a, b| a.max(*b))
                    - chosen.iter().fold(f64::MAX, |a, b| a.min(*b)),
                kept: names(&kept),
                dropped: names(&dropped),
            }
        })
        .collect()
}

fn run_warnings(results: &[RunResult], friction_loop: Option<&FrictionLoop>, warnings: &mut Vec<String>) {
    if friction_loop.is_none() && results.iter().any(|run| run.smoothed) {
        warnings.push(
            "no friction loop: machine friction is still in the angles, which matters at the lowest loads (half to one \
             degree in the thesis)"
                .to_owned(),
        );
    }
    for run in results {
        if run.peak_at_end {
            warnings.push(format!(
                "run `{}`: the largest force is the last reading, so the peak may lie beyond the record",
                run.run_id
            ));
        }
        if let Some((from_m, to_m)) = friction_loop.map(FrictionLoop::range_m)
            && !(from_m..=to_m).contains(&run.peak_displacement_m)
        {
            warnings.push(format!(
                "run `{}`: the peak at {:.2} mm lies outside the friction loop's {:.2} to {:.2} mm",
                run.run_id,
                run.peak_displacement_m * 1e3,
                from_m * 1e3,
                to_m * 1e3
            ));
        }
    }
}

fn load_warnings(loads: &[LoadSummary], settings: &RawSettings, warnings: &mut Vec<String>) {
    for load in loads {
        if load.spread_deg > USUAL_SPREAD_DEG {
            warnings.push(format!(
                "load {} kg: the kept runs differ by {:.1} deg, more than the usual {USUAL_SPREAD_DEG} deg",
                load.load_kg, load.spread_deg
            ));
        }
        if load.kept.len() == 1 && load.normal_stress_pa < settings.low_stress_limit_pa {
            warnings.push(format!("load {} kg: a single run at a low stress; repeat it", load.load_kg));
        }
    }
}
