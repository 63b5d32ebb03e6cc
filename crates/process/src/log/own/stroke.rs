//! One stroke of our own arm, from its samples to a row.

use std::collections::BTreeMap;

use soilctl_kinematics::{Arm, Frame};
use soilctl_stats::median;

use super::depth::depth_sd_m;
use super::joints::{flexed, half_steps, joined, mean_gap};
use super::sample::{Phase, Sample, mean_wrench, tip_and_sensor};
use super::signals::{BEFORE_S, by_motors_n, insertion_force_n, loops_deg, motor_angle_deg};
use super::surface::touched;
use crate::log::{Course, LogStroke};
use crate::{Outcome, ProcessError, Recorded, RobotSample, Setting, evaluate};

/// Over this time in s at the end of an insertion both encoders are compared.
const COMPARED_S: f64 = 3.0;
/// Two steps further apart than this, in s, leave a gap.
const MOST_GAP_S: f64 = 0.05;
/// The plate is in free air from this height above the surface on, in m.
const AIR_M: f64 = 0.01;

/// All that was logged of a stroke.
#[derive(Debug, Default)]
pub(super) struct Logged {
    pub(super) approach: Vec<Sample>,
    pub(super) stroke: Vec<Sample>,
    pub(super) after: Vec<Sample>,
    /// The log's record of it.
    pub(super) record: BTreeMap<String, String>,
    /// Height of the surface that the log states, in m.
    pub(super) stated_surface_m: Option<f64>,
}

impl Logged {
    fn number(&self, key: &str) -> Option<f64> {
        self.record.get(key)?.parse().ok().filter(|value: &f64| value.is_finite())
    }
}

/// Degrees that went through radians, rounded so that equal set-points stay equal.
fn degrees(value: f64) -> f64 {
    (value * 1e9).round() / 1e9
}

