//! The gap column by column, and along each condition: where it shrinks, and where it is left.

use std::collections::BTreeMap;

use soilctl_effects::{Channel, Covariate};

use crate::data::Data;
use crate::generic::{Condition, conditions};

/// Parts into which the strokes are divided along a condition that has many values: of 48 strokes each has 16.
const PARTS: f64 = 3.0;

/// The gap of one column on batches that took no part in the fit, over all strokes or those of a range of a condition.
#[derive(Debug, Clone, PartialEq)]
pub struct Part {
    /// Column of the stroke table or of the traces; `force_n` is compared as its logarithm.
    pub channel: &'static str,
    /// Condition; `None` for all strokes.
    pub covariate: Option<Covariate>,
    /// Least and largest value of the condition, in its unit.
    pub range: Option<[f64; 2]>,
    /// Readings.
    pub readings: usize,
    /// Root mean square of measured minus predicted without effects, over the standard deviation that the prediction with
    /// effects has. Its square is chi-square a reading, on the same scale before and after.
    pub before: f64,
    /// The same with effects; about 1 where nothing is left.
    pub after: f64,
    /// Gain in log predictive density, the sum over readings, each with the standard deviation of its own prediction.
    pub delta_elpd: f64,
    /// Its standard error, over readings.
    pub delta_elpd_se: f64,
}

/// How far a reading is from a prediction that has not seen its batch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Miss {
    pub(crate) residual: f64,
    pub(crate) sd: f64,
}

impl Miss {
    /// Contribution to chi-square.
    pub(crate) fn squared(&self) -> f64 {
        (self.residual / self.sd).powi(2)
    }

    /// Up to what all densities share.
    fn log_density(&self) -> f64 {
        -0.5 * self.squared() - self.sd.ln()
    }
}

/// Misses by stroke; those of the forces are under `None`.
pub(crate) type Misses = BTreeMap<Option<Channel>, Vec<Option<Miss>>>;

/// All parts: forces first, then columns; each over all strokes first, then along the conditions.
pub(crate) fn parts(data: &Data, before: &Misses, after: &Misses) -> Vec<Part> {
    let conditions: Vec<(Condition, Vec<usize>)> = conditions(data)
        .into_iter()
        .map(|of| {
            let group = groups(&of);
            (of, group)
        })
        .collect();
    let mut out = Vec::new();
    for (channel, found) in before {
        // What no effect changes is as far off as it was.
        let name = channel.map_or("force_n", Channel::column);
        let pairs: Vec<(usize, Miss, Miss)> = found
            .iter()
            .zip(after.get(channel).unwrap_or(found))
            .enumerate()
            .filter_map(|(stroke, (a, b))| Some((stroke, (*a)?, (*b)?)))
            .collect();
        out.extend(part(name, None, None, pairs.iter()));
        for (condition, group) in &conditions {
            let last = group.iter().copied().max().unwrap_or(0);
            for k in 0..=last {
                let inside = || pairs.iter().filter(|(stroke, ..)| group[*stroke] == k);
                let of = || inside().map(|(stroke, ..)| condition.values[*stroke]);
                let range = [of().fold(f64::INFINITY, f64::min), of().fold(f64::NEG_INFINITY, f64::max)];
                out.extend(part(name, Some(condition.covariate), Some(range), inside()));
            }
        }
    }
    out
}

/// Group of each stroke along a condition: its levels, or parts with equally many strokes.
fn groups(condition: &Condition) -> Vec<usize> {
    if let Some(levels) = &condition.levels {
        return levels.clone();
    }
    let mut sorted = condition.values.clone();
    sorted.sort_by(f64::total_cmp);
    let n = sorted.len() as f64;
    condition
        .values
        .iter()
        .map(|value| {
            let below = sorted.partition_point(|other| other < value) as f64;
            (PARTS * below / n) as usize
        })
        .collect()
}

fn part<'a>(
    channel: &'static str,
    covariate: Option<Covariate>,
    range: Option<[f64; 2]>,
    pairs: impl Iterator<Item = &'a (usize, Miss, Miss)>,
) -> Option<Part> {
    let (mut before, mut after, mut gains) = (0.0, 0.0, Vec::new());
    for (_, a, b) in pairs {
        before += (a.residual / b.sd).powi(2);
        after += b.squared();
        gains.push(b.log_density() - a.log_density());
    }
    if gains.is_empty() {
        return None;
    }
    let count = gains.len() as f64;
    let (delta_elpd, delta_elpd_se) = sum_and_error(&gains);
    Some(Part {
        channel,
        covariate,
        range,
        readings: gains.len(),
        before: (before / count).sqrt(),
        after: (after / count).sqrt(),
        delta_elpd,
        delta_elpd_se,
    })
}

/// Sum of independent gains, and its standard error from how they scatter.
pub(crate) fn sum_and_error(gains: &[f64]) -> (f64, f64) {
    let (count, sum) = (gains.len() as f64, gains.iter().sum::<f64>());
    let variance = gains.iter().map(|g| (g - sum / count).powi(2)).sum::<f64>() / (count - 1.0).max(1.0);
    (sum, (count * variance).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strokes_along_a_condition_are_divided_evenly() {
        let values: Vec<f64> = (0..30).map(f64::from).collect();
        let found = groups(&Condition { covariate: Covariate::Time, values, levels: None });
        for k in 0..3 {
            assert_eq!(found.iter().filter(|g| **g == k).count(), 10);
        }
        assert!(found.is_sorted());
    }

    /// A bias of three standard deviations that an effect removes: 3 before on the scale of after, and the gain in ln density is 4.5 a reading.
    #[test]
    fn a_bias_that_goes_is_counted_in_standard_deviations() {
        let (before, after) = (Miss { residual: 0.3, sd: 0.1 }, Miss { residual: 0.0, sd: 0.1 });
        let pairs: Vec<(usize, Miss, Miss)> = (0..8).map(|i| (i, before, after)).collect();
        let found = part("force_n", None, None, pairs.iter());
        let close = |a: f64, b: f64| (a - b).abs() < 1e-12;
        assert!(found.is_some_and(|p| close(p.before, 3.0)
            && close(p.after, 0.0)
            && close(p.delta_elpd, 36.0)
            && close(p.delta_elpd_se, 0.0)
            && p.readings == 8));
        assert_eq!(part("force_n", None, None, std::iter::empty()), None);
    }
}
