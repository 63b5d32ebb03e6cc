//! How well a stroke's depth is known: surface and edge are both read by encoders that count in steps, and a touch presses the
//! surface a little before it is felt.

use soilctl_kinematics::Arm;

use super::sample::tip_and_sensor;
use crate::ProcessError;

/// Standard deviation in m of a surface that was touched, beside what the encoders leave open.
const TOUCH_SD_M: f64 = 0.0002;
/// The same where the surface is only stated: what a raked box is level within.
const STATED_SD_M: f64 = 0.0005;

/// Standard deviation of a depth in m: an encoder's step, seen as a height at the edge and spread evenly, in the surface and again
/// in the edge's place at failure, and the surface itself.
pub(super) fn depth_sd_m(
    arm: &Arm,
    joints: &[f64; 5],
    half_steps: &[f64; 5],
    is_touched: bool,
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
    let surface = if is_touched { TOUCH_SD_M } else { STATED_SD_M };
    Ok((2.0 * variance + surface * surface).sqrt())
}