pub(super) fn process(arm: &Arm, logged: &Logged, tool_weight_n: f64) -> Result<LogStroke, ProcessError> {
    let mut flags = Vec::new();
    for pair in logged.stroke.windows(2) {
        if pair[1].t_s - pair[0].t_s > MOST_GAP_S {
            let (from_s, to_s) = (pair[0].t_s, pair[1].t_s);
            return Err(ProcessError::Log(format!("the log lacks {from_s:.3} to {to_s:.3} s of the stroke")));
        }
    }
    let first = logged.stroke.first().ok_or(ProcessError::TooFew {
        what: "samples of the stroke",
        found: 0,
        least: crate::FEWEST_SAMPLES,
    })?;
    let air = |samples: &[Sample]| mean_wrench(samples.iter().filter(|s| s.phase == Phase::Bias));
    let tare = air(&logged.approach).or_else(|| {
        flags.push("tare_from_approach");
        mean_wrench(logged.approach.iter().take(250))
    });
    let Some(tare) = tare else {
        return Err(ProcessError::Log(
            "there are no readings in free air before it, so the tare is unknown".into(),
        ));
    };
    // Tip and sensor by the external encoders alone.
    let seen = logged.stroke.iter().map(|sample| tip_and_sensor(arm, &sample.external));
    let seen: Vec<(Frame, Frame)> = seen.collect::<Result<_, ProcessError>>()?;
    // The tool's weight turns with the sensor.
    let air_sample = logged.approach.iter().find(|s| s.phase == Phase::Bias).or(logged.approach.first());
    let air_up = match air_sample {
        Some(sample) => tip_and_sensor(arm, &sample.external)?.1.rotation[2],
        None => [0.0; 3],
    };
    let loads = logged.stroke.iter().zip(&seen).map(|(sample, (_, sensor))| {
        let mut load: [f64; 6] = std::array::from_fn(|i| sample.wrench[i] - tare[i]);
        for axis in 0..3 {
            load[axis] += tool_weight_n * (sensor.rotation[2][axis] - air_up[axis]);
        }
        load
    });
    let loads: Vec<[f64; 6]> = loads.collect();
    let [x, y, _] = seen[0].0.origin_m;
    let radius = x.hypot(y).max(1e-9);
    let direction = [-x / radius, -y / radius];
    // What an insertion leaves pushes upwards; it is the pull that takes up the free play.
    let pulls = seen.iter().zip(&loads).map(|((_, sensor), load)| {
        let [x, y, _] = sensor.direction([load[0], load[1], load[2]]);
        -(x * direction[0] + y * direction[1])
    });
    let pulls: Vec<f64> = pulls.collect();
    let half_steps = half_steps(arm)?;
    let (joints, jumped) = joined(&logged.stroke, &pulls, &half_steps);
    if jumped {
        flags.push("encoder_jump");
    }
    let mut samples = Vec::with_capacity(joints.len());
    let mut tips: [Vec<[f64; 3]>; 2] = [seen.iter().map(|(tip, _)| tip.origin_m).collect(), Vec::new()];
    for ((sample, load), joints) in logged.stroke.iter().zip(&loads).zip(&joints) {
        let (_, sensor) = tip_and_sensor(arm, joints)?;
        let force = sensor.direction([load[0], load[1], load[2]]);
        let (tip, sensor) = tip_and_sensor(arm, &flexed(arm, joints, force)?)?;
        samples.push(RobotSample {
            t_s: sample.t_s,
            tip_m: tip.origin_m,
            down_plate: tip.direction([0.0, 0.0, 1.0]),
            wrench: *load,
            to_root: sensor.rotation,
        });
        tips[1].push(tip_and_sensor(arm, &sample.motor)?.0.origin_m);
    }
    let touch = touched(arm, &logged.approach, &tare)?;
    let surface = touch.map(|touch| touch.z_m).or_else(|| {
        flags.push("surface_as_stated");
        logged.stated_surface_m
    });
    let Some(surface_z_m) = surface else {
        return Err(ProcessError::Log("neither a touch nor the log says where the surface is".into()));
    };
    let start_z_m = start_height(arm, logged, &samples[0])?;
    let recorded = Recorded {
        samples,
        direction,
        tare_before: Some(tare),
        tare_after: tare_after(arm, logged, surface_z_m)?,
    };
    let setting = Setting {
        surface_z_m,
        width_m: arm.config().plate.width_m,
        alpha_deg: logged.number("alpha_deg").map(degrees),
        batch: logged.record.get("batch").cloned(),
        delta_set_deg: logged.number("delta_set_deg").map(degrees),
        ..Setting::default()
    };
    let mut evaluated = evaluate(&recorded, &setting)?;
    let along = |tips: &[[f64; 3]]| -> Vec<f64> {
        let from = tips.first().copied().unwrap_or_default();
        tips.iter().map(|p| (p[0] - from[0]) * direction[0] + (p[1] - from[1]) * direction[1]).collect()
    };
    let course = Course { external_m: along(&tips[0]), motor_m: along(&tips[1]) };
    let row = &mut evaluated.row;
    row.radius_m = logged.number("radius_m").or(row.radius_m);
    row.base_deg = logged.number("base_deg").map(degrees).or(row.base_deg);
    row.x_step_m = encoder_step(&course.external_m);
    // Of a tare that is a mean over the approach nobody knows in which posture it was.
    if air(&logged.approach).is_some() {
        (row.air_across_n, row.air_along_n) = (Some(tare[2]), Some(tare[0]));
    }
    row.touch_z_m = touch.zip(logged.stated_surface_m).map(|(touch, stated)| touch.z_m - stated);
    row.insertion_force_n = insertion_force_n(arm, &logged.approach, &tare)?;
    row.depth_sd_m = Some(depth_sd_m(arm, &joints[0], &half_steps, touch.map(|touch| touch.late))?);
    if let Outcome::Found(point) = &evaluated.analysis.outcome {
        // At the beginning the external encoders stand at some count; the insertion tells the height more exactly.
        if let Some(start_z_m) = start_z_m {
            row.z_drift_m = Some(surface_z_m - row.depth_m - start_z_m);
        }
        let before = |s: &Sample| s.t_s <= point.time_s && s.t_s > point.time_s - BEFORE_S;
        let near: Vec<usize> = (0..logged.stroke.len()).filter(|i| before(&logged.stroke[*i])).collect();
        let mean = |value: &dyn Fn(usize) -> Option<f64>| -> Option<f64> {
            let values: Vec<f64> = near.iter().filter_map(|i| value(*i)).collect();
            (!values.is_empty()).then(|| values.iter().sum::<f64>() / values.len() as f64)
        };
        row.motor_ext_gap_m = mean(&|i| Some(course.motor_m[i] - course.external_m[i]));
        row.cmd_minus_force_n = mean(&|i| {
            let [along, up] = by_motors_n(arm, &logged.stroke[i], direction)?;
            Some(along.hypot(up) - evaluated.trace.force_n()[i])
        });
        let samples: Vec<Sample> = near.iter().map(|i| logged.stroke[*i]).collect();
        let read = |i: &usize| {
            let [x, y, z] = recorded.samples[*i].force_n();
            [-(x * direction[0] + y * direction[1]), -z]
        };
        let read_n: Vec<[f64; 2]> = near.iter().map(read).collect();
        row.motor_angle_deg = motor_angle_deg(arm, &samples, &read_n, direction);
        if let Some([shoulder, elbow]) = loops_deg(logged, &samples) {
            (row.shoulder_loop_deg, row.elbow_loop_deg) = (Some(shoulder), Some(elbow));
        }
    }
    if logged.record.is_empty() {
        flags.push("no_stroke_record");
    }
    Ok(LogStroke {
        evaluated,
        course: Some(course),
        finish: logged.record.get("finish").cloned(),
        flags,
        start_s: first.t_s,
        end_s: logged.stroke.last().map_or(first.t_s, |s| s.t_s),
    })
}

