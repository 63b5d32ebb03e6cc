//! From a stroke's samples to its curve and to a row of the stroke table.

use std::ops::Range;

use soilctl_stats::{mean_and_sd, median, sd_of_median_abs};
use soilctl_strokes::StrokeRow;

use crate::error::{ProcessError, positive};
use crate::failure::{Analysis, FailureSettings, ForceNoise, Indiscernible, Outcome, failure_force};
use crate::friction::COMMON_SD_DEG;
use crate::robot::RobotSample;
use crate::slip::Slip;
use crate::trace::{Channels, FEWEST_SAMPLES, Trace};

/// A force that lies further from the plate's normal than this cosine says, 57 deg, is none that fails the soil ahead: it is
/// left over from the insertion.
const LEAST_COSINE: f64 = 0.55;

/// Depths over that at the beginning, beyond which the square of the depth says little.
const DEPTHS: [f64; 2] = [0.7, 1.6];

/// Times in s before and after a failure between which it shows which way the plate gave way.
const MARGIN_S: f64 = 0.1;
const AFTER_S: f64 = 1.0;
/// Way down over the depth that is no play of the arm.
const SLID_REL: f64 = 0.02;

/// A hundredth of a degree, finer than any arm is known, changes no force; strokes at one angle shall have one.
const ANGLE_STEPS_PER_DEG: f64 = 100.0;

/// Parts of the half second before a failure between which the inclination of the force wanders.
const BLOCKS: usize = 5;
/// Samples over which a direction is taken.
const STEADY: usize = 25;

/// One push of the plate along the ground.
#[derive(Debug, Clone, PartialEq)]
pub struct Recorded {
    /// Samples of the stroke: after insertion, before the plate is pulled out, the tare taken off.
    pub samples: Vec<RobotSample>,
    /// Unit vector of the travel along the ground (x, y).
    pub direction: [f64; 2],
    /// Mean wrench in free air before, in the sensor frame, if it is to be told.
    pub tare_before: Option<[f64; 6]>,
    /// Mean wrench in free air after, as read.
    pub tare_after: Option<[f64; 6]>,
}

/// What samples don't tell.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Setting {
    /// Height of the soil's surface in the URDF's root frame, in m.
    pub surface_z_m: f64,
    /// Width of the plate in m.
    pub width_m: f64,
    /// Tool angle in deg; without it the one of the plate frame.
    pub alpha_deg: Option<f64>,
    /// Name of the stroke.
    pub stroke_id: Option<String>,
    /// Preparation it belongs to.
    pub batch: Option<String>,
    /// Order within the batch.
    pub order: Option<u32>,
    /// Set-point of the interface friction in deg.
    pub delta_set_deg: Option<f64>,
    /// Noise of the force, where it is known.
    pub noise: Option<ForceNoise>,
}

/// A stroke, evaluated.
#[derive(Debug, Clone, PartialEq)]
pub struct Evaluated {
    /// Row of the stroke table; its force is 0 if there is no failure, and then it must not be written.
    pub row: StrokeRow,
    /// The curve.
    pub trace: Trace,
    /// What was found on it.
    pub analysis: Analysis,
    /// Inclination of the force after the failure.
    pub slip: Option<Slip>,
}

