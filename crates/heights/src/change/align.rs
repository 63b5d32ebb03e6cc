//! The second map against the first on unchanged ground: a plane between them, and a shift sideways where slopes show it.

use soilctl_stats::{Solved, huber};

use crate::map::length;
use crate::{Grid, HeightMap};

/// More cells than these make a plane hardly more certain, beside how noise clumps.
const MOST_ROWS: usize = 8_000;
/// Fewest cells with slopes that tell a shift.
const FEWEST_SLOPES: usize = 200;

/// What lies between the maps.
pub(super) struct Fit {
    origin: [f64; 2],
    /// At the plate.
    pub(super) up_m: f64,
    pub(super) tilt: [f64; 2],
    /// Standard deviation of `up_m` over that of a cell.
    pub(super) up_per_noise: f64,
}

/// Where the second map must be read, against where it was.
#[derive(Clone, Copy)]
pub(super) struct Sideways {
    pub(super) by_m: [f64; 2],
    sd_m: [f64; 2],
}

impl Sideways {
    /// Whether it is this many standard deviations from nothing, and worth it.
    pub(super) fn is_certain(&self, deviations: f64, least_m: f64) -> bool {
        let certain = self.by_m.iter().zip(self.sd_m).any(|(by, sd)| by.abs() > deviations * sd);
        certain && length(self.by_m) > least_m
    }
}

impl Fit {
    /// The plane at a place.
    pub(super) fn at(&self, place: [f64; 2]) -> f64 {
        self.up_m + (0..2).map(|axis| self.tilt[axis] * (place[axis] - self.origin[axis])).sum::<f64>()
    }
}

/// Slopes along x and y of each cell whose four neighbours were seen.
pub(super) fn slopes(map: &HeightMap) -> Vec<Option<[f64; 2]>> {
    let grid = map.grid();
    let [columns, rows] = grid.size();
    let heights = map.heights_m();
    let steps = |cell: usize| {
        let (i, j) = (cell % columns, cell / columns);
        if i == 0 || j == 0 || i + 1 == columns || j + 1 == rows {
            return None;
        }
        let half = |a: usize, b: usize| Some(0.5 * (heights[a]? - heights[b]?));
        let (along, across) = (half(cell + 1, cell - 1)?, half(cell + columns, cell - columns)?);
        let step = |other: usize| {
            let (a, b) = (grid.place(cell), grid.place(other));
            [b[0] - a[0], b[1] - a[1]]
        };
        let ([a, b], [c, d]) = (step(cell + 1), step(cell + columns));
        let determinant = a * d - b * c;
        Some([(along * d - across * b) / determinant, (across * a - along * c) / determinant])
    };
    (0..heights.len()).map(steps).collect()
}

/// Places of cells from the origin, over a length of the size of the map, which keeps the normal equations in order; and that length.
fn rows<'a>(
    grid: &'a Grid,
    cells: &'a [usize],
    origin: [f64; 2],
) -> (impl Iterator<Item = (usize, [f64; 2])> + 'a, f64) {
    let every = cells.len().div_ceil(MOST_ROWS).max(1);
    let scale = (grid.cells() as f64).sqrt() * grid.cell_m();
    let rows = cells.iter().step_by(every).map(move |&cell| {
        let place = grid.place(cell);
        (cell, [0, 1].map(|axis| (place[axis] - origin[axis]) / scale))
    });
    (rows, scale)
}

/// The plane between the maps on unchanged cells, robustly.
pub(super) fn fit(grid: &Grid, by_m: &[Option<f64>], still: &[usize], origin: [f64; 2]) -> Fit {
    let (rows, scale) = rows(grid, still, origin);
    let rows: Vec<([f64; 3], f64)> =
        rows.filter_map(|(cell, [x, y])| Some(([1.0, x, y], by_m[cell]?))).collect();
    let solved = huber(&rows).map_or(Solved { x: [0.0; 3], inverse: [[0.0; 3]; 3] }, |(solved, _)| solved);
    let [up_m, a, b] = solved.x;
    Fit { origin, up_m, tilt: [a / scale, b / scale], up_per_noise: solved.inverse[0][0].sqrt() }
}

/// The shift sideways by slopes of the ground: reading the second map at a shift `u` changes it by slope times `u`, so the difference is a plane
/// minus slope times the missing shift (Lucas and Kanade 1981). `None` where too few slopes are known.
pub(super) fn sideways(
    grid: &Grid,
    by_m: &[Option<f64>],
    slopes: &[Option<[f64; 2]>],
    aside: &[usize],
    origin: [f64; 2],
) -> Option<Sideways> {
    let (rows, _) = rows(grid, aside, origin);
    let rows: Vec<([f64; 5], f64)> = rows
        .filter_map(|(cell, [x, y])| {
            let [p, q] = slopes[cell]?;
            Some(([1.0, x, y, -p, -q], by_m[cell]?))
        })
        .collect();
    if rows.len() < FEWEST_SLOPES {
        return None;
    }
    let (solved, sd) = huber(&rows)?;
    let [_, _, _, x, y] = solved.x;
    Some(Sideways { by_m: [x, y], sd_m: [3, 4].map(|i| sd * solved.inverse[i][i].sqrt()) })
}
