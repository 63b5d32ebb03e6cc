//! From the stroke table to every friction angle and density that explains it.

use std::path::Path;

use soilctl_app::Unwatched;
use soilctl_app::estimate::{self, Estimation};
use soilctl_app::request::{Loads, NumberOrColumn};
use soilctl_earth_pressure::{Case, ChenLiu, ForceModel as _};
use soilctl_process::table::StrokeRecord;
use soilctl_soil::Angle;
use soilctl_strokes::{Campaign, StrokeRow, StrokeTable};

use super::answer::{EachStroke, Region, Truth};
use crate::error::CliError;

/// Set-points of the strokes that count, in deg from the interface friction: far below it the soil fails with another friction
/// on the plate, above it the plate slips along the soil, which does not fail.
const SET_DEG: std::ops::RangeInclusive<f64> = -3.5..=1.5;
/// A plate that sank or rose by more of its depth before the soil failed was not pulled through it as the models have it.
const MOST_DRIFT: f64 = 0.1;
/// Standard deviations of a band: with 3, sixteen bands hold all their true forces in 96 of 100 campaigns.
pub(super) const SIGMA: f64 = 3.0;
/// Relative deviation of a true force from the model's on level ground: the heap ahead, the law of the friction on the plate.
const SOIL_SD_REL: f64 = 0.03;
/// The arm turns the plate by about a degree until the soil fails, and the force goes with it. It is carried back by Chen and Liu's
/// model at this friction angle in deg; at 30 or 45 deg the correction of some per cent is a tenth of itself different.
const TURN_PHI_DEG: f64 = 40.0;
/// Half width of what is known of the inclination at failure, in deg.
const INCLINATION_DEG: f64 = 1.0;
/// A weighed box is right within this share.
const WEIGHED: f64 = 0.01;

/// Strokes that friction angle and density are estimated from.
pub(super) fn chosen(strokes: &[StrokeRecord], delta_deg: [f64; 2]) -> Vec<&StrokeRecord> {
    let middle = f64::midpoint(delta_deg[0], delta_deg[1]);
    strokes
        .iter()
        .filter(|stroke| stroke.row.delta_set_deg.is_some_and(|set| SET_DEG.contains(&(set - middle))))
        .filter(|stroke| {
            stroke.row.z_drift_m.is_none_or(|drift| drift.abs() < MOST_DRIFT * stroke.row.depth_m)
        })
        .collect()
}

/// The table of the estimate: depth is that at failure, and the uncertainty of a force holds what depth, density of a
/// preparation and model add to it.
pub(super) fn measurements(
    path: &Path,
    strokes: &[&StrokeRecord],
    delta_deg: [f64; 2],
    campaign: &Campaign,
) -> Result<(), CliError> {
    let rows: Vec<StrokeRow> = strokes
        .iter()
        .map(|stroke| {
            let depth_m = stroke.row.depth_m;
            let row = at_failure(stroke, stroke.row.force_n, delta_deg)?;
            let share = together(&[
                stroke.row.force_sd_n.unwrap_or(0.0) / stroke.row.force_n,
                // The force goes with the square of the depth.
                2.0 * campaign.depth_sd_m / depth_m,
                campaign.density_sd_rel,
                SOIL_SD_REL,
            ]);
            Ok(StrokeRow { depth_m, force_sd_n: Some(share * row.force_n), ..row })
        })
        .collect::<Result<_, CliError>>()?;
    write(path, &rows)
}

/// The same strokes as they are in truth: what is left of the uncertainty is the soil's own. `None` if none of them failed.
pub(super) fn true_measurements(
    path: &Path,
    strokes: &[&StrokeRecord],
    each: &[EachStroke],
    delta_deg: [f64; 2],
    campaign: &Campaign,
) -> Result<Option<()>, CliError> {
    let share = together(&[SOIL_SD_REL, campaign.density_sd_rel]);
    let rows: Vec<StrokeRow> = strokes
        .iter()
        .filter_map(|stroke| {
            let truth = each.iter().find(|one| one.stroke_id == stroke.row.stroke_id)?;
            let (force_n, depth_m) = (truth.true_force_n?, truth.true_depth_m?);
            let row = at_failure(stroke, force_n, delta_deg);
            Some(row.map(|row| StrokeRow { depth_m, force_sd_n: Some(share * row.force_n), ..row }))
        })
        .collect::<Result<_, CliError>>()?;
    if rows.is_empty() {
        return Ok(None);
    }
    write(path, &rows).map(Some)
}