/// Evaluates a recorded stroke.
///
/// The force is that of the plate on the soil in the vertical plane of travel. Its inclination is positive downward,
/// and the friction angle is the inclination minus that of the plate's normal, `alpha - 90 deg` and how far the plate has
/// turned since.
///
/// A tool angle that nobody stated is that of the plate, to a hundredth of a degree.
///
/// # Errors
/// [`ProcessError::OutOfRange`] if the plate's depth or width is not above 0, or its angle is not between 0 and 180 deg;
/// errors of [`Trace::new`].
pub fn evaluate(stroke: &Recorded, setting: &Setting) -> Result<Evaluated, ProcessError> {
    let width_m = positive("width of the plate", setting.width_m, "m")?;
    let [dx, dy] = stroke.direction;
    let first = stroke.samples.first().ok_or(ProcessError::TooFew { what: "samples", found: 0, least: 1 })?;
    let along = |v: [f64; 3]| v[0] * dx + v[1] * dy;
    let early = &stroke.samples[..(stroke.samples.len() / 50).max(1)];
    let mut heights: Vec<f64> = early.iter().map(|s| s.tip_m[2]).collect();
    let depth_m =
        positive("depth of the plate below the surface", setting.surface_z_m - median(&mut heights), "m")?;
    let alpha_deg = match setting.alpha_deg {
        Some(alpha) => alpha,
        None => {
            let angle_deg = tool_angle_deg(along(first.down_plate), first.down_plate[2]);
            (angle_deg * ANGLE_STEPS_PER_DEG).round() / ANGLE_STEPS_PER_DEG
        }
    };
    if !(alpha_deg > 0.0 && alpha_deg < 180.0) {
        return Err(ProcessError::OutOfRange {
            what: "tool angle",
            value: alpha_deg,
            unit: "deg",
            allowed: "above 0 and below 180",
        });
    }
    let mut starts: Vec<f64> = early.iter().map(|s| along(s.tip_m)).collect();
    let start = median(&mut starts);
    // An arm turns the plate with itself while it pulls, by some degrees.
    let tool_deg = |s: &RobotSample| tool_angle_deg(along(s.down_plate), s.down_plate[2]);
    let mut early_deg: Vec<f64> = early.iter().map(tool_deg).collect();
    let early_deg = median(&mut early_deg);
    let normal_deg = alpha_deg - 90.0 - early_deg;
    let friction_deg = |s: &RobotSample| {
        let force = s.force_n();
        force[2].atan2(-along(force)).to_degrees() - normal_deg - tool_deg(s)
    };
    let columns =
        |value: &dyn Fn(&RobotSample) -> f64| -> Vec<f64> { stroke.samples.iter().map(value).collect() };
    let centre: Option<Vec<f64>> = fill(stroke.samples.iter().map(RobotSample::centre_m));
    let trace = Trace::new(
        columns(&|s| s.t_s),
        columns(&|s| along(s.tip_m) - start),
        columns(&|s| along(s.force_n()).hypot(s.force_n()[2])),
        Channels {
            friction_angle_deg: Some(columns(&friction_deg)),
            z_m: Some(columns(&|s| s.tip_m[2])),
            centre_m: centre,
        },
    )?;
    let sunk: Vec<f64> = stroke.samples.iter().map(|s| setting.surface_z_m - s.tip_m[2]).collect();
    let settings = FailureSettings { noise: setting.noise, ..FailureSettings::for_depth(depth_m)? };
    let (analysis, slip) = across_plate(&trace, &sunk, &settings)?;
    let mut row = StrokeRow {
        stroke_id: setting.stroke_id.clone(),
        batch: setting.batch.clone(),
        order: setting.order,
        time_s: Some(first.t_s),
        alpha_deg,
        depth_m,
        width_m,
        delta_set_deg: setting.delta_set_deg,
        radius_m: Some(first.tip_m[0].hypot(first.tip_m[1])),
        base_deg: Some(first.tip_m[1].atan2(first.tip_m[0]).to_degrees()),
        x_step_m: step(trace.displacement_m()),
        ..StrokeRow::default()
    };
    if let Outcome::Found(point) = &analysis.outcome {
        row.turned_deg =
            before(&trace, Some(&columns(&|s| tool_deg(s))), point.time_s).map(|angle| angle - early_deg);
        row.force_n = point.force_n;
        row.force_sd_n = Some(point.sd_n);
        row.displacement_at_failure_m = Some(point.displacement_m);
        row.post_slope_norm = point.post_slope_norm;
        row.residual_ratio = point.residual_ratio;
        row.friction_angle_deg = before(&trace, trace.channels().friction_angle_deg.as_deref(), point.time_s);
        row.friction_angle_sd_deg =
            wander_before(&trace, trace.channels().friction_angle_deg.as_deref(), point.time_s)
                .map(|wander| (0.5 * wander).hypot(COMMON_SD_DEG));
        row.z_drift_m =
            before(&trace, trace.channels().z_m.as_deref(), point.time_s).map(|z| z - median(&mut heights));
        // The force is that of the depth where the soil failed.
        row.depth_m = before(&trace, Some(&sunk), point.time_s).unwrap_or(depth_m);
        row.speed_mps = (point.displacement_m > 0.0 && point.time_s > first.t_s)
            .then(|| point.displacement_m / (point.time_s - first.t_s));
        // A free-air reading counts in the direction in which the soil pushed.
        let at = stroke.samples.iter().rev().find(|s| s.t_s <= point.time_s).unwrap_or(first);
        let force = at.force_n();
        let size = along(force).hypot(force[2]);
        let share = |tare: [f64; 6]| {
            let tare = at.turned([tare[0], tare[1], tare[2]]);
            (along(tare) * along(force) + tare[2] * force[2]) / size
        };
        if size > 0.0 {
            row.tare_before_n = stroke.tare_before.map(share);
            row.tare_after_n = stroke.tare_after.map(share);
        }
    }
    Ok(Evaluated { row, trace, analysis, slip })
}

