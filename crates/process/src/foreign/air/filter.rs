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
