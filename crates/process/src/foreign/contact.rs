//! Where the plate touches something: a sequential test of the force against its noise, joined with where the edge is.
//!
//! In free air the squared length of a block's force beside the tare, in units of its standard deviations, has a mean of 3. Page's
//! cumulative sum (Biometrika 41, 1954) of what it is above, less an allowance, alarms soon after contact and hardly ever
//! without; a second one, of what it is below, ends the contact. Nothing in it depends on a force in newtons, and a slow drift is
//! part of the tare.

use std::ops::Range;

use nalgebra::{Matrix3, Vector3};

use super::air::AirModel;
use super::survey::{Block, Survey};

/// Allowance of the sums: half the increase of the mean that shall be found.
const ALLOWANCE: f64 = 3.0;
/// The sums alarm here. The exponent t at which `exp(t (x - 6))` has the mean 1, for `x` of chi-square with three degrees of freedom, is
/// 0.4, so white noise of the size found alarms about once in `exp(0.4 h)` blocks, years.
const ALARM: f64 = 60.0;
/// A block in contact counts at most so much against the end of a contact, so that long contacts end as soon as short ones.
const MOST: f64 = 30.0;
/// Freedom of the squared length of a force.
const FREEDOM: f64 = 3.0;

/// A time in which the plate touched something, or was below the surface.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Touch {
    /// Blocks of it.
    pub(crate) blocks: Range<usize>,
    /// Those in which a force shows, first to last; `None` if none does.
    pub(crate) felt: Option<Range<usize>>,
}

/// Contacts in a survey, in order of time. The edge is in the soil where it is below `surface_z_m`.
pub(crate) fn touches(survey: &Survey, air: &AirModel, surface_z_m: f64) -> Vec<Touch> {
    let felt = felt(survey, air);
    let below =
        runs(survey.blocks.iter().map(|block| depth(block, surface_z_m).is_some_and(|depth| depth > 0.0)));
    let mut touches: Vec<Touch> = Vec::new();
    let mut all: Vec<(Range<usize>, bool)> = felt.into_iter().map(|run| (run, true)).collect();
    all.extend(below.into_iter().map(|run| (run, false)));
    all.sort_by_key(|(run, _)| (run.start, run.end));
    for (run, shows) in all {
        let felt = shows.then(|| run.clone());
        match touches.last_mut() {
            Some(last) if run.start <= last.blocks.end => {
                last.blocks.end = last.blocks.end.max(run.end);
                last.felt = match (last.felt.take(), felt) {
                    (Some(a), Some(b)) => Some(a.start.min(b.start)..a.end.max(b.end)),
                    (a, b) => a.or(b),
                };
            }
            _ => touches.push(Touch { blocks: run, felt }),
        }
    }
    touches
}

/// Depth of the edge below the surface in m; `None` where the posture is unknown.
pub(crate) fn depth(block: &Block, surface_z_m: f64) -> Option<f64> {
    block.posture.map(|sample| surface_z_m - sample.tip_m[2])
}

/// Runs of blocks in which a force shows that free air does not explain.
pub(crate) fn felt(survey: &Survey, air: &AirModel) -> Vec<Range<usize>> {
    let mut runs = Vec::new();
    let mut begin: Option<usize> = None;
    let (mut sum, mut since) = (0.0, 0);
    for (k, block) in survey.blocks.iter().enumerate() {
        let Some(square) = squared_length(block, air) else { continue };
        let (step, to) = match begin {
            None => (square - FREEDOM - ALLOWANCE, k),
            Some(_) => (FREEDOM + ALLOWANCE - square.min(MOST), k),
        };
        if sum <= 0.0 {
            (sum, since) = (0.0, to);
        }
        sum += step;
        if sum > ALARM {
            match begin.take() {
                None => begin = Some(since),
                Some(from) => runs.push(from..since.max(from + 1)),
            }
            sum = 0.0;
        }
    }
    if let Some(from) = begin {
        // Not yet known to be over.
        runs.push(from..if sum > 0.0 { since.max(from + 1) } else { survey.blocks.len() });
    }
    runs
}

/// Squared length of a block's force beside the tare, in units of its standard deviations; `None` where the direction of gravity is
/// not known.
fn squared_length(block: &Block, air: &AirModel) -> Option<f64> {
    let (rest, of_tare) = air.rest(block)?;
    let noise = Vector3::from(air.block_sd_n.map(|sd| (sd * sd).max(1e-18)));
    let spread = Matrix3::from_diagonal(&noise) + of_tare;
    let inverse = spread.cholesky()?;
    Some(rest.dot(&inverse.solve(&rest)).min(1e9))
}

/// Runs of what is true.
pub(crate) fn runs(flags: impl Iterator<Item = bool>) -> Vec<Range<usize>> {
    let mut runs: Vec<Range<usize>> = Vec::new();
    for (k, flag) in flags.enumerate() {
        match runs.last_mut() {
            Some(last) if flag && last.end == k => last.end = k + 1,
            _ if flag => runs.push(k..k + 1),
            _ => {}
        }
    }
    runs
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_are_found() {
        assert_eq!(runs([true, true, false, true].into_iter()), [0..2, 3..4]);
        assert!(runs([false].into_iter()).is_empty());
    }
}
