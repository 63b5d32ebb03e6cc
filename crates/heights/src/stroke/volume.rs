//! Heap and furrow.

use std::collections::VecDeque;

use soilctl_stats::sd_of_median_abs;

use super::Plate;
use crate::change::{Change, smoothed};

/// Cells around what stands out that are counted with it at least: its tails are in noise, which sums to nothing.
const MARGIN: usize = 2;
/// Most rings of cells that are added for tails.
const MOST_RINGS: usize = 60;
/// Standard deviations of its mean by which a ring stands out.
const TAIL: f64 = 2.0;
/// Fewest cells of a change elsewhere that is told.
const FEWEST: usize = 9;
/// How near to the plate or to the furrow a change is the stroke's, in cells.
const NEAR: f64 = 3.0;

/// A volume of soil that rose or sank.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Volume {
    /// The volume in m3.
    pub m3: f64,
    /// Its standard deviation in m3.
    pub sd_m3: f64,
    /// The largest change of height of a cell, in m.
    pub most_m: f64,
    /// Cells.
    pub cells: usize,
    /// Whether it reaches the edge of the map, so that there may be more.
    pub off_map: bool,
    /// Cells beside it that were not seen.
    pub hidden: usize,
    /// Where its cells are: least and greatest distance (m) ahead of the plate's face, and to the left of its middle.
    pub extent_m: [[f64; 2]; 2],
}

/// Heap, furrow, and what changed elsewhere.
pub(super) fn volumes(change: &Change, plate: &Plate, deviations: f64) -> [Volume; 3] {
    let grid = &change.grid;
    let smooth = smoothed(grid, &change.by_m);
    let calm = smooth.iter().zip(&change.changed).filter_map(|(by, changed)| by.filter(|_| !changed));
    let least = (deviations * sd_of_median_abs(calm)).max(change.noise_m / 3.0);
    let sign: Vec<i8> = smooth
        .iter()
        .map(|by| match by {
            Some(by) if *by > least => 1,
            Some(by) if *by < -least => -1,
            _ => 0,
        })
        .collect();
    let parts = Parts::of(change, &sign);
    let near_plate: Vec<bool> = (0..grid.cells())
        .map(|cell| {
            let [ahead, left] = plate.seen_from(grid.place(cell));
            let near = (NEAR * grid.cell_m()).max(0.25 * plate.width_m);
            ahead.abs() <= near && left.abs() <= 0.5 * plate.width_m + near
        })
        .collect();
    let mut ours = parts.that_touch(&near_plate);
    // Ridges beside the furrow may lie apart from the heap.
    let mut beside: Vec<bool> =
        parts.of.iter().map(|part| part.is_some_and(|part| ours[part] && parts.sign[part] < 0)).collect();
    for _ in 0..MARGIN {
        beside = grow(change, &beside);
    }
    for (part, touches) in parts.that_touch(&beside).into_iter().enumerate() {
        ours[part] = ours[part] || touches;
    }
    let belongs = |wanted: i8| -> Vec<bool> {
        let is = |part: &Option<usize>| part.is_some_and(|part| ours[part] && parts.sign[part] == wanted);
        let mut cells: Vec<bool> = parts.of.iter().map(is).collect();
        for _ in 0..MARGIN {
            cells = grow(change, &cells);
        }
        cells
    };
    let (up, down) = (belongs(1), belongs(-1));
    let (up, down) = (with_tails(change, &up, &down, 1.0), with_tails(change, &down, &up, -1.0));
    // Between both, a cell is of the one that its change says.
    let share = |cell: usize, of: &[bool], other: &[bool], sign: f64| {
        of[cell] && (!other[cell] || change.by_m[cell].is_some_and(|by| sign * by > 0.0))
    };
    let sum = |of: &[bool], other: &[bool], sign: f64| {
        let cells: Vec<usize> = (0..grid.cells()).filter(|&cell| share(cell, of, other, sign)).collect();
        volume(change, plate, &cells, sign)
    };
    let elsewhere = parts
        .size
        .iter()
        .zip(&ours)
        .filter(|(size, ours)| !**ours && **size >= FEWEST)
        .map(|(size, _)| size)
        .sum();
    [sum(&up, &down, 1.0), sum(&down, &up, -1.0), Volume { cells: elsewhere, ..Volume::default() }]
}

