//! What free air told, in numbers for people.

use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::filter::{Reading, State, Track};
use super::{Noise, WEIGHT_SD_N};

/// Postures whose directions of gravity differ by less than this, in rad, are one.
const ONE_POSTURE: f64 = 0.02;

/// What free air told.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct FreeAir {
    /// Time in free air that was used, in s.
    pub seconds: f64,
    /// Noise; `None` if a tare was given and no free air was found.
    pub noise: Option<Noise>,
    /// Reading without weight at the middle of the log, in N and N m.
    pub bias: [f64; 6],
    /// Its standard deviations.
    pub bias_sd: [f64; 6],
    /// Drift of the forces in N/s.
    pub drift_n_per_s: [f64; 3],
    /// Their standard deviations.
    pub drift_sd_n_per_s: [f64; 3],
    /// Weight of what the sensor carries in N.
    pub weight_n: f64,
    /// Its standard deviation.
    pub weight_sd_n: f64,
    /// Its centre of mass in the sensor's frame in m, if the weight is well known.
    pub centre_m: Option<[f64; 3]>,
    /// Largest angle between the directions of gravity in the sensor's frame, in deg.
    pub postures_deg: f64,
    /// Pieces of free air that did not fit and were left out.
    pub left_out: usize,
}

impl FreeAir {
    pub(super) fn unseen() -> Self {
        Self {
            seconds: 0.0,
            noise: None,
            bias: [0.0; 6],
            bias_sd: [0.0; 6],
            drift_n_per_s: [0.0; 3],
            drift_sd_n_per_s: [0.0; 3],
            weight_n: 0.0,
            weight_sd_n: WEIGHT_SD_N,
            centre_m: None,
            postures_deg: 0.0,
            left_out: 0,
        }
    }

    /// Whether weight and bias could not be told apart, since all free air has one posture.
    #[must_use]
    pub fn has_one_posture(&self) -> bool {
        self.postures_deg.to_radians() < ONE_POSTURE
    }
}

pub(super) fn tell(
    force: &Track,
    torque: Option<&Track>,
    readings: &[[Reading; 2]],
    noise: Noise,
    left_out: usize,
) -> FreeAir {
    let middle_s = readings.get(readings.len() / 2).map_or(0.0, |reading| reading[0].t_s);
    let mut told = FreeAir { noise: Some(noise), left_out, ..FreeAir::unseen() };
    told.seconds = readings.iter().map(|reading| reading[0].length_s).sum();
    let put = |state: &State, from: usize, told: &mut FreeAir| {
        for i in 0..3 {
            told.bias[from + i] = state.mean[i];
            told.bias_sd[from + i] = state.covariance[(i, i)].max(0.0).sqrt();
        }
    };
    if let Some(state) = force.at(middle_s) {
        put(&state, 0, &mut told);
        told.weight_n = state.mean[6];
        told.weight_sd_n = state.covariance[(6, 6)].max(0.0).sqrt();
        told.drift_n_per_s = [3, 4, 5].map(|i| state.mean[i]);
        told.drift_sd_n_per_s = [3, 4, 5].map(|i| state.covariance[(i, i)].max(0.0).sqrt());
    }
    if let Some(state) = torque.and_then(|track| track.at(middle_s)) {
        put(&state, 3, &mut told);
        let known = told.weight_n > 5.0 * told.weight_sd_n;
        told.centre_m = known.then(|| [6, 7, 8].map(|i| state.mean[i] / told.weight_n));
    }
    let directions: Vec<Vector3<f64>> =
        readings.iter().map(|r| Vector3::from_fn(|i, _| r[0].seen[(i, 0)])).collect();
    let first = directions.first().copied().unwrap_or_default();
    // The two furthest apart lie, up to a factor of two, as far as the furthest from any one.
    let furthest = |from: Vector3<f64>| {
        directions
            .iter()
            .copied()
            .max_by(|a, b| (a - from).norm().total_cmp(&(b - from).norm()))
            .unwrap_or(from)
    };
    let one = furthest(first);
    told.postures_deg = one.angle(&furthest(one)).to_degrees();
    told
}
