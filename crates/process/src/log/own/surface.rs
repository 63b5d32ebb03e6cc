//! The surface by the touch before a stroke. The controller ends a touch at a force that soft soil gives only well below its
//! surface; where the force begins is the surface.

use soilctl_kinematics::Arm;
use soilctl_stats::{least_squares, mean_and_sd};

use super::sample::{Phase, Sample, tip_and_sensor};
use crate::ProcessError;

/// Samples in a mean force.
const BLOCK: usize = 10;
/// Above this upward force in N there is soil, with a sensor whose noise in free air is no larger: six standard deviations of a mean of [`BLOCK`]
/// independent readings of 0.04 N.
const CONTACT_N: f64 = 0.08;
/// Standard deviations of such means in free air above which there is soil. Noise that lasts longer than a block does not average out, so it is
/// measured: at 27 mm above the soil a reading of correlated noise was taken for it.
const CONTACT_SD: f64 = 5.0;
/// Fewest means that tell their standard deviation.
const FEWEST: usize = 5;
/// Blocks in contact that are no jolt of the arm.
const STEADY: usize = 3;
/// Over so many samples before and after contact the height of the edge is fitted by a line.
const FITTED: usize = 50;

/// Where the plate met the soil.
#[derive(Debug, Clone, Copy)]
pub(super) struct Touch {
    /// Height in m, by the external encoders.
    pub(super) z_m: f64,
    /// Force above which there was soil, over that of a sensor of little noise: so much later contact is felt.
    pub(super) late: f64,
}

/// The soil where the plate met it; `None` if the approach shows no such place.
///
/// The motors would be finer, but a plate that comes down slowly takes up free play on its way, which they count as motion.
pub(super) fn touched(
    arm: &Arm,
    approach: &[Sample],
    tare: &[f64; 6],
) -> Result<Option<Touch>, ProcessError> {
    let air = upward_n(arm, approach.iter().filter(|s| s.phase == Phase::Bias), tare)?;
    let contact_n = contact_force_n(&air);
    let touch: Vec<&Sample> = approach.iter().filter(|s| s.phase == Phase::Touch).collect();
    let pressed = upward_n(arm, touch.iter().copied(), tare)?;
    // In contact from the first block on: the way down was not recorded.
    let Some(contact) = first_contact(&pressed, contact_n).filter(|first| *first > 0) else {
        return Ok(None);
    };
    let contact = contact * BLOCK;
    let near = &touch[contact.saturating_sub(FITTED)..(contact + FITTED).min(touch.len())];
    let Some(met) = touch.get(contact) else { return Ok(None) };
    let rows: Vec<([f64; 2], f64, f64)> = near
        .iter()
        .map(|s| Ok(([1.0, s.t_s - met.t_s], tip_and_sensor(arm, &s.external)?.0.origin_m[2], 1.0)))
        .collect::<Result<_, ProcessError>>()?;
    Ok(least_squares(rows.into_iter()).map(|line| Touch { z_m: line.x[0], late: contact_n / CONTACT_N }))
}

/// Mean upward force in N of each block of samples, tare off.
fn upward_n<'a>(
    arm: &Arm,
    samples: impl Iterator<Item = &'a Sample>,
    tare: &[f64; 6],
) -> Result<Vec<f64>, ProcessError> {
    let up = |sample: &Sample| {
        let (_, sensor) = tip_and_sensor(arm, &sample.external)?;
        let [x, y, z] = [0, 1, 2].map(|i| sample.wrench[i] - tare[i]);
        Ok(sensor.direction([x, y, z])[2])
    };
    let all: Vec<f64> = samples.map(up).collect::<Result<_, ProcessError>>()?;
    Ok(all.chunks_exact(BLOCK).map(|block| block.iter().sum::<f64>() / BLOCK as f64).collect())
}

/// Upward force in N above which there is soil, by mean forces in free air.
fn contact_force_n(air_n: &[f64]) -> f64 {
    let noise = mean_and_sd(air_n).filter(|_| air_n.len() >= FEWEST);
    noise.map_or(CONTACT_N, |(_, sd)| CONTACT_N.max(CONTACT_SD * sd))
}

/// The first block of those that stay in contact. Forwards: soft soil may give way for a while after the edge has met it.
fn first_contact(up_n: &[f64], contact_n: f64) -> Option<usize> {
    up_n.windows(STEADY).position(|blocks| blocks.iter().all(|up| *up >= contact_n))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Means of blocks of noise with a standard deviation of 0.06 N that lasts over 30 ms: `x' = rho x + sqrt(1 - rho^2) e`, e uniform.
    fn noise(seed: u64, blocks: usize) -> Vec<f64> {
        let (mut state, mut x) = (seed, 0.0);
        let mut uniform = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
        };
        let rho = 0.95_f64;
        let mut reading = || {
            x = rho * x + (1.0 - rho * rho).sqrt() * 12_f64.sqrt() * 0.06 * uniform();
            x
        };
        (0..blocks).map(|_| (0..BLOCK).map(|_| reading()).sum::<f64>() / BLOCK as f64).collect()
    }

    /// A plate that comes down through the air for 20 s and then presses by 2 N/s: no noise is taken for soil, and soil is felt within 0.3 s.
    #[test]
    fn noise_that_lasts_is_no_soil() {
        let mut by_fixed_force = 0;
        for seed in 1..40 {
            let air = noise(seed, 100);
            let contact_n = contact_force_n(&air);
            let way: Vec<f64> = noise(seed + 1_000, 1_100)
                .into_iter()
                .enumerate()
                .map(|(block, up)| up + 0.04 * (block as f64 - 1_000.0).max(0.0))
                .collect();
            let found = first_contact(&way, contact_n);
            assert!(
                found.is_some_and(|block| (1_000..1_015).contains(&block)),
                "{seed}: {found:?} {contact_n}"
            );
            by_fixed_force += usize::from(first_contact(&way, CONTACT_N).is_some_and(|block| block < 1_000));
        }
        assert!(by_fixed_force > 30, "{by_fixed_force}");
    }

    /// A sensor of little noise keeps the force, as does an approach that says nothing of it.
    #[test]
    fn little_noise_changes_nothing() {
        let quiet: Vec<f64> = noise(3, 100).iter().map(|up| 0.1 * up).collect();
        assert_eq!((contact_force_n(&quiet), contact_force_n(&[0.5; 4])), (CONTACT_N, CONTACT_N));
        assert_eq!(first_contact(&[0.0, 0.2, 0.2, 0.0, 0.1, 0.1, 0.1], CONTACT_N), Some(4));
        assert_eq!(first_contact(&[0.2, 0.2], CONTACT_N), None);
    }
}
