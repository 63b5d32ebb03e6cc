//! What a sensor reads in free air: noise, bias, drift, and the weight that it carries.

mod filter;
mod noise;
mod told;

use nalgebra::{DMatrix, DVector, Matrix3, Vector3};
use soilctl_stats::median;

use self::filter::{Prior, Reading, Track};
pub use self::noise::Noise;
pub use self::told::FreeAir;
use self::told::tell;
use super::survey::{Block, Survey};
use soilctl_motion::Series;

/// Readings in free air are averaged over up to so long, in s: a posture hardly changes meanwhile.
const PIECE_S: f64 = 0.5;
/// Readings further from the model than so many standard deviations are no free air: a bump, a cable that was touched.
const FAR: f64 = 5.0;
/// Rounds of leaving out what is far.
const ROUNDS: usize = 4;
/// Before anything was seen a bias may be anything, in N.
const BIAS_SD_N: f64 = 1e4;
/// The weight that a sensor carries, before anything was seen: one standard deviation about zero, in N.
const WEIGHT_SD_N: f64 = 20.0;
/// How well a weight is known that was given, relative.
const GIVEN_WEIGHT_SD_REL: f64 = 0.01;
/// A bias drifts by about the noise of a sample in so long, in s, before anything was seen.
const DRIFT_S: f64 = 10.0;

/// The model of free air: what would be read at a time in a posture.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct AirModel {
    pub(crate) told: FreeAir,
    force: Option<Track>,
    torque: Option<Track>,
    given: Option<Given>,
    /// Standard deviation of a block's force in N, each axis: noise, and what the model does not explain.
    pub(crate) block_sd_n: [f64; 3],
}

/// A tare that the user gave, and the gravity in the posture in which it is meant.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Given {
    tare: [f64; 6],
    weight_n: Option<f64>,
}

/// What would be read in free air.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Tare {
    pub(crate) wrench: [f64; 6],
    /// Covariance of the force in N^2, sensor's frame.
    pub(crate) covariance: Matrix3<f64>,
    /// The part of it that comes from the weight.
    pub(crate) of_weight: Matrix3<f64>,
}

impl AirModel {
    /// Fits readings of blocks that are thought to be in free air; those that are not are left out. `weight_n` if it is known.
    /// `None` without noise or without readings whose posture is known.
    pub(crate) fn fit(
        survey: &Survey,
        wrenches: &Series<[f64; 6]>,
        air: &[usize],
        weight_n: Option<f64>,
    ) -> Option<Self> {
        let noise = Noise::of(survey, wrenches, air)?;
        let pieces = noise::pieces(&survey.blocks, air, PIECE_S);
        let mut readings: Vec<[Reading; 2]> = pieces
            .into_iter()
            .filter_map(|piece| reading(&survey.blocks[piece], &noise, survey.interval_s))
            .collect();
        let all = readings.len();
        let mut scale = 1.0;
        let mut found = None;
        for _ in 0..ROUNDS {
            let scaled: Vec<Reading> = readings.iter().map(|r| widened(&r[0], scale)).collect();
            let track = best_walk(&scaled, &noise, weight_n)?;
            let distance = |reading: &Reading| -> Option<f64> {
                let (y, _) = track.at(reading.t_s)?.read(&reading.seen);
                Some((reading.y - y).component_div(&reading.variance.map(f64::sqrt)).amax())
            };
            let distances: Vec<f64> = scaled.iter().map(|r| distance(r).unwrap_or(f64::INFINITY)).collect();
            // The largest of three normal components has its median at 1.27 standard deviations.
            let typical = median(&mut distances.clone()) / 1.27;
            let keep = |distance: f64| distance <= FAR * typical.max(1.0);
            let before = readings.len();
            let mut kept = distances.iter().map(|distance| keep(*distance));
            readings.retain(|_| kept.next().unwrap_or(false));
            let settled = readings.len() == before && typical < 1.1;
            if typical > 1.0 {
                scale *= typical;
            }
            found = Some(track);
            if settled {
                break;
            }
        }
        let force = found?;
        let torques: Vec<Reading> = readings.iter().map(|r| widened(&r[1], scale)).collect();
        let torque = best_walk_of_torque(&torques, &noise);
        let told = tell(&force, torque.as_ref(), &readings, noise, all - readings.len());
        let block_sd_n = [0, 1, 2].map(|i| noise.block_sd[i] * scale.max(1.0));
        Some(Self { told, force: Some(force), torque, given: None, block_sd_n })
    }

