//! Where the joints are in a stroke. The external encoders are free of play but resolve 1.27 mm at the plate; the motors'
//! are fine, but behind free play and stretch. Joined, they are both fine and right.

use soilctl_kinematics::{Arm, JointAngles, MotorAngles};
use soilctl_stats::{Solved, least_squares};

use super::sample::Sample;
use crate::ProcessError;

/// Once the pull has exceeded this share of the highest one the free play is taken up, and the motors' readings, shifted and
/// stretched, agree with the external ones.
const TAUT: f64 = 0.35;
/// Where they disagree by fewer half steps than the first they count alone, by more than the second not at all.
const AGREE: [f64; 2] = [2.0, 4.0];
/// Samples over which a force is averaged to tell how taut the arm is.
const SMOOTH: usize = 25;
/// So much may a drive stretch, in rad/N at the plate, one standard deviation: what is expected before it is measured.
const STRETCH_RAD_PER_N: f64 = 3e-4;
/// So many independent readings are in the steps of an external encoder in one stroke.
const INDEPENDENT: f64 = 20.0;

/// Half a step of each joint's external reading in rad.
pub(super) fn half_steps(arm: &Arm) -> Result<[f64; 5], ProcessError> {
    let step = std::f64::consts::TAU / f64::from(arm.config().transmission.encoder_counts_per_turn);
    let map = arm.transmission();
    let zero = map.joint_angles(&MotorAngles([0.0; 5])).map_err(ProcessError::arm)?;
    let mut half = [0.0; 5];
    for motor in 0..5 {
        let mut angles = [0.0; 5];
        angles[motor] = step;
        let moved = map.joint_angles(&MotorAngles(angles)).map_err(ProcessError::arm)?;
        for (sum, (a, b)) in half.iter_mut().zip(moved.0.iter().zip(zero.0)) {
            *sum += 0.5 * (a - b).abs();
        }
    }
    Ok(half)
}

/// Joints of each sample in rad, before flexion, and whether an encoder jumped; `force_n` is the pull of each sample.
pub(super) fn joined(samples: &[Sample], force_n: &[f64], half_steps: &[f64; 5]) -> (Vec<[f64; 5]>, bool) {
    let mut joints: Vec<[f64; 5]> = samples.iter().map(|s| s.external).collect();
    let held: Vec<usize> = (taut_from(force_n)..samples.len()).collect();
    if held.len() < 50 {
        return (joints, false);
    }
    let mut jumped = false;
    for joint in 0..5 {
        let noise = half_steps[joint] / 3.0_f64.sqrt();
        let gap = |i: usize| samples[i].external[joint] - samples[i].motor[joint];
        let Some((shift, stretch)) = line(&held, &gap, force_n, noise) else { continue };
        let along = |i: usize| shift + stretch * force_n[i];
        jumped |= held.iter().filter(|i| (gap(**i) - along(**i)).abs() > 5.0 * half_steps[joint]).count() > 2;
        for (i, place) in joints.iter_mut().enumerate() {
            let apart = (gap(i) - along(i)).abs() / half_steps[joint];
            let share = ((AGREE[1] - apart) / (AGREE[1] - AGREE[0])).clamp(0.0, 1.0);
            place[joint] += share * (samples[i].motor[joint] + along(i) - place[joint]);
        }
    }
    (joints, jumped)
}

/// First sample at which the mean force has exceeded its share of the highest.
fn taut_from(force_n: &[f64]) -> usize {
    let mut sorted = force_n.to_vec();
    sorted.sort_by(f64::total_cmp);
    let high = sorted.get(sorted.len() * 98 / 100).copied().unwrap_or(0.0).max(f64::MIN_POSITIVE);
    let exceeds = |mean: &[f64]| mean.iter().sum::<f64>() > TAUT * high * SMOOTH as f64;
    force_n.windows(SMOOTH).position(exceeds).map_or(force_n.len(), |first| first + SMOOTH)
}

/// External minus motor reading as a shift and a stretch in proportion to the force, jumps left out by a second look.
fn line(held: &[usize], gap: &dyn Fn(usize) -> f64, force_n: &[f64], noise: f64) -> Option<(f64, f64)> {
    let fit = |kept: &[usize]| -> Option<(f64, f64)> {
        let weight = INDEPENDENT / (kept.len().max(1) as f64 * noise * noise);
        let rows = kept.iter().map(|i| ([1.0, force_n[*i]], gap(*i), weight));
        let expected = ([0.0, 1.0], 0.0, STRETCH_RAD_PER_N.powi(-2));
        let Solved { x: [shift, stretch], .. } = least_squares(rows.chain([expected]))?;
        Some((shift, stretch))
    };
    let mut middle: Vec<f64> = held.iter().map(|i| gap(*i)).collect();
    let centre = soilctl_stats::median(&mut middle);
    let near: Vec<usize> = held.iter().copied().filter(|i| (gap(*i) - centre).abs() < 8.0 * noise).collect();
    fit(if near.len() >= 50 { &near } else { held })
}

/// Mean of external minus motor reading over samples, by joint; `None` of fewer than ten.
pub(super) fn mean_gap<'a>(samples: impl Iterator<Item = &'a Sample>) -> Option<[f64; 5]> {
    let (mut sum, mut count) = ([0.0; 5], 0.0);
    for sample in samples {
        for (total, (a, b)) in sum.iter_mut().zip(sample.external.iter().zip(sample.motor)) {
            *total += a - b;
        }
        count += 1.0;
    }
    (count >= 10.0).then(|| sum.map(|total| total / count))
}

/// Joints behind the encoders when the soil presses on the plate with this force (N, root frame): cables stretch.
pub(super) fn flexed(arm: &Arm, joints: &[f64; 5], force_n: [f64; 3]) -> Result<[f64; 5], ProcessError> {
    arm.compensate_flexion(&JointAngles(*joints), force_n, &arm.elbow_compliance())
        .map(|found| found.0)
        .map_err(ProcessError::arm)
}
