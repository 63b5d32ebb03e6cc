//! Bias, its drift and what turns with the sensor, estimated together by a Kalman filter and the Rauch-Tung-Striebel smoother.
//!
//! A reading in free air is `y = b(t) + H(t) p + e`: a bias `b` of three components that drifts steadily and, beside that, walks at
//! random; parameters `p` that do not change, such as a weight, seen through a matrix `H` that depends on the posture; white noise
//! `e`. The state is `(b, b', p)`; between readings `b` moves by `b' dt` and gathers the variance `q dt` (a local linear trend: Harvey,
//! Forecasting, Structural Time Series Models and the Kalman Filter, 1989, chapter 2). The smoother gives mean and
//! covariance at every time, whether there was a reading or not, so the uncertainty grows by itself away from free air.

use nalgebra::{DMatrix, DVector, Matrix3, Vector3};

/// One reading in free air.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Reading {
    pub(super) t_s: f64,
    pub(super) y: Vector3<f64>,
    /// Three rows, a column a parameter.
    pub(super) seen: DMatrix<f64>,
    /// Time that it is the mean of, in s.
    pub(super) length_s: f64,
    /// Variance of each component.
    pub(super) variance: Vector3<f64>,
}

/// What is believed before any reading: standard deviations about 0, or about `parameter`.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Prior {
    pub(super) bias: f64,
    /// Of the drift, a second.
    pub(super) drift: f64,
    pub(super) parameter: DVector<f64>,
    pub(super) parameter_sd: f64,
}

/// Mean and covariance of the state at the times of readings, forwards and smoothed.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Track {
    t_s: Vec<f64>,
    forward: Vec<State>,
    smooth: Vec<State>,
    /// Variance that the bias gathers in a second.
    walk: f64,
    /// Logarithm of the likelihood of the readings.
    pub(super) likelihood: f64,
}

/// Mean and covariance.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct State {
    pub(super) mean: DVector<f64>,
    pub(super) covariance: DMatrix<f64>,
}

impl State {
    /// What would be read in free air, and its covariance.
    pub(super) fn read(&self, seen: &DMatrix<f64>) -> (Vector3<f64>, Matrix3<f64>) {
        let h = observation(seen);
        let (mean, covariance) = (&h * &self.mean, &h * &self.covariance * h.transpose());
        (mean.fixed_rows::<3>(0).into(), covariance.fixed_view::<3, 3>(0, 0).into())
    }

    fn moved(&self, dt_s: f64, walk: f64) -> Self {
        let f = transition(self.mean.len(), dt_s);
        let mut covariance = &f * &self.covariance * f.transpose();
        (0..3).for_each(|i| covariance[(i, i)] += walk * dt_s.abs());
        Self { mean: &f * &self.mean, covariance }
    }
}

fn transition(size: usize, dt_s: f64) -> DMatrix<f64> {
    let mut f = DMatrix::identity(size, size);
    (0..3).for_each(|i| f[(i, i + 3)] = dt_s);
    f
}

fn observation(seen: &DMatrix<f64>) -> DMatrix<f64> {
    let mut h = DMatrix::zeros(3, 6 + seen.ncols());
    (0..3).for_each(|i| h[(i, i)] = 1.0);
    h.view_mut((0, 6), (3, seen.ncols())).copy_from(seen);
    h
}

impl Track {
    /// Runs through readings in order of time. `None` of no reading, or if a covariance cannot be inverted.
    pub(super) fn of(readings: &[Reading], prior: &Prior, walk: f64) -> Option<Self> {
        let first = readings.first()?;
        let parameters = prior.parameter.len();
        let mut now = State {
            mean: DVector::zeros(6 + parameters),
            covariance: DMatrix::zeros(6 + parameters, 6 + parameters),
        };
        now.mean.rows_mut(6, parameters).copy_from(&prior.parameter);
        for i in 0..now.mean.len() {
            let sd = [prior.bias, prior.drift, prior.parameter_sd][(i / 3).min(2)];
            now.covariance[(i, i)] = sd * sd;
        }
        let mut track = Self {
            t_s: readings.iter().map(|reading| reading.t_s).collect(),
            forward: Vec::with_capacity(readings.len()),
            smooth: Vec::new(),
            walk,
            likelihood: 0.0,
        };
        let mut t_s = first.t_s;
        for reading in readings {
            now = now.moved(reading.t_s - t_s, walk);
            t_s = reading.t_s;
            let h = observation(&reading.seen);
            let mut spread = &h * &now.covariance * h.transpose();
            (0..3).for_each(|i| spread[(i, i)] += reading.variance[i]);
            let inverse = spread.clone().cholesky()?;
            let miss = DVector::from_column_slice(reading.y.as_slice()) - &h * &now.mean;
            let gain = &now.covariance * h.transpose() * inverse.inverse();
            track.likelihood -= 0.5 * (miss.dot(&inverse.solve(&miss)) + inverse.ln_determinant());
            now.mean += &gain * miss;
            // Joseph's form keeps the covariance symmetric and positive.
            let rest = DMatrix::identity(now.mean.len(), now.mean.len()) - &gain * &h;
            let noise = DMatrix::from_diagonal(&DVector::from_column_slice(reading.variance.as_slice()));
            now.covariance = &rest * &now.covariance * rest.transpose() + &gain * noise * gain.transpose();
            track.forward.push(now.clone());
        }
        track.smooth.clone_from(&track.forward);
        for k in (0..readings.len() - 1).rev() {
            track.smooth[k] = track.back(&track.forward[k], readings[k + 1].t_s - readings[k].t_s, k + 1)?;
        }
        Some(track)
    }