/// A stroke with the force that `force_n` would have been at the tool angle it was asked for, and with the inclination of the force
/// as the friction on the plate: less than the interface friction may be mobilised when the soil fails, never more.
fn at_failure(stroke: &StrokeRecord, force_n: f64, delta_deg: [f64; 2]) -> Result<StrokeRow, CliError> {
    let mut row = stroke.row.clone();
    row.delta_set_deg =
        row.friction_angle_deg.map(|angle| angle.clamp(0.0, delta_deg[1])).or(row.delta_set_deg);
    let factor = |alpha_deg: f64| {
        let case = Case {
            tool_angle: Angle::from_degrees(alpha_deg),
            surface_slope: Angle::ZERO,
            friction: Angle::from_degrees(TURN_PHI_DEG),
            interface: Angle::from_degrees(row.delta_set_deg.unwrap_or(0.0).min(TURN_PHI_DEG)),
        };
        ChenLiu.predict(&case).map(|prediction| prediction.net.weight)
    };
    let turned_deg = stroke.failure.turned_deg.unwrap_or(0.0);
    row.force_n = force_n * factor(row.alpha_deg)? / factor(row.alpha_deg + turned_deg)?;
    Ok(row)
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
    pub(super) cohesion_pa: f64,
    pub(super) gravity_m_s2: f64,
    pub(super) density_sd_rel: f64,
}

impl Known<'_> {
    /// What an estimate is asked, with the density as weighed in kg/m3 or unknown.
    pub(super) fn request(&self, weighed_kg_m3: Option<f64>) -> estimate::Request {
        estimate::Request {
            file: self.measurements.into(),
            model: self.model.to_owned(),
            delta_deg: NumberOrColumn::Column,
            delta_tol_deg: INCLINATION_DEG,
            density_kg_m3: weighed_kg_m3.map(NumberOrColumn::Number),
            density_tol: WEIGHED + self.density_sd_rel,
            sigma: Some(SIGMA),
            loads: Loads {
                cohesion_pa: self.cohesion_pa,
                gravity_m_s2: self.gravity_m_s2,
                ..Loads::default()
            },
            ..estimate::Request::default()
        }
    }
}

/// An estimate, or in words why there is none.
///
/// # Errors
/// Only those of files: that forces allow no estimate is an answer.
pub(super) fn estimate(request: &estimate::Request) -> Result<Result<Estimation, String>, CliError> {
    match estimate::run(request, &Unwatched) {
        Ok(work) => Ok(Ok(work)),
        Err(problem) if problem.is_of_a_file() => Err(problem.into()),
        Err(problem) => Ok(Err(problem.to_string())),
    }
}

/// The estimate beside the truth.
pub(super) fn region(work: &Estimation, truth: &Truth) -> Region {
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

#[cfg(test)]
mod tests {
    use soilctl_process::table::FailureRow;

    use super::*;

    fn stroke(turned_deg: f64, friction_angle_deg: f64, z_drift_m: f64) -> StrokeRecord {
        let row = StrokeRow {
            alpha_deg: 90.0,
            depth_m: 0.025,
            width_m: 0.127,
            force_n: 8.0,
            delta_set_deg: Some(22.0),
            friction_angle_deg: Some(friction_angle_deg),
            z_drift_m: Some(z_drift_m),
            ..StrokeRow::default()
        };
        let failure = FailureRow { turned_deg: Some(turned_deg), ..FailureRow::default() };
        StrokeRecord { row, failure }
    }

    /// A steeper plate meets more soil, so one that turned back would have needed more force where it began.
    #[test]
    fn a_force_is_carried_back_over_the_turn() {
        let at = |turned_deg| at_failure(&stroke(turned_deg, 22.0, 0.0), 8.0, [22.0, 24.0]).unwrap().force_n;
        assert_eq!(at(0.0), 8.0);
        let share = at(-1.0) / 8.0 - 1.0;
        assert!((0.01..0.06).contains(&share), "{share}");
        assert!(at(1.0) < 8.0);
    }

    #[test]
    fn no_more_than_the_interface_friction_is_mobilised() {
        let at = |angle| at_failure(&stroke(0.0, angle, 0.0), 8.0, [22.0, 24.0]).unwrap().delta_set_deg;
        assert_eq!([at(21.0), at(26.0), at(-1.0)], [Some(21.0), Some(24.0), Some(0.0)]);
    }

    #[test]
    fn plates_that_sank_do_not_count() {
        let strokes = [stroke(0.0, 22.0, -0.001), stroke(0.0, 22.0, -0.004), stroke(0.0, 22.0, 0.004)];
        assert_eq!(chosen(&strokes, [22.0, 24.0]), [&strokes[0]]);
    }
}
