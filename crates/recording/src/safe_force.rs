//! The forces that the soil bears safely, as an area in front of the plate.

use std::f64::consts::FRAC_PI_2;

use soilctl_controller::ControllerConfig;
use soilctl_kinematics::{Arm, JointAngles};
use soilctl_live::protocol::SafeForce;

use crate::FORCE_M_PER_N;

/// The link that the area hangs on.
pub(crate) const LINK: &str = "plate_tip";
/// Steps along the rim.
const STEPS: u32 = 32;

/// The set of the controller's settings.
pub(crate) fn of_settings(settings: &ControllerConfig) -> SafeForce {
    let table = &settings.stroke.safe_force;
    SafeForce { angle_deg: table.angle_deg.clone(), force_n: table.force_n.clone() }
}

/// The end-point of the plate and the rim, in the frame of the plate; none if the set is empty or the joints are not
/// numbers. Angles are those to the plate's normal, so the area keeps its shape as the plate moves.
pub(crate) fn fan(
    set: &SafeForce,
    arm: &Arm,
    joints: &JointAngles,
    tool_angle_deg: f64,
) -> Option<Vec<[f64; 3]>> {
    let (first, last) = (*set.angle_deg.first()?, *set.angle_deg.last()?);
    let (frames, at) = (arm.frames(joints).ok()?, arm.at(joints).ok()?);
    let turned = frames.plate_tip.rotation;
    let mut corners = vec![[0.0; 3]];
    for k in 0..=STEPS {
        let angle_deg = first + (last - first) * f64::from(k) / f64::from(STEPS);
        let length_m = FORCE_M_PER_N * largest_n(set, angle_deg)?;
        let (sin, cos) = ((tool_angle_deg + angle_deg).to_radians() - FRAC_PI_2).sin_cos();
        let v = at.rtz_to_base([length_m * cos, 0.0, length_m * sin]);
        // Into the frame of the plate: the transpose turns back.
        corners.push([0, 1, 2].map(|column| (0..3).map(|row| turned[row][column] * v[row]).sum()));
    }
    corners.iter().flatten().all(|x: &f64| x.is_finite()).then_some(corners)
}

/// Between the numbers of the table, as the controller has it.
fn largest_n(set: &SafeForce, angle_deg: f64) -> Option<f64> {
    let pairs = set.angle_deg.windows(2).zip(set.force_n.windows(2));
    let last = set.force_n.last().copied();
    let mut within = pairs.filter(|(angle, _)| angle_deg <= angle[1]);
    within.next().map_or(last, |(angle, force)| {
        Some(force[0] + (angle_deg - angle[0]) / (angle[1] - angle[0]) * (force[1] - force[0]))
    })
}