    /// The state at any time.
    pub(super) fn at(&self, t_s: f64) -> Option<State> {
        let next = self.t_s.partition_point(|known| *known < t_s);
        let Some(before) = next.checked_sub(1) else {
            let first = self.smooth.first()?;
            return Some(first.moved(t_s - self.t_s.first()?, self.walk));
        };
        let now = self.forward.get(before)?.moved(t_s - self.t_s.get(before)?, self.walk);
        match self.t_s.get(next) {
            None => Some(now),
            Some(next_s) => self.back(&now, next_s - t_s, next),
        }
    }

    /// What the smoothed state `dt_s` later adds to one that knows only of earlier readings.
    fn back(&self, now: &State, dt_s: f64, next: usize) -> Option<State> {
        let later = self.smooth.get(next)?;
        let ahead = now.moved(dt_s, self.walk);
        let size = now.mean.len();
        // A direction in which nothing is uncertain would leave no inverse.
        let scale = ahead.covariance.diagonal().max().max(f64::MIN_POSITIVE);
        let ridge = DMatrix::identity(size, size) * (1e-14 * scale);
        let inverse = (&ahead.covariance + ridge).cholesky()?;
        let gain = inverse.solve(&(transition(size, dt_s) * &now.covariance)).transpose();
        Some(State {
            mean: &now.mean + &gain * (&later.mean - &ahead.mean),
            covariance: &now.covariance + &gain * (&later.covariance - &ahead.covariance) * gain.transpose(),
        })
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    /// Without a walk all readings are one least-squares problem, which is solved at once here.
    #[test]
    fn without_a_walk_it_is_least_squares() {
        let prior =
            Prior { bias: 50.0, drift: 0.1, parameter: DVector::from_element(1, 2.0), parameter_sd: 20.0 };
        let readings: Vec<Reading> = (0..12)
            .map(|k| {
                let t_s = 3.0 * f64::from(k);
                let lean = 0.2 * f64::from(k % 5);
                let seen = DMatrix::from_column_slice(3, 1, &[lean.sin(), 0.1, -lean.cos()]);
                let bump = 0.01 * f64::from((7 * k) % 11);
                let y = Vector3::new(1.0 + bump, -2.0 + 0.002 * t_s, 4.0) + 3.4 * seen.column(0);
                Reading { t_s, y, seen, length_s: 0.5, variance: Vector3::new(1e-4, 2e-4, 3e-4) }
            })
            .collect();
        let track = Track::of(&readings, &prior, 0.0).unwrap();
        let at_s = 17.0;
        // Unknown is the state at that time; the prior holds at the first reading.
        let first = transition(7, readings[0].t_s - at_s);
        let sds = [50.0, 50.0, 50.0, 0.1, 0.1, 0.1, 20.0].map(|sd: f64| 1.0 / (sd * sd));
        let weight = DMatrix::from_diagonal(&DVector::from_row_slice(&sds));
        let mut mean = DVector::zeros(7);
        mean[6] = 2.0;
        let mut normal = first.transpose() * &weight * &first;
        let mut right = first.transpose() * &weight * mean;
        for reading in &readings {
            let h = observation(&reading.seen) * transition(7, reading.t_s - at_s);
            let inverse =
                DMatrix::from_diagonal(&DVector::from_iterator(3, reading.variance.iter().map(|v| 1.0 / v)));
            normal += h.transpose() * &inverse * &h;
            right += h.transpose() * &inverse * DVector::from_column_slice(reading.y.as_slice());
        }
        let covariance = normal.try_inverse().unwrap();
        let found = track.at(at_s).unwrap();
        assert!((&found.mean - &covariance * right).amax() < 1e-6);
        assert!((&found.covariance - &covariance).amax() < 1e-6 * covariance.amax());
    }

    /// Between two times with readings a random walk is least certain halfway, by the variance of a Brownian bridge.
    #[test]
    fn a_walk_is_least_certain_between_readings() {
        let prior = Prior { bias: 1e3, drift: 1e-9, parameter: DVector::zeros(1), parameter_sd: 1e-9 };
        let reading = |t_s: f64| Reading {
            t_s,
            y: Vector3::zeros(),
            seen: DMatrix::zeros(3, 1),
            length_s: 0.5,
            variance: Vector3::from_element(1e-10),
        };
        let track = Track::of(&[reading(0.0), reading(10.0)], &prior, 0.04).unwrap();
        let variance = |t_s: f64| track.at(t_s).unwrap().covariance[(0, 0)];
        assert!((variance(5.0) / (0.04 * 5.0 * 5.0 / 10.0) - 1.0).abs() < 1e-3, "{}", variance(5.0));
        assert!((variance(2.0) / (0.04 * 2.0 * 8.0 / 10.0) - 1.0).abs() < 1e-3);
        assert!((variance(14.0) / (0.04 * 4.0) - 1.0).abs() < 1e-3);
    }
}
