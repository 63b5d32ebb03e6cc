//! How much two maps differ where nothing happened, and what stands out of it.

use soilctl_stats::{median, sd_of_median_abs};

use crate::Grid;

/// Sides of the blocks of cells by which it shows how noise clumps.
const BLOCKS: [usize; 3] = [2, 4, 8];
/// Fewest blocks that tell.
const FEWEST_BLOCKS: usize = 12;
/// Cells around a change that are taken for changed: their tails are in noise.
const MARGIN: usize = 2;

/// Robust standard deviation of values about their median. Heights in whole steps may leave a median deviation of nothing; then the mean square
/// counts.
pub(super) fn noise_m(values: &[f64]) -> f64 {
    let middle = median(&mut values.to_vec());
    let robust = sd_of_median_abs(values.iter().map(|value| value - middle));
    if robust > 0.0 {
        return robust;
    }
    (values.iter().map(|value| (value - middle).powi(2)).sum::<f64>() / values.len().max(1) as f64).sqrt()
}

/// Variance of sums over blocks of cells of unchanged ground over that of as many independent cells; at least 1.
pub(super) fn clumping(grid: &Grid, by_m: &[Option<f64>], still: &[usize], noise_m: f64) -> f64 {
    let mut is_still = vec![false; grid.cells()];
    for cell in still {
        is_still[*cell] = true;
    }
    let [columns, rows] = grid.size();
    let of = |side: usize| {
        let mut means = Vec::new();
        for j in (0..rows.saturating_sub(side - 1)).step_by(side) {
            for i in (0..columns.saturating_sub(side - 1)).step_by(side) {
                let cells = (j..j + side).flat_map(|b| (i..i + side).map(move |a| b * columns + a));
                let values: Option<Vec<f64>> =
                    cells.map(|cell| by_m[cell].filter(|_| is_still[cell])).collect();
                means.extend(values.map(|values| values.iter().sum::<f64>() / values.len() as f64));
            }
        }
        let blocks = means.len();
        (blocks >= FEWEST_BLOCKS).then(|| (self::noise_m(&means) * side as f64 / noise_m).powi(2))
    };
    BLOCKS.into_iter().filter_map(of).fold(1.0, f64::max)
}

/// Means over a cell and those around it, where most of them were seen.
pub(crate) fn smoothed(grid: &Grid, by_m: &[Option<f64>]) -> Vec<Option<f64>> {
    let mean = |cell: usize| {
        by_m[cell]?;
        let (mut sum, mut count, mut all) = (0.0, 0.0, 0.0);
        for other in grid.around(cell).chain([cell]) {
            all += 1.0;
            if let Some(by) = by_m[other] {
                sum += by;
                count += 1.0;
            }
        }
        (2.0 * count > all).then(|| sum / count)
    };
    (0..by_m.len()).map(mean).collect()
}

/// Cells whose smoothed change is beyond `deviations` of what it is on unchanged ground, and those near them.
pub(super) fn stands_out(grid: &Grid, by_m: &[Option<f64>], still: &[usize], deviations: f64) -> Vec<bool> {
    let smooth = smoothed(grid, by_m);
    let calm: Vec<f64> = still.iter().filter_map(|cell| smooth[*cell]).collect();
    let most = deviations * noise_m(&calm);
    let mut changed: Vec<bool> = smooth.iter().map(|by| by.is_some_and(|by| by.abs() > most)).collect();
    for _ in 0..MARGIN {
        changed = (0..changed.len())
            .map(|cell| changed[cell] || grid.around(cell).any(|other| changed[other]))
            .collect();
    }
    changed
}
