//! How the readings of one stroke vary together: the same noise of the arm is in its force, its slip and its motors.

use nalgebra::{Cholesky, DMatrix};
use soilctl_effects::Channel;

use crate::channels::spread;
use crate::data::Data;

/// Fewest degrees of freedom from which correlations are learnt.
const FEWEST: f64 = 12.0;
/// Deviations beyond so many standard deviations count as this many: a stroke that goes another way would make everything go together.
const MOST: f64 = 3.0;
/// Least share by which correlations are drawn to 0, whatever the repeats say: arms in the field are not the simulated one. Empirical.
const LEAST_SHRINKAGE: f64 = 0.2;
/// Step by which that share grows until the matrix is safely positive definite.
const STEP: f64 = 0.1;
/// Least square of a diagonal element of the Cholesky factor: the part of a signal's variance that no other signal tells.
const LEAST_OWN: f64 = 0.05;

/// A signal of a stroke: ln of its force over squared depth (`None`), or a column.
type Signal = Option<Channel>;

/// Correlation matrix of the signals of a stroke.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Correlation {
    signals: Vec<Signal>,
    matrix: DMatrix<f64>,
}

impl Correlation {
    /// Learns from strokes that a simulated arm made several times with other noise: deviations of each from the mean of its repeats. Sample
    /// correlations are drawn to 0 by the share that makes their expected square error least (Schaefer & Strimmer 2005). `None` if there
    /// are too few.
    pub(crate) fn of_repeats(repeats: &[&Data]) -> Option<Self> {
        let (first, others) = repeats.split_first()?;
        // Places of each stroke that all repeats have.
        let strokes: Vec<Vec<usize>> = first
            .rows
            .iter()
            .enumerate()
            .filter_map(|(i, row)| {
                let others = others.iter().map(|data| data.place_of(row));
                std::iter::once(Some(i)).chain(others).collect()
            })
            .collect();
        let freedom = (strokes.len() * others.len()) as f64;
        if freedom < FEWEST {
            return None;
        }
        let all = std::iter::once(None).chain(first.channels.keys().copied().map(Some));
        let (signals, columns): (Vec<Signal>, Vec<Vec<f64>>) =
            all.filter_map(|signal| Some((signal, standardised(repeats, &strokes, signal)?))).unzip();
        let n = signals.len();
        let moment = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
        let sample = DMatrix::from_fn(n, n, |i, j| {
            let (a, b) = (&columns[i], &columns[j]);
            if i == j { 1.0 } else { moment(a, b) / (moment(a, a) * moment(b, b)).sqrt() }
        });
        let (mut chance, mut squares) = (0.0, 0.0);
        for i in 0..n {
            for j in 0..i {
                let square = sample[(i, j)].powi(2);
                chance += (1.0 - square).powi(2) / (freedom - 1.0);
                squares += square;
            }
        }
        let mut share = if squares > 0.0 { (chance / squares).clamp(LEAST_SHRINKAGE, 1.0) } else { 1.0 };
        loop {
            let matrix =
                DMatrix::from_fn(n, n, |i, j| if i == j { 1.0 } else { (1.0 - share) * sample[(i, j)] });
            let factor = matrix.clone().cholesky();
            if factor.is_some_and(|factor| (0..n).all(|k| factor.l_dirty()[(k, k)].powi(2) >= LEAST_OWN)) {
                return Some(Self { signals, matrix });
            }
            share = (share + STEP).min(1.0);
        }
    }

    /// Whether it has a column.
    pub(crate) fn has(&self, channel: Channel) -> bool {
        self.signals.contains(&Some(channel))
    }

    /// Lower Cholesky factor of the correlation matrix of some signals, in their order; what it does not know goes with nothing.
    pub(crate) fn factor(&self, of: &[Signal]) -> Option<DMatrix<f64>> {
        let places: Vec<Option<usize>> =
            of.iter().map(|signal| self.signals.iter().position(|known| known == signal)).collect();
        let matrix = DMatrix::from_fn(of.len(), of.len(), |i, j| match (places[i], places[j]) {
            _ if i == j => 1.0,
            (Some(a), Some(b)) => self.matrix[(a, b)],
            _ => 0.0,
        });
        matrix.cholesky().map(Cholesky::unpack)
    }
}