/// Finds the failure on the force across the plate, and gives it as that of the resultant.
///
/// Along the plate an insertion leaves a load, larger than the failure force may be, that fades when the stroke begins; the
/// force across starts from nothing. At failure both keep their ratio, the friction angle. A plate that sinks or rises
/// while it is pulled changes its limit force with the square of its depth (section 5.6), `depths_m` by sample; the failure
/// is looked for at one depth.
fn across_plate(
    trace: &Trace,
    depths_m: &[f64],
    settings: &FailureSettings,
) -> Result<(Analysis, Option<Slip>), ProcessError> {
    let angles = trace.channels().friction_angle_deg.clone().unwrap_or_default();
    let cosines: Vec<f64> = angles.iter().map(|angle| angle.to_radians().cos()).collect();
    let relative: Vec<f64> = depths_m.iter().map(|depth| depth / settings.depth_m).collect();
    let squares: Vec<f64> = relative.iter().map(|depth| depth.clamp(DEPTHS[0], DEPTHS[1]).powi(2)).collect();
    let across = trace.force_n().iter().zip(&cosines).zip(&squares);
    let across: Vec<f64> = across.map(|((force, cosine), square)| force * cosine / square).collect();
    let pushed =
        Trace::new(trace.t_s().to_vec(), trace.displacement_m().to_vec(), across, trace.channels().clone())?;
    let pushed = pushed.part(pulling(&cosines, &relative))?;
    let mut analysis = failure_force(&pushed, settings);
    let Outcome::Found(point) = &mut analysis.outcome else { return Ok((analysis, None)) };
    let cosine = before(trace, Some(&cosines), point.time_s).unwrap_or(1.0);
    let depth = before(trace, Some(&relative), point.time_s).unwrap_or(1.0);
    let reason = if cosine < LEAST_COSINE {
        Some(Indiscernible::Inclined { angle_deg: cosine.clamp(-1.0, 1.0).acos().to_degrees() })
    } else if !(DEPTHS[0]..=DEPTHS[1]).contains(&depth) {
        Some(Indiscernible::LeftDepth { ratio: depth })
    } else {
        slid(trace, depths_m, point.time_s)
    };
    if let Some(reason) = reason {
        analysis.outcome = Outcome::Indiscernible(reason);
        return Ok((analysis, None));
    }
    let slip = Slip::after(&pushed, point.time_s, settings.depth_m);
    let factor = before(trace, Some(&squares), point.time_s).unwrap_or(1.0) / cosine;
    (point.force_n, point.sd_n) = (point.force_n * factor, point.sd_n * factor);
    if let Some(lines) = &mut analysis.two_lines {
        (lines.force_n, lines.sd_n) = (lines.force_n * factor, lines.sd_n * factor);
    }
    if let Some(curve) = &mut analysis.saturation {
        (curve.force_n, curve.sd_n) = (curve.force_n * factor, curve.sd_n * factor);
    }
    Ok((analysis, slip))
}

/// Whether the plate gave way downwards instead of the soil ahead: a set-point above the interface friction drives it into
/// the ground (section 5.4).
fn slid(trace: &Trace, depths_m: &[f64], time_s: f64) -> Option<Indiscernible> {
    let at = |time_s: f64| {
        let last = trace.t_s().len().checked_sub(1)?;
        let k = trace.t_s().partition_point(|t| *t < time_s).min(last);
        Some((*depths_m.get(k)?, *trace.displacement_m().get(k)?))
    };
    let (before, after) = (at(time_s - MARGIN_S)?, at(time_s + AFTER_S)?);
    let (down_m, ahead_m) = (after.0 - before.0, after.1 - before.1);
    (down_m > SLID_REL * before.0 && down_m > ahead_m).then_some(Indiscernible::Slid { down_m, ahead_m })
}

