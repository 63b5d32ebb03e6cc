//! What makes a log useless as a whole, said in words; and what is missing in it.

use soilctl_motion::{Columns, MOST_M, MOST_RAD, Oddity};

use super::contact::depth;
use super::survey::Survey;
use crate::{ProcessError, Robot};

/// Refuses columns that tell nothing.
pub(super) fn check(
    columns: &Columns,
    joint_topics: &[String],
    wrench_topic: &str,
    joints: &[String],
) -> Result<(), ProcessError> {
    let wrenches = &columns.wrenches.values;
    let Some(first) = wrenches.first() else {
        return Err(ProcessError::Log(format!(
            "no message on {wrench_topic} has a wrench of finite numbers"
        )));
    };
    if wrenches.iter().all(|wrench| wrench == first) {
        return Err(ProcessError::Log(format!(
            "all {} wrenches on {wrench_topic} are the same: the sensor was not read",
            wrenches.len()
        )));
    }
    let missing: Vec<&str> = columns
        .joints
        .iter()
        .zip(joints)
        .filter(|(series, _)| series.t_s.is_empty())
        .map(|(_, name)| name.as_str())
        .collect();
    if !missing.is_empty() {
        return Err(ProcessError::Joints {
            topic: joint_topics.join(", "),
            missing: missing.join(", "),
            named: columns.named.join(", "),
        });
    }
    Ok(())
}

/// Refuses positions that are no angles in rad or ways in m.
pub(super) fn check_units(columns: &Columns, robot: &Robot) -> Result<(), ProcessError> {
    for ((name, slides), series) in robot.joint_names().iter().zip(robot.sliding()).zip(&columns.joints) {
        let furthest =
            series.values.iter().copied().max_by(|a, b| a.abs().total_cmp(&b.abs())).unwrap_or(0.0);
        let (most, unit, instead) = if slides { (MOST_M, "m", "mm") } else { (MOST_RAD, "rad", "degrees") };
        if furthest.abs() > most {
            return Err(ProcessError::Log(format!(
                "joint {name} goes to {furthest:.1} {unit}, more than {most} {unit}: its positions seem to be in {instead}; ROS has them in \
                 {unit}"
            )));
        }
    }
    Ok(())
}

/// Gaps of the wrenches, and wrenches without a posture.
pub(super) fn note_gaps(columns: &mut Columns, survey: &Survey, topic: &str) {
    let longest_s = survey.gaps.iter().map(|[from, to]| to - from).fold(0.0, f64::max);
    columns.trouble(topic, Oddity::Gap { longest_s }, survey.gaps.iter().map(|gap| gap[0]));
    let without: Vec<(f64, usize)> =
        survey.blocks.iter().filter(|b| b.posture.is_none()).map(|b| (b.t_s, b.samples.len())).collect();
    let times = without.iter().flat_map(|(t_s, count)| std::iter::repeat_n(*t_s, *count));
    columns.trouble(topic, Oddity::NoPosture, times);
}

/// Why nothing is known of free air.
pub(super) fn no_air(survey: &Survey, surface_z_m: f64) -> String {
    let highest = survey.blocks.iter().filter_map(|block| depth(block, surface_z_m)).min_by(f64::total_cmp);
    match highest {
        Some(depth_m) if depth_m > 0.0 => format!(
            "the tare is unknown: the edge is never above the surface as given, at its highest it is {:.1} mm below; check --surface-z, \
             record free air before and after the strokes, or give --tare",
            depth_m * 1e3
        ),
        _ => "the tare is unknown: nothing was recorded in free air; record some before and after the strokes, or give --tare".into(),
    }
}