    /// A tare that was given, as in the posture in which a contact begins. `seen` is what free air told beside: contacts are found by it,
    /// and how far the given tare lies from it is part of the tare's uncertainty.
    pub(crate) fn given(tare: [f64; 6], weight_n: Option<f64>, seen: Option<Self>, survey: &Survey) -> Self {
        let told = seen.as_ref().map_or_else(FreeAir::unseen, |seen| seen.told.clone());
        let rough = |axis: usize| {
            soilctl_stats::noise(&survey.blocks.iter().map(|block| block.wrench[axis]).collect::<Vec<_>>())
        };
        let block_sd_n = seen.as_ref().map_or_else(|| [0, 1, 2].map(rough), |seen| seen.block_sd_n);
        let force = seen.and_then(|seen| seen.force);
        Self { told, force, torque: None, given: Some(Given { tare, weight_n }), block_sd_n }
    }

    /// Size of a block's force beside the tare in N; `None` where the direction of gravity is not known.
    pub(crate) fn force_n(&self, block: &Block) -> Option<f64> {
        self.rest(block).map(|(rest, _)| rest.norm())
    }

    /// Whether the tare was given.
    pub(crate) const fn is_given(&self) -> bool {
        self.given.is_some()
    }

    /// A block's force beside the tare in N, and the covariance of the tare: the fitted one if there is one, since a given tare does not
    /// drift as a sensor does.
    pub(crate) fn rest(&self, block: &Block) -> Option<(Vector3<f64>, Matrix3<f64>)> {
        let gravity = block.gravity?;
        let tare =
            self.fitted(block.t_s, gravity).unwrap_or_else(|| self.force_tare(block.t_s, gravity, gravity));
        Some((Vector3::from_fn(|i, _| block.wrench[i] - tare.wrench[i]), tare.covariance))
    }

    /// What would be read in free air at a time, gravity pointing to `gravity` in the sensor's frame, as in `begin` when the contact
    /// began.
    pub(crate) fn tare(&self, t_s: f64, gravity: [f64; 3], begin: [f64; 3]) -> Tare {
        let mut tare = self.force_tare(t_s, gravity, begin);
        if let Some(state) = self.torque.as_ref().and_then(|track| track.at(t_s)) {
            let (torque, _) = state.read(&turned_moment(gravity));
            tare.wrench[3..].copy_from_slice(torque.as_slice());
        }
        tare
    }

    /// [`Self::tare`] without a torque that was fitted.
    fn force_tare(&self, t_s: f64, gravity: [f64; 3], begin: [f64; 3]) -> Tare {
        if let Some(given) = self.given {
            let turned = |i: usize| given.weight_n.unwrap_or(0.0) * (gravity[i] - begin[i]);
            let mut wrench = given.tare;
            (0..3).for_each(|i| wrench[i] += turned(i));
            let step = Vector3::from(gravity) - Vector3::from(begin);
            let sd_n = given.weight_n.map_or(WEIGHT_SD_N, |weight| GIVEN_WEIGHT_SD_REL * weight);
            let of_weight = step * step.transpose() * (sd_n * sd_n);
            let apart = self
                .fitted(t_s, gravity)
                .map_or_else(Vector3::zeros, |fitted| Vector3::from_fn(|i, _| wrench[i] - fitted.wrench[i]));
            return Tare { wrench, covariance: of_weight + apart * apart.transpose(), of_weight };
        }
        let nothing = Tare { wrench: [0.0; 6], covariance: Matrix3::zeros(), of_weight: Matrix3::zeros() };
        self.fitted(t_s, gravity).unwrap_or(nothing)
    }