/// The longest part in which the plate pulls, across itself and near its depth; all if there is none.
fn pulling(cosines: &[f64], relative_depths: &[f64]) -> Range<usize> {
    let pulls = |(cosines, depths): (&[f64], &[f64])| {
        let depth = median(&mut depths.to_vec());
        median(&mut cosines.to_vec()) >= LEAST_COSINE && (DEPTHS[0]..=DEPTHS[1]).contains(&depth)
    };
    let (mut longest, mut from) = (0..0, 0);
    for (k, chunk) in cosines.chunks(STEADY).zip(relative_depths.chunks(STEADY)).enumerate() {
        let end = (k * STEADY + STEADY).min(cosines.len());
        if !pulls(chunk) {
            from = end;
        } else if end - from > longest.len() {
            longest = from..end;
        }
    }
    if longest.len() < FEWEST_SAMPLES { 0..cosines.len() } else { longest }
}

/// Angle of a plate from the ground ahead: its `down` direction along the travel and upwards.
fn tool_angle_deg(down_along: f64, down_up: f64) -> f64 {
    (-down_up).atan2(down_along).to_degrees()
}

/// How far a channel wanders over the same time, without its noise.
fn wander_before(trace: &Trace, values: Option<&[f64]>, time_s: f64) -> Option<f64> {
    let part = just_before(trace, values?, time_s)?;
    let blocks: Vec<f64> =
        part.chunks(part.len().div_ceil(BLOCKS)).map(|block| median(&mut block.to_vec())).collect();
    mean_and_sd(&blocks).map(|(_, sd)| sd)
}

/// Median of a channel over the half second before failure, less its last tenth.
fn before(trace: &Trace, values: Option<&[f64]>, time_s: f64) -> Option<f64> {
    Some(median(&mut just_before(trace, values?, time_s)?.to_vec()))
}

/// A channel over that time; `None` of fewer than three samples.
fn just_before<'v>(trace: &Trace, values: &'v [f64], time_s: f64) -> Option<&'v [f64]> {
    let first = trace.t_s().partition_point(|t| *t < time_s - 0.5);
    let last = trace.t_s().partition_point(|t| *t < time_s - 0.05);
    values.get(first..last).filter(|part| part.len() >= 3)
}

/// Holds the last value where there is none; `None` if more than half is missing.
fn fill(values: impl Iterator<Item = Option<f64>> + Clone) -> Option<Vec<f64>> {
    let mut last = values.clone().flatten().next()?;
    let (mut filled, mut missing) = (Vec::new(), 0);
    for value in values {
        missing += usize::from(value.is_none());
        last = value.unwrap_or(last);
        filled.push(last);
    }
    (2 * missing <= filled.len()).then_some(filled)
}

/// Step of a displacement that comes in steps: the usual size of its jumps, if it mostly stands still between them.
fn step(displacement_m: &[f64]) -> Option<f64> {
    let changes: Vec<f64> =
        displacement_m.windows(2).map(|pair| pair[1] - pair[0]).filter(|change| *change != 0.0).collect();
    let stepped = changes.len() >= 4 && changes.len() * 2 < displacement_m.len();
    stepped.then(|| sd_of_median_abs(changes.into_iter()) * 0.674_489_750_196_081_7)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A plate that after 1 s goes down and ahead with these speeds in m/s.
    fn going(down_m_s: f64, ahead_m_s: f64) -> Option<Indiscernible> {
        let t_s: Vec<f64> = (0..2000).map(|k| 0.002 * f64::from(k)).collect();
        let after = |speed: f64| -> Vec<f64> { t_s.iter().map(|t| speed * (t - 1.0).max(0.0)).collect() };
        let depths_m: Vec<f64> = after(down_m_s).iter().map(|way| 0.025 + way).collect();
        let trace = Trace::new(t_s.clone(), after(ahead_m_s), vec![5.0; 2000], Channels::default()).unwrap();
        slid(&trace, &depths_m, 1.0)
    }

    #[test]
    fn a_plate_that_goes_down_more_than_ahead_has_slid() {
        let Some(Indiscernible::Slid { down_m, ahead_m }) = going(0.002, 0.001) else { panic!("it slid") };
        assert!((down_m - 0.002).abs() < 1e-5 && (ahead_m - 0.001).abs() < 1e-5);
        assert_eq!(going(0.002, 0.003), None);
        assert_eq!(going(-0.002, 0.001), None);
        // A fiftieth of the depth may be play.
        assert_eq!(going(0.0004, 0.0), None);
    }
}