/// Deviations of a signal from the mean over the repeats of each stroke, in standard deviations; `None` if a reading is missing, or nothing
/// varies.
fn standardised(repeats: &[&Data], strokes: &[Vec<usize>], signal: Signal) -> Option<Vec<f64>> {
    let read = |data: &Data, i: usize| match signal {
        None => Some(data.ln_force[i] - 2.0 * data.rows[i].depth_m.ln()),
        Some(channel) => *data.channels.get(&channel)?.get(i)?,
    };
    let mut deviations = Vec::new();
    for places in strokes {
        let readings: Option<Vec<f64>> = repeats.iter().zip(places).map(|(data, &i)| read(data, i)).collect();
        let readings = readings?;
        let mean = readings.iter().sum::<f64>() / readings.len() as f64;
        deviations.extend(readings.iter().map(|reading| reading - mean));
    }
    let sd = spread(&deviations);
    let largest = deviations.iter().fold(0.0_f64, |most, deviation| most.max(deviation.abs()));
    // A column of which most readings are alike has no standard deviation that means anything.
    (sd > 1e-3 * largest && sd > 0.0)
        .then(|| deviations.iter().map(|deviation| (deviation / sd).clamp(-MOST, MOST)).collect())
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use soilctl_strokes::{Campaign, StrokeRow};

    use super::*;
    use crate::self_test::Random;

    /// Repeats of strokes whose readings in free air go with each other by `rho`, and whose drift goes with neither.
    fn repeats(strokes: usize, count: u64, rho: f64) -> Vec<Data> {
        let of = |seed: u64| {
            let mut random = Random::new(5, seed);
            let row = |i: usize, random: &mut Random| {
                let (a, b) = (random.normal(1.0), random.normal(1.0));
                StrokeRow {
                    stroke_id: Some(format!("s{i}")),
                    alpha_deg: 90.0,
                    depth_m: 0.02,
                    width_m: 0.1,
                    force_n: 5.0 * (0.02 * random.normal(1.0)).exp(),
                    air_across_n: Some(i as f64 + 0.1 * a),
                    air_along_n: Some(0.03 * (rho * a + (1.0 - rho * rho).sqrt() * b)),
                    z_drift_m: Some(1e-3 + random.normal(2e-4)),
                    ..StrokeRow::default()
                }
            };
            let rows = (0..strokes).map(|i| row(i, &mut random)).collect();
            let mut data = Data::new("t", rows, Campaign::default()).unwrap();
            data.compare_everything();
            data
        };
        (1..=count).map(of).collect()
    }

    fn learnt(data: &[Data]) -> Option<Correlation> {
        Correlation::of_repeats(&data.iter().collect::<Vec<_>>())
    }

    /// With 400 degrees of freedom a correlation is known to 0.05; the least shrinkage takes a fifth of it.
    #[test]
    fn what_varies_together_is_found_and_what_does_not_is_not() {
        let found = learnt(&repeats(100, 5, 0.8)).unwrap();
        let [air, along, drift] = [Channel::AirAcross, Channel::AirAlong, Channel::ZDrift].map(Some);
        let factor = found.factor(&[air, along, drift, None]).unwrap();
        let matrix = &factor * factor.transpose();
        assert!((matrix[(1, 0)] - 0.8 * 0.8).abs() < 0.05, "{matrix}");
        for (i, j) in [(2, 0), (2, 1), (3, 0), (3, 1), (3, 2)] {
            assert!(matrix[(i, j)].abs() < 0.1, "{matrix}");
        }
        assert!((0..4).all(|k| (matrix[(k, k)] - 1.0).abs() < 1e-12));
        assert!(found.has(Channel::AirAcross) && !found.has(Channel::PostSlope));
        // What it does not know is independent of the rest.
        let apart = found.factor(&[Some(Channel::PostSlope), air]).unwrap();
        assert_eq!((apart[(0, 0)], apart[(1, 0)], apart[(1, 1)]), (1.0, 0.0, 1.0));
    }

    /// Four strokes made five times: 16 degrees of freedom leave any correlation uncertain by 0.25, and most of it is taken back.
    #[test]
    fn few_repeats_say_little() {
        let found = learnt(&repeats(4, 5, 0.0)).unwrap();
        assert!(found.matrix.iter().filter(|r| **r < 1.0).all(|r| r.abs() < 0.4), "{}", found.matrix);
        assert_eq!(learnt(&repeats(4, 3, 0.0)), None);
        assert_eq!(Correlation::of_repeats(&[]), None);
    }

    /// Signals that are one and the same leave a matrix that can be computed with.
    #[test]
    fn signals_that_are_one_are_still_two() {
        let found = learnt(&repeats(100, 5, 1.0)).unwrap();
        let factor = found.factor(&[Channel::AirAcross, Channel::AirAlong].map(Some)).unwrap();
        assert!(factor[(1, 1)].powi(2) >= LEAST_OWN && factor[(1, 0)] > 0.7, "{factor}");
    }
}
