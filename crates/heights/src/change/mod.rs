//! What changed between two maps: their difference where the ground is one, and how much of it is noise.

mod align;
mod noise;

use crate::error::within;
use crate::map::length;
use crate::{Grid, HeightMap, HeightsError, Plate};

pub(crate) use noise::smoothed;

/// Fewest cells seen in both maps, and of unchanged ground.
const FEWEST_CELLS: usize = 100;
/// Part of the seen ground that must be away from the plate's path for this alone to align the maps: less of it determines no plane.
const ASIDE: f64 = 0.3;
/// Noise is not taken to be less than this, in m: no scanner of ground is finer.
const LEAST_NOISE_M: f64 = 1e-6;
/// Rounds of telling unchanged ground and aligning the maps by it.
const ROUNDS: usize = 7;
/// Part of a cell below which a sideways shift is not worth an interpolation.
const LEAST_SHIFT: f64 = 0.1;
/// Standard deviations that a sideways shift must be from nothing.
const CERTAIN: f64 = 4.0;

/// How the second map was moved to lie on unchanged ground of the first.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Shift {
    /// Sideways, in m along x and y.
    pub sideways_m: [f64; 2],
    /// Upwards at the plate, in m, and its standard deviation.
    pub up_m: f64,
    /// Standard deviation of `up_m`.
    pub up_sd_m: f64,
    /// Slopes of what was taken away, along x and y.
    pub tilt: [f64; 2],
}

/// The difference of two maps: after minus before, once they lie on each other.
#[derive(Debug, Clone)]
pub struct Change {
    /// Its cells.
    pub grid: Grid,
    /// Change of height (m) of each cell seen in both maps.
    pub by_m: Vec<Option<f64>>,
    /// Cells that changed by more than noise, and those near them.
    pub changed: Vec<bool>,
    /// Standard deviation (m) of the change of a cell where nothing happened.
    pub noise_m: f64,
    /// How many times the variance of a sum over many cells is that of as many independent ones.
    pub clumping: f64,
    /// How the second map was moved.
    pub shift: Shift,
    /// Cells of unchanged ground.
    pub unchanged: usize,
    /// Side (m) of the larger cells of both maps: what is finer was not seen.
    pub finest_m: f64,
    /// What is odd, in sentences.
    pub notes: Vec<String>,
}

/// The change from `before` to `after`, aligned by ground that did not change: away from the plate's path, and nowhere that the difference stands
/// out by `deviations` (1 to 10) of its standard deviations. `height_sd_m` is that of a height in either map if it is known (m); noise is
/// taken to be no less.
///
/// # Errors
/// [`HeightsError::NoOverlap`], [`HeightsError::PlateOutside`], [`HeightsError::OutOfRange`].
pub fn change(
    before: &HeightMap,
    after: &HeightMap,
    plate: &Plate,
    deviations: f64,
    height_sd_m: Option<f64>,
) -> Result<Change, HeightsError> {
    within("deviations", deviations, "", [1.0, 10.0], "from 1 to 10")?;
    let grid = *before.grid();
    let mut change = Change {
        by_m: Vec::new(),
        changed: vec![false; grid.cells()],
        noise_m: 0.0,
        clumping: 1.0,
        shift: Shift::default(),
        unchanged: 0,
        finest_m: grid.cell_m().max(after.grid().cell_m()),
        notes: Vec::new(),
        grid,
    };
    let path: Vec<bool> = (0..grid.cells()).map(|cell| plate.path(grid.place(cell))).collect();
    let slopes = align::slopes(before);
    let mut raw = difference(before, after, [0.0; 2]);
    check(before, after, plate, &raw)?;
    let aside = raw.iter().zip(&path).filter(|(by, path)| by.is_some() && !**path).count();
    let off_path = aside as f64 >= ASIDE * raw.iter().flatten().count() as f64 && aside >= FEWEST_CELLS;
    for round in 0..ROUNDS {
        let calm = |cell: usize, changed: &[bool]| {
            !(changed.get(cell) == Some(&true) || off_path && path.get(cell) == Some(&true))
        };
        let still: Vec<usize> =
            (0..grid.cells()).filter(|cell| raw[*cell].is_some() && calm(*cell, &change.changed)).collect();
        if still.len() < FEWEST_CELLS {
            break;
        }
        let fit = align::fit(&grid, &raw, &still, plate.at_m);
        // A heap looks like slopes that were moved, so it is away from the path that a shift shows; the first round does not know yet what changed
        // there, and the last one only reads.
        let aside: Vec<usize> = still.iter().copied().filter(|cell| !path[*cell]).collect();
        let step = align::sideways(&grid, &raw, &slopes, &aside, plate.at_m)
            .filter(|step| step.is_certain(CERTAIN, LEAST_SHIFT * grid.cell_m()));
        if let Some(step) = step.filter(|_| round > 0 && round + 1 < ROUNDS) {
            for (shift, by) in change.shift.sideways_m.iter_mut().zip(step.by_m) {
                *shift += by;
            }
            raw = difference(before, after, change.shift.sideways_m);
            continue;
        }
        change.by_m =
            raw.iter().enumerate().map(|(cell, by)| by.map(|by| by - fit.at(grid.place(cell)))).collect();
        let values: Vec<f64> = still.iter().filter_map(|cell| change.by_m[*cell]).collect();
        let found = noise::noise_m(&values);
        let known = height_sd_m.map_or(0.0, |sd| std::f64::consts::SQRT_2 * sd);
        change.noise_m = found.max(known).max(LEAST_NOISE_M);
        change.unchanged = still.len();
        change.clumping = noise::clumping(&grid, &change.by_m, &still, change.noise_m);
        change.shift = Shift {
            up_m: fit.up_m,
            up_sd_m: fit.up_per_noise * change.noise_m * change.clumping.sqrt(),
            tilt: fit.tilt,
            ..change.shift
        };
        change.changed = noise::stands_out(&grid, &change.by_m, &still, deviations);
    }
    if change.by_m.is_empty() || change.unchanged < FEWEST_CELLS {
        return Err(HeightsError::NoOverlap { cells: raw.iter().flatten().count() });
    }
    if after.grid().cell_m() > 1.5 * grid.cell_m() {
        change.notes.push(
            "the cells of the second map are larger than those of the first, and limit what is seen"
                .to_owned(),
        );
    }
    notes(&mut change, off_path, height_sd_m);
    Ok(change)
}

