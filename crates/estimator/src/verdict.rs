use crate::estimate::is_consistent;
use crate::{EstimatorError, Setup};

/// Most measurements for which conflicts are searched one by one and pair by pair.
const MAX_SEARCHED: usize = 48;

/// What breaks the consistency of a set of measurements.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Conflict {
    /// Measurements (indices) without which all the others agree.
    pub culprits: Vec<usize>,
    /// Pairs of measurements (indices) that no soil explains together.
    pub pairs: Vec<(usize, usize)>,
    /// Measurements (indices) that no soil explains even alone.
    pub alone: Vec<usize>,
    /// True if there were too many measurements to search for culprits and pairs.
    pub not_searched: bool,
}

/// Finds what breaks the consistency of measurements that no soil explains together.
///
/// # Errors
/// As [`crate::estimate`].
pub fn conflict(setup: &Setup<'_>) -> Result<Conflict, EstimatorError> {
    setup.check()?;
    let n = setup.observations.len();
    let mut conflict = Conflict::default();
    if n > MAX_SEARCHED {
        conflict.not_searched = true;
        return Ok(conflict);
    }
    let agree = |keep: &dyn Fn(usize) -> bool| {
        let chosen = (0..n).filter(|&i| keep(i)).map(|i| setup.observations[i].clone()).collect();
        is_consistent(&setup.with_observations(chosen))
    };
    for i in 0..n {
        if !agree(&|k| k == i)? {
            conflict.alone.push(i);
        }
        if n > 1 && agree(&|k| k != i)? {
            conflict.culprits.push(i);
        }
    }
    for i in 0..n {
        for j in i + 1..n {
            let known = conflict.alone.contains(&i) || conflict.alone.contains(&j);
            if !known && !agree(&|k| k == i || k == j)? {
                conflict.pairs.push((i, j));
            }
        }
    }
    Ok(conflict)
}

/// Factor by which all force intervals must grow (or, below 1, may shrink) until the measurements only just
/// agree, to 1 %. `None` if ten times the uncertainty is not enough.
///
/// # Errors
/// As [`crate::estimate`].
pub fn agreement_factor(setup: &Setup<'_>) -> Result<Option<f64>, EstimatorError> {
    setup.check()?;
    let agree = |factor: f64| {
        is_consistent(&setup.with_observations(
            setup.observations.iter().map(|observation| observation.scaled(factor)).collect(),
        ))
    };
    // Bisection in the logarithm.
    let (mut low, mut high) = (0.02_f64, 10.0_f64);
    if !agree(high)? {
        return Ok(None);
    }
    if agree(low)? {
        return Ok(Some(low));
    }
    while high / low > 1.01 {
        let middle = (low * high).sqrt();
        if agree(middle)? { high = middle } else { low = middle }
    }
    Ok(Some(high))
}