/// Height of the edge when the stroke begins, in m, by the motors with the shift that the insertion shows.
fn start_height(arm: &Arm, logged: &Logged, begin: &RobotSample) -> Result<Option<f64>, ProcessError> {
    let inserting =
        logged.approach.iter().filter(|s| s.phase == Phase::Insert && s.t_s > begin.t_s - COMPARED_S);
    let (Some(gap), Some(last)) = (mean_gap(inserting), logged.stroke.first()) else { return Ok(None) };
    let joints: [f64; 5] = std::array::from_fn(|i| last.motor[i] + gap[i]);
    let joints = flexed(arm, &joints, begin.force_n())?;
    Ok(Some(tip_and_sensor(arm, &joints)?.0.origin_m[2]))
}

/// Mean reading in free air after the stroke.
fn tare_after(arm: &Arm, logged: &Logged, surface_z_m: f64) -> Result<Option<[f64; 6]>, ProcessError> {
    let mut air = Vec::new();
    for sample in logged.after.iter().rev().take(150) {
        if tip_and_sensor(arm, &sample.external)?.0.origin_m[2] > surface_z_m + AIR_M {
            air.push(*sample);
        }
    }
    Ok(mean_wrench(air.iter()))
}

/// Usual step of a displacement that comes in steps, in m: the median of the plateaus' distances, without the small ones that
/// joints with finer steps and the plate's turning make.
fn encoder_step(displacement_m: &[f64]) -> Option<f64> {
    // The readings are smoothed over some hundredths of a second, so a step takes some samples.
    const STILL_M: f64 = 2e-6;
    const LEAST_SHARE: f64 = 0.4;
    let mut steps = Vec::new();
    let mut plateau: Option<f64> = None;
    let mut still = 0;
    for pair in displacement_m.windows(2) {
        still = if (pair[1] - pair[0]).abs() < STILL_M { still + 1 } else { 0 };
        if still == 10 {
            if let Some(before) = plateau
                && (pair[1] - before).abs() > 20.0 * STILL_M
            {
                steps.push((pair[1] - before).abs());
            }
            plateau = Some(pair[1]);
        }
    }
    steps.sort_by(f64::total_cmp);
    let large = steps.get(steps.len() * 9 / 10).copied().unwrap_or_default();
    steps.retain(|step| *step >= LEAST_SHARE * large);
    (steps.len() >= 3).then(|| median(&mut steps))
}
