//! The surface by the touch before a stroke. The controller ends a touch at a force that soft soil gives only well below its
//! surface; where the force begins is the surface.

use soilctl_kinematics::Arm;

use super::joints::mean_gap;
use super::sample::{Phase, Sample, tip_and_sensor};
use crate::ProcessError;

/// Samples in a mean force.
const BLOCK: usize = 10;
/// Above this upward force in N there is soil: six standard deviations of a mean of [`BLOCK`] readings.
const CONTACT_N: f64 = 0.08;
/// Over this time in s before contact both encoders are compared.
const COMPARED_S: f64 = 0.8;

/// Height of the soil where the plate met it, in m; `None` if the approach shows no such place.
pub(super) fn touched(arm: &Arm, approach: &[Sample], tare: &[f64; 6]) -> Result<Option<f64>, ProcessError> {
    let touch: Vec<&Sample> = approach.iter().filter(|s| s.phase == Phase::Touch).collect();
    let mut first = None;
    for (block, samples) in touch.chunks_exact(BLOCK).enumerate().rev() {
        let mut up = 0.0;
        for sample in samples {
            let (_, sensor) = tip_and_sensor(arm, &sample.external)?;
            let [x, y, z] = [0, 1, 2].map(|i| sample.wrench[i] - tare[i]);
            up += sensor.direction([x, y, z])[2] / BLOCK as f64;
        }
        if up < CONTACT_N {
            break;
        }
        first = Some(block * BLOCK);
    }
    // In contact from the first block on: the way down was not recorded.
    let Some(contact) = first.and_then(|first| touch.get(first)).filter(|s| s.t_s > touch[0].t_s) else {
        return Ok(None);
    };
    let moving = touch.iter().copied().filter(|s| s.t_s < contact.t_s && s.t_s > contact.t_s - COMPARED_S);
    let Some(gap) = mean_gap(moving) else { return Ok(None) };
    let joints = std::array::from_fn(|i| contact.motor[i] + gap[i]);
    Ok(Some(tip_and_sensor(arm, &joints)?.0.origin_m[2]))
}