    /// The tare that free air tells; `None` if nothing was fitted.
    fn fitted(&self, t_s: f64, gravity: [f64; 3]) -> Option<Tare> {
        let state = self.force.as_ref()?.at(t_s)?;
        let (force, covariance) = state.read(&DMatrix::from_column_slice(3, 1, &gravity));
        // What would still be uncertain if the weight were known; by Schur's complement.
        let weight = state.covariance[(6, 6)].max(f64::MIN_POSITIVE);
        let with: DVector<f64> = state.covariance.column(6).into_owned();
        let along: Vector3<f64> = with.fixed_rows::<3>(0) + Vector3::from(gravity) * weight;
        let mut wrench = [0.0; 6];
        wrench[..3].copy_from_slice(force.as_slice());
        Some(Tare { wrench, covariance, of_weight: along * along.transpose() / weight })
    }
}

/// Mean force and torque of a piece of free air; `None` without a posture.
fn reading(blocks: &[Block], noise: &Noise, interval_s: f64) -> Option<[Reading; 2]> {
    let n = blocks.len() as f64;
    let t_s = blocks.iter().map(|block| block.t_s).sum::<f64>() / n;
    let mean = |axis: usize| blocks.iter().map(|block| block.wrench[axis]).sum::<f64>() / n;
    let mut gravity = Vector3::zeros();
    for block in blocks {
        gravity += Vector3::from(block.gravity?);
    }
    let gravity: [f64; 3] = (gravity / n).into();
    let variance = |axis: usize| {
        // Exact numbers have no noise, but there is always some rounding.
        let sd = noise.block_sd[axis].max(1e-9 * (1.0 + mean(axis).abs()));
        sd * sd * noise.inflation / n
    };
    let of = |from: usize, seen: DMatrix<f64>| Reading {
        t_s,
        length_s: blocks.iter().map(|block| block.samples.len()).sum::<usize>() as f64 * interval_s,
        y: Vector3::from_fn(|i, _| mean(from + i)),
        seen,
        variance: Vector3::from_fn(|i, _| variance(from + i)),
    };
    Some([of(0, DMatrix::from_column_slice(3, 1, &gravity)), of(3, turned_moment(gravity))])
}

/// The torque of a weight is its first moment across gravity: `-[gravity]x m`.
fn turned_moment([x, y, z]: [f64; 3]) -> DMatrix<f64> {
    DMatrix::from_row_slice(3, 3, &[0.0, z, -y, -z, 0.0, x, y, -x, 0.0])
}

fn widened(reading: &Reading, scale: f64) -> Reading {
    Reading { variance: reading.variance * (scale * scale), ..reading.clone() }
}

fn best_walk(readings: &[Reading], noise: &Noise, weight_n: Option<f64>) -> Option<Track> {
    let parameter_sd = weight_n.map_or(WEIGHT_SD_N, |weight| GIVEN_WEIGHT_SD_REL * weight.abs().max(1e-3));
    let prior = Prior {
        bias: BIAS_SD_N,
        drift: noise.force_n().max(1e-9) / DRIFT_S,
        parameter: DVector::from_element(1, weight_n.unwrap_or(0.0)),
        parameter_sd,
    };
    likeliest(readings, &prior, noise.force_n())
}

fn best_walk_of_torque(readings: &[Reading], noise: &Noise) -> Option<Track> {
    let size = (noise.sd[3..].iter().map(|sd| sd * sd).sum::<f64>() / 3.0).sqrt();
    let prior = Prior {
        bias: BIAS_SD_N,
        drift: size.max(1e-9) / DRIFT_S,
        parameter: DVector::zeros(3),
        parameter_sd: WEIGHT_SD_N * 0.1,
    };
    likeliest(readings, &prior, size)
}

/// The random walk, of some sizes in units of the noise, under which the readings are likeliest.
fn likeliest(readings: &[Reading], prior: &Prior, noise: f64) -> Option<Track> {
    let walks = [0.0, 0.0005, 0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2].map(|sd| (sd * noise).powi(2));
    let tracks = walks.iter().filter_map(|walk| Track::of(readings, prior, *walk));
    tracks.max_by(|a, b| a.likelihood.total_cmp(&b.likelihood))
}
