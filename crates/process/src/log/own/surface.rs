//! The surface by the touch before a stroke. The controller ends a touch at a force that soft soil gives only well below its
//! surface; where the force begins is the surface.

use soilctl_kinematics::Arm;
use soilctl_stats::least_squares;

use super::sample::{Phase, Sample, tip_and_sensor};
use crate::ProcessError;

/// Samples in a mean force.
const BLOCK: usize = 10;
/// Above this upward force in N there is soil: six standard deviations of a mean of [`BLOCK`] readings.
const CONTACT_N: f64 = 0.08;
/// Blocks in contact that are no jolt of the arm.
const STEADY: usize = 3;
/// Over so many samples before and after contact the height of the edge is fitted by a line.
const FITTED: usize = 50;

/// Height of the soil where the plate met it, in m, by the external encoders; `None` if the approach shows no such place.
///
/// The motors would be finer, but a plate that comes down slowly takes up free play on its way, which they count as motion.
pub(super) fn touched(arm: &Arm, approach: &[Sample], tare: &[f64; 6]) -> Result<Option<f64>, ProcessError> {
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
    let Some(contact) = first.filter(|first| *first > 0) else { return Ok(None) };
    let near = &touch[contact.saturating_sub(FITTED)..(contact + FITTED).min(touch.len())];
    let Some(met) = touch.get(contact) else { return Ok(None) };
    let rows: Vec<([f64; 2], f64, f64)> = near
        .iter()
        .map(|s| Ok(([1.0, s.t_s - met.t_s], tip_and_sensor(arm, &s.external)?.0.origin_m[2], 1.0)))
        .collect::<Result<_, ProcessError>>()?;
    Ok(least_squares(rows.into_iter()).map(|line| line.x[0]))
}
