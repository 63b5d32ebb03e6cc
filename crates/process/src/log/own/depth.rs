//! How well a stroke's depth is known: the surface is read by encoders that count in steps, and a touch presses it a little before it is
//! felt. The edge's place at failure adds nothing to that: there motors and external encoders are joined, and agree in the mean.

use soilctl_kinematics::Arm;

use super::sample::tip_and_sensor;
use crate::ProcessError;

/// Standard deviation in m of a surface that was touched with a sensor of little noise, beside what the encoders leave open.
const TOUCH_SD_M: f64 = 0.0002;
/// The same where the surface is only stated: what a raked box is level within.
const STATED_SD_M: f64 = 0.0005;

/// Standard deviation of a depth in m: steps of the encoders, seen as a height at the edge and spread evenly, and the surface itself.
/// A surface that was touched is as uncertain as contact is felt late: `touched` is that over what it is with a sensor of little noise.
/// 0.25 to 0.33 mm for the thesis's arm; the depths of 49 simulated strokes in four soils were off by 0.20 mm (`docs/process.md`).
pub(super) fn depth_sd_m(
    arm: &Arm,
    joints: &[f64; 5],
    half_steps: &[f64; 5],
    touched: Option<f64>,
) -> Result<f64, ProcessError> {
    let height = |joints: &[f64; 5]| Ok::<_, ProcessError>(tip_and_sensor(arm, joints)?.0.origin_m[2]);
    let at = height(joints)?;
    let mut variance = 0.0;
    for (joint, half_step) in half_steps.iter().enumerate() {
        let mut moved = *joints;
        moved[joint] += half_step;
        // From -half to +half a step, all equally likely: half a step over the root of three.
        variance += (height(&moved)? - at).powi(2) / 3.0;
    }
    let surface = touched.map_or(STATED_SD_M, |late| late * TOUCH_SD_M);
    Ok((variance + surface * surface).sqrt())
}
