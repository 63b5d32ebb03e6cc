//! The change around the plate, in few enough cells to be looked at.

use soilctl_heights::{Change, Plate, Stroke};

use super::PictureAnswer;

/// Most cells along either side.
const MOST: usize = 70;
/// Widths of the plate that are shown at least around it.
const AROUND: f64 = 1.0;
/// Widths of the plate that are shown around heap and furrow.
const MARGIN: f64 = 0.2;

pub(super) fn picture(change: &Change, plate: &Plate, said: &Stroke) -> PictureAnswer {
    let grid = &change.grid;
    // What changed, and the plate with some ground around it.
    let around = AROUND * plate.width_m;
    let (mut low, mut high) = ([-around; 2], [around; 2]);
    for volume in [&said.heap, &said.furrow] {
        for (axis, extent) in volume.extent_m.iter().enumerate() {
            low[axis] = low[axis].min(extent[0] - MARGIN * plate.width_m);
            high[axis] = high[axis].max(extent[1] + MARGIN * plate.width_m);
        }
    }
    if let Ok(broke) = &said.broke {
        high[0] = high[0].max(1.3 * broke.distance_m);
    }
    let longest = (high[0] - low[0]).max(high[1] - low[1]);
    let cell_m = grid.cell_m().max(longest / MOST as f64);
    let count = |axis: usize| ((high[axis] - low[axis]) / cell_m).ceil() as usize;
    let (columns, rows) = (count(0), count(1));
    let mut sums = vec![(0.0, 0_u32); columns * rows];
    for (cell, by) in change.by_m.iter().enumerate() {
        let Some(by) = by else { continue };
        let at = plate.seen_from(grid.place(cell));
        let [i, j] = [0, 1].map(|axis| ((at[axis] - low[axis]) / cell_m).floor());
        if (0.0..columns as f64).contains(&i) && (0.0..rows as f64).contains(&j) {
            let (sum, number) = &mut sums[j as usize * columns + i as usize];
            *sum += by;
            *number += 1;
        }
    }
    // A turned grid leaves gaps between cells as fine as its own: there the nearest one is taken.
    let value = |place: usize| {
        let (sum, number) = sums.get(place).copied().unwrap_or_default();
        if number > 0 {
            return Some(sum / f64::from(number));
        }
        let at =
            [0, 1].map(|axis| low[axis] + ([place % columns, place / columns][axis] as f64 + 0.5) * cell_m);
        grid.cell_of(plate.place(at)).and_then(|cell| change.by_m.get(cell).copied().flatten())
    };
    PictureAnswer {
        cell_m,
        ahead_m: (0..columns).map(|i| low[0] + (i as f64 + 0.5) * cell_m).collect(),
        left_m: (0..rows).map(|j| low[1] + (j as f64 + 0.5) * cell_m).collect(),
        change_m: (0..rows).map(|j| (0..columns).map(|i| value(j * columns + i)).collect()).collect(),
    }
}
