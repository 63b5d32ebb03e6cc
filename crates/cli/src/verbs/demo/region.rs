//! From the stroke table to every friction angle and density that explains it.

use std::path::Path;

use soilctl_process::table::StrokeRecord;
use soilctl_strokes::{Campaign, StrokeRow, StrokeTable};

use super::answer::{EachStroke, Region, Truth};
use crate::args::{LoadArgs, NumberOrColumn};
use crate::error::CliError;
use crate::verbs::estimate::args::{EstimateArgs, Uncertainty};
use crate::verbs::estimate::work::{self, Work};

/// Set-points of the strokes that count, in deg from the interface friction: far below it the soil fails with another friction
/// on the plate, above it the plate slips along the soil, which does not fail.
const SET_DEG: std::ops::RangeInclusive<f64> = -3.5..=1.5;
/// Standard deviations of a band: with 3, sixteen bands hold all their true forces in 96 of 100 campaigns.
pub(super) const SIGMA: f64 = 3.0;
/// Relative deviation of a true force from the model's at full friction and level ground: friction on the plate that is not all
/// mobilised when the soil fails, and the heap ahead, are within 9 %.
const SOIL_SD_REL: f64 = 0.03;
/// A weighed box is right within this share.
const WEIGHED: f64 = 0.01;

/// Strokes that friction angle and density are estimated from.
pub(super) fn chosen(strokes: &[StrokeRecord], delta_deg: [f64; 2]) -> Vec<&StrokeRecord> {
    let middle = f64::midpoint(delta_deg[0], delta_deg[1]);
    strokes
        .iter()
        .filter(|stroke| stroke.delta_set_deg.is_some_and(|set| SET_DEG.contains(&(set - middle))))
        .collect()
}

/// The table of the estimate: depth is that at failure, and the uncertainty of a force holds what depth, density of a
/// preparation and model add to it.
pub(super) fn measurements(
    path: &Path,
    strokes: &[&StrokeRecord],
    campaign: &Campaign,
) -> Result<(), CliError> {
    let rows: Vec<StrokeRow> = strokes
        .iter()
        .map(|stroke| {
            let depth_m = stroke.depth_m;
            let share = together(&[
                stroke.force_sd_n.unwrap_or(0.0) / stroke.force_n,
                // The force goes with the square of the depth.
                2.0 * campaign.depth_sd_m / depth_m,
                campaign.density_sd_rel,
                SOIL_SD_REL,
            ]);
            StrokeRow { depth_m, force_sd_n: Some(share * stroke.force_n), ..stroke.row() }
        })
        .collect();
    write(path, &rows)
}

/// The same strokes as they are in truth: what is left of the uncertainty is the soil's own. `None` if none of them failed.
pub(super) fn true_measurements(
    path: &Path,
    strokes: &[&StrokeRecord],
    each: &[EachStroke],
    campaign: &Campaign,
) -> Result<Option<()>, CliError> {
    let share = together(&[SOIL_SD_REL, campaign.density_sd_rel]);
    let rows: Vec<StrokeRow> = strokes
        .iter()
        .filter_map(|stroke| {
            let truth = each.iter().find(|one| one.stroke_id.as_ref() == Some(&stroke.stroke_id))?;
            let (force_n, depth_m) = (truth.true_force_n?, truth.true_depth_m?);
            Some(StrokeRow { force_n, depth_m, force_sd_n: Some(share * force_n), ..stroke.row() })
        })
        .collect();
    if rows.is_empty() {
        return Ok(None);
    }
    write(path, &rows).map(Some)
}

/// Independent relative deviations together.
fn together(shares: &[f64]) -> f64 {
    shares.iter().map(|share| share * share).sum::<f64>().sqrt()
}

fn write(path: &Path, rows: &[StrokeRow]) -> Result<(), CliError> {
    Ok(StrokeTable::new(&path.display().to_string(), rows)?.write(path)?)
}

/// Everything that the estimate may know.
pub(super) struct Known<'a> {
    pub(super) measurements: &'a Path,
    pub(super) model: &'a str,
    pub(super) delta_deg: [f64; 2],
    pub(super) cohesion_pa: f64,
    pub(super) gravity_m_s2: f64,
    pub(super) density_sd_rel: f64,
}

impl Known<'_> {
    /// The options of `soilctl estimate`, with the density as weighed in kg/m3 or unknown.
    pub(super) fn args(&self, weighed_kg_m3: Option<f64>) -> EstimateArgs {
        let [low, high] = self.delta_deg;
        EstimateArgs {
            file: self.measurements.to_owned(),
            model: self.model.to_owned(),
            model_file: None,
            delta: NumberOrColumn::Number(f64::midpoint(low, high)),
            delta_tol: 0.5 * (high - low),
            density: weighed_kg_m3.map(NumberOrColumn::Number),
            density_tol: WEIGHED + self.density_sd_rel,
            sigma: Some(SIGMA),
            uncertainty: Uncertainty::Sigma,
            adjust_high_angles: 0.0,
            phi_range: None,
            loads: LoadArgs {
                cohesion: self.cohesion_pa,
                adhesion: 0.0,
                surcharge: 0.0,
                gravity: self.gravity_m_s2,
                beta: 0.0,
            },
            sections: Vec::new(),
            next_strokes: false,
            next_alpha: Vec::new(),
            next_depth: Vec::new(),
            force_limit: None,
            compare: false,
        }
    }
}

/// An estimate, or in words why there is none.
///
/// # Errors
/// Only those of files: that forces allow no estimate is an answer.
pub(super) fn estimate(args: &EstimateArgs) -> Result<Result<Work, String>, CliError> {
    match work::run(args, false) {
        Ok(work) => Ok(Ok(work)),
        Err(problem) if problem.is_of_a_file() => Err(problem),
        Err(problem) => Ok(Err(problem.to_string())),
    }
}

/// The estimate beside the truth.
pub(super) fn region(work: &Work, truth: &Truth) -> Region {
    let found = &work.answer;
    let holds =
        |range: Option<[f64; 2]>, value: f64| range.is_some_and(|[low, high]| (low..=high).contains(&value));
    Region {
        consistent: found.consistent,
        phi_deg: found.phi_deg,
        density_kg_m3: found.density_kg_m3,
        density_known_kg_m3: found.density_known_kg_m3,
        phi_holds_truth: holds(found.phi_deg, truth.phi_deg),
        density_holds_truth: holds(found.density_kg_m3, truth.density_kg_m3),
        holds_truth: work.estimate.region.contains([truth.phi_deg, truth.density_kg_m3]),
        verdict: found.verdict.clone(),
    }
}