/// After minus before, where both were seen.
fn difference(before: &HeightMap, after: &HeightMap, sideways_m: [f64; 2]) -> Vec<Option<f64>> {
    let grid = before.grid();
    let at = |cell: usize| {
        let place = grid.place(cell);
        after.height_m([0, 1].map(|axis| place[axis] + sideways_m[axis]))
    };
    before.heights_m().iter().enumerate().map(|(cell, height)| Some(at(cell)? - (*height)?)).collect()
}

fn check(
    before: &HeightMap,
    after: &HeightMap,
    plate: &Plate,
    raw: &[Option<f64>],
) -> Result<(), HeightsError> {
    let cells = raw.iter().flatten().count();
    if cells < FEWEST_CELLS {
        return Err(HeightsError::NoOverlap { cells });
    }
    let [a, b] = [before.grid().extent_m(), after.grid().extent_m()];
    let both = [0, 1].map(|axis| [a[axis][0].max(b[axis][0]), a[axis][1].min(b[axis][1])]);
    let inside = both.iter().zip(plate.at_m).all(|([low, high], x)| (*low..=*high).contains(&x));
    if inside {
        return Ok(());
    }
    let [x_range_m, y_range_m] = both;
    Err(HeightsError::PlateOutside { x_m: plate.at_m[0], y_m: plate.at_m[1], x_range_m, y_range_m })
}

fn notes(change: &mut Change, off_path: bool, height_sd_m: Option<f64>) {
    if change.noise_m <= LEAST_NOISE_M {
        change.notes.push(
            "unchanged ground is the same in both maps to the micrometre, so nothing tells how exact heights are; give their standard deviation"
                .to_owned(),
        );
    }
    if !off_path {
        change.notes.push(
            "little of the ground that was seen is away from the plate's path, so the maps are aligned by ground on it too, where it does not stand out; scan more to the sides"
                .to_owned(),
        );
    }
    if let Some(sd) = height_sd_m
        && change.noise_m > 1.5 * std::f64::consts::SQRT_2 * sd
    {
        change.notes.push(format!(
            "unchanged ground differs by {:.2} mm between the maps, more than heights of a standard deviation of {:.2} mm should; the larger is taken",
            1e3 * change.noise_m,
            1e3 * sd
        ));
    }
    let sideways = length(change.shift.sideways_m);
    if sideways > 3.0 * change.grid.cell_m() {
        change.notes.push(format!(
            "the second map was {:.1} mm beside the first, more than a few cells; check that both are in one frame",
            1e3 * sideways
        ));
    }
}