fn volume(change: &Change, plate: &Plate, cells: &[usize], sign: f64) -> Volume {
    let (grid, area) = (&change.grid, change.grid.area_m2());
    let mut extent_m = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    let (mut volume, mut beside) = (Volume::default(), vec![false; grid.cells()]);
    for &cell in cells {
        volume.off_map |= grid.is_edge(cell);
        let at = plate.seen_from(grid.place(cell));
        for (extent, x) in extent_m.iter_mut().zip(at) {
            *extent = [extent[0].min(x), extent[1].max(x)];
        }
        match change.by_m[cell] {
            Some(by) => {
                volume.m3 += sign * by * area;
                volume.most_m = volume.most_m.max(sign * by);
                volume.cells += 1;
            }
            None => beside[cell] = true,
        }
    }
    if !cells.is_empty() {
        volume.extent_m = extent_m;
    }
    volume.hidden = beside.iter().filter(|hidden| **hidden).count();
    let count = volume.cells as f64;
    let noise = change.noise_m * (count * change.clumping).sqrt();
    volume.sd_m3 = area * libm::hypot(noise, count * change.shift.up_sd_m);
    volume
}

/// Adds rings of cells around `of` as long as the mean over a whole ring stands out, where its cells do not one by one; those of `other` are not
/// asked.
fn with_tails(change: &Change, of: &[bool], other: &[bool], sign: f64) -> Vec<bool> {
    let mut of = of.to_vec();
    for _ in 0..MOST_RINGS {
        let larger = grow(change, &of);
        let (mut sum, mut count) = (0.0, 0.0);
        for cell in 0..of.len() {
            if larger[cell] && !of[cell] && !other[cell] {
                let by = change.by_m[cell];
                sum += sign * by.unwrap_or(0.0);
                count += f64::from(u8::from(by.is_some()));
            }
        }
        let level = change.shift.up_sd_m * count;
        if sum <= TAIL * libm::hypot(change.noise_m * (count * change.clumping).sqrt(), level) {
            break;
        }
        of = larger;
    }
    of
}

fn grow(change: &Change, cells: &[bool]) -> Vec<bool> {
    (0..cells.len()).map(|cell| cells[cell] || change.grid.around(cell).any(|other| cells[other])).collect()
}

/// Cells of one sign that touch each other.
struct Parts {
    /// The part of each cell.
    of: Vec<Option<usize>>,
    sign: Vec<i8>,
    size: Vec<usize>,
}

impl Parts {
    fn of(change: &Change, sign: &[i8]) -> Self {
        let mut parts = Self { of: vec![None; sign.len()], sign: Vec::new(), size: Vec::new() };
        for start in 0..sign.len() {
            if sign[start] == 0 || parts.of[start].is_some() {
                continue;
            }
            let part = parts.sign.len();
            parts.sign.push(sign[start]);
            parts.of[start] = Some(part);
            let (mut open, mut size) = (VecDeque::from([start]), 0);
            while let Some(cell) = open.pop_front() {
                size += 1;
                for other in change.grid.around(cell) {
                    if sign[other] == sign[start] && parts.of[other].is_none() {
                        parts.of[other] = Some(part);
                        open.push_back(other);
                    }
                }
            }
            parts.size.push(size);
        }
        parts
    }

    fn that_touch(&self, cells: &[bool]) -> Vec<bool> {
        let mut touch = vec![false; self.sign.len()];
        for (part, here) in self.of.iter().zip(cells) {
            if let Some(part) = part.filter(|_| *here) {
                touch[part] = true;
            }
        }
        touch
    }
}
