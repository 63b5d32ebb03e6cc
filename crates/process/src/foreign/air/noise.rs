//! Noise of a force sensor at rest: its size for each axis, and up to which frequency it reaches.

use std::ops::Range;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_stats::median;

use super::super::survey::{Block, Survey};
use crate::ForceNoise;
use soilctl_motion::Series;

/// Length of the pieces over which noise is looked at, in s; and the fewest samples in one.
const PIECE_S: f64 = 1.0;
const FEWEST: usize = 12;
/// Correlation of neighbouring samples from which on the noise counts as limited in band.
const CORRELATED: f64 = 0.15;

/// What the sensor reads without cause.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Noise {
    /// Standard deviation of one sample: force in N, torque in N m.
    pub sd: [f64; 6],
    /// Standard deviation of the mean over a block.
    #[serde(skip)]
    pub(crate) block_sd: [f64; 6],
    #[serde(skip)]
    /// So many times less do blocks average out than independent ones would; at least 1.
    pub(crate) inflation: f64,
    /// Corner frequency in Hz of the noise of the forces, as of a filter of first order; `None` if it is white up to half the
    /// rate of samples.
    pub corner_hz: Option<f64>,
}

impl Noise {
    /// From blocks in free air. `None` if there are not enough.
    pub(crate) fn of(survey: &Survey, wrenches: &Series<[f64; 6]>, air: &[usize]) -> Option<Self> {
        let pieces = pieces(&survey.blocks, air, PIECE_S);
        let blocks_need = if survey.per_block == 1 { FEWEST } else { 8 };
        let mut of_samples: [Vec<f64>; 6] = Default::default();
        let mut of_blocks: [Vec<f64>; 6] = Default::default();
        let (mut correlations, mut block_correlations) = (Vec::new(), Vec::new());
        for piece in pieces.iter().filter(|piece| piece.len() >= blocks_need) {
            let blocks = &survey.blocks[piece.clone()];
            let (Some(first), Some(last)) = (blocks.first(), blocks.last()) else { continue };
            let samples = &wrenches.values[first.samples.start..last.samples.end];
            for axis in 0..6 {
                let (variance, correlation) = about_line(samples.iter().map(|wrench| wrench[axis]));
                of_samples[axis].push(variance);
                let (block_variance, block_correlation) = about_line(blocks.iter().map(|b| b.wrench[axis]));
                of_blocks[axis].push(block_variance);
                if axis < 3 && variance > 0.0 {
                    correlations.push(correlation);
                    block_correlations.push(block_correlation);
                }
            }
        }
        if of_samples[0].is_empty() {
            return None;
        }
        let sd = |mut variances: Vec<f64>| median(&mut variances).max(0.0).sqrt();
        let correlation = median(&mut correlations);
        let block_correlation = median(&mut block_correlations).clamp(0.0, 0.95);
        let rate_hz = 1.0 / survey.interval_s.max(f64::MIN_POSITIVE);
        Some(Self {
            sd: of_samples.map(sd),
            block_sd: of_blocks.map(sd),
            inflation: (1.0 + block_correlation) / (1.0 - block_correlation),
            corner_hz: (correlation > CORRELATED && correlation < 1.0)
                .then(|| -correlation.ln() * rate_hz / std::f64::consts::TAU),
        })
    }

    /// The noise of the force along any direction.
    pub(crate) fn of_force(&self, interval_s: f64) -> ForceNoise {
        ForceNoise { sd_n: self.force_n(), interval_s, corner_hz: self.corner_hz }
    }

    /// Size of the noise of one sample of the force: the root mean square of its axes, in N.
    #[must_use]
    pub fn force_n(&self) -> f64 {
        (self.sd[..3].iter().map(|sd| sd * sd).sum::<f64>() / 3.0).sqrt()
    }
}

/// Runs of neighbouring blocks, at most `longest_s` long.
pub(super) fn pieces(blocks: &[Block], chosen: &[usize], longest_s: f64) -> Vec<Range<usize>> {
    let mut found: Vec<Range<usize>> = Vec::new();
    for &k in chosen {
        match found.last_mut() {
            Some(last) if last.end == k && blocks[k].t_s - blocks[last.start].t_s <= longest_s => {
                last.end = k + 1
            }
            _ => found.push(k..k + 1),
        }
    }
    found
}

/// Variance about a straight line, and the correlation of neighbours, both without bias where neighbours are independent.
fn about_line(values: impl ExactSizeIterator<Item = f64> + Clone) -> (f64, f64) {
    let n = values.len() as f64;
    let mean = values.clone().sum::<f64>() / n;
    let middle = (n - 1.0) / 2.0;
    let (mut xx, mut xy) = (0.0, 0.0);
    for (k, value) in values.clone().enumerate() {
        let x = k as f64 - middle;
        xx += x * x;
        xy += x * (value - mean);
    }
    let slope = if xx > 0.0 { xy / xx } else { 0.0 };
    let (mut square, mut product, mut before) = (0.0, 0.0, None);
    for (k, value) in values.enumerate() {
        let rest = value - mean - slope * (k as f64 - middle);
        square += rest * rest;
        product += before.map_or(0.0, |before: f64| before * rest);
        before = Some(rest);
    }
    let correlation = if square > 0.0 { product / square + 2.0 / n } else { 0.0 };
    (square / (n - 2.0).max(1.0), correlation)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_variance_about_a_line_ignores_the_line() {
        let alternating = (0..200).map(|k| 3.0 + 0.7 * f64::from(k) + if k % 2 == 0 { 0.1 } else { -0.1 });
        let (variance, correlation) = about_line(alternating.collect::<Vec<_>>().into_iter());
        assert!((variance - 0.01).abs() < 2e-4, "{variance}");
        assert!((correlation + 1.0).abs() < 0.03);
    }
}
