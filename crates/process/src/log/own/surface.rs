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
/// Blocks in contact that are no jolt of the arm.
const STEADY: usize = 3;
/// Over this time in s before contact both encoders are compared.
const COMPARED_S: f64 = 0.8;

/// Way in m in which firm soil ends a touch.
const FIRM_M: f64 = 0.002;
/// The encoders may err by as much in m, if joints turned back shortly before the contact.
const ASTRAY_M: f64 = 0.0012;

/// Height of the soil where the plate met it, in m; `None` if the approach shows no such place.
///
/// `stated_m` is what the controller made of the end of the touch, which it knows by more than one moment: on firm soil it
/// corrects what the encoders say.
pub(super) fn touched(
    arm: &Arm,
    approach: &[Sample],
    tare: &[f64; 6],
    stated_m: Option<f64>,
) -> Result<Option<f64>, ProcessError> {
    let touch: Vec<&Sample> = approach.iter().filter(|s| s.phase == Phase::Touch).collect();
    // Forwards: soft soil may give way for a while after the edge has met it.
    let (mut first, mut pressed) = (None, 0);
    for (block, samples) in touch.chunks_exact(BLOCK).enumerate() {
        let mut up = 0.0;
        for sample in samples {
            let (_, sensor) = tip_and_sensor(arm, &sample.external)?;
            let [x, y, z] = [0, 1, 2].map(|i| sample.wrench[i] - tare[i]);
            up += sensor.direction([x, y, z])[2] / BLOCK as f64;
        }
        pressed = if up >= CONTACT_N { pressed + 1 } else { 0 };
        if pressed == STEADY {
            first = Some((block + 1 - STEADY) * BLOCK);
            break;
        }
    }
    // In contact from the first block on: the way down was not recorded.
    let Some(contact) = first.and_then(|first| touch.get(first)).filter(|s| s.t_s > touch[0].t_s) else {
        return Ok(None);
    };
    let moving = touch.iter().copied().filter(|s| s.t_s < contact.t_s && s.t_s > contact.t_s - COMPARED_S);
    let Some(gap) = mean_gap(moving) else { return Ok(None) };
    let height = |motor: &[f64; 5]| -> Result<f64, ProcessError> {
        let joints = std::array::from_fn(|i| motor[i] + gap[i]);
        Ok(tip_and_sensor(arm, &joints)?.0.origin_m[2])
    };
    let seen_m = height(&contact.motor)?;
    let (Some(stated_m), Some(end)) = (stated_m, touch.last()) else { return Ok(Some(seen_m)) };
    let way_m = seen_m - height(&end.motor)?;
    let astray = way_m < FIRM_M && (stated_m + way_m - seen_m).abs() > ASTRAY_M;
    Ok(Some(if astray { stated_m + way_m } else { seen_m }))
}
