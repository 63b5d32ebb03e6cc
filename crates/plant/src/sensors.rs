//! Encoders and amplifiers: what they report of the true state.

use std::f64::consts::TAU;

use crate::config::{AmplifiersConfig, EncodersConfig};
use crate::drives::Drives;
use crate::noise::Noise;

/// Counts of the motor encoders: whole counts, as the rotor has passed them.
pub(crate) fn motor_counts(config: &EncodersConfig, drives: &Drives) -> [i32; 5] {
    std::array::from_fn(|i| {
        count(drives.angle_rad[i], config.motor_counts_per_turn[i], config.motor_offset_counts[i])
    })
}

/// Counts of the external encoders, on the joint or on the motor's output.
pub(crate) fn external_counts(config: &EncodersConfig, drives: &Drives, joints: &[f64; 5]) -> [i32; 5] {
    let (links, outputs) = (drives.links_rad(joints), drives.outputs_rad(joints));
    std::array::from_fn(|i| {
        let angle = if config.external_on_joint[i] { links[i] } else { outputs[i] };
        count(angle, config.external_counts_per_turn[i], config.external_offset_counts[i])
    })
}

/// A counter of 32 bits stops at its end.
fn count(angle_rad: f64, per_turn: f64, offset: i32) -> i32 {
    let counts = (angle_rad * per_turn / TAU).floor() + f64::from(offset);
    #[allow(clippy::cast_possible_truncation, reason = "the cast saturates, as the counter does")]
    let counts = counts as i32;
    counts
}

/// Currents in A and voltages in V that the amplifiers report for these motor torques in N m.
pub(crate) fn amplifiers(
    config: &AmplifiersConfig,
    torques_nm: &[f64; 5],
    noise: &mut Noise,
) -> ([f64; 5], [f64; 5]) {
    let currents = std::array::from_fn(|i| {
        torques_nm[i] * config.current_a_per_nm[i] + config.current_noise_a * noise.normal()
    });
    let voltages = std::array::from_fn(|_| config.supply_v + config.supply_noise_v * noise.normal());
    (currents, voltages)
}
