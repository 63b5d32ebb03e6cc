//! Cells that follow an inclined plate.

use super::super::MeshError;
use super::super::extract::Mesh;
use super::super::outline::{Line, LineUse, Outline, RegionOutline};
use super::super::vector::Point;
use super::cells::{Cells, check_ascending};

/// Which way columns go below the tip of a plate.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Below {
    /// Straight down.
    Vertical,
    /// On in the direction of the plate.
    Parallel,
}

/// A rectangle of soil with a straight plate that leads from its top into it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlateBlock<'a> {
    /// Where columns are at the top (m), ascending; the plate's top is at one of them, not the first or last.
    pub columns: &'a [f64],
    /// Where rows are (m), descending; the plate's tip is at one of them, not the first or last.
    pub rows: &'a [f64],
    /// Where the plate starts, x at the top (m).
    pub top: f64,
    /// Where the plate ends, x and y (m).
    pub tip: [f64; 2],
    /// How far to the left and to the right of the plate the columns are parallel to it (m, at the top), from 0 to the
    /// distance of the side, which is not included. From there on they turn towards the vertical side.
    pub parallel: [f64; 2],
    /// Which way the columns go below the tip.
    pub below: Below,
}

/// The mesh, with cells sheared so that the columns follow the plate.
///
/// The outline has the points upper left, lower left, lower right, upper right, the plate's top and its tip, and the
/// lines left side, base, right side, top from the right side to the plate, the plate down to its tip, and the
/// top from the plate to the left side: the same numbers as the embedded plate's problem has.
///
/// # Errors
///
/// [`MeshError::BadGrid`] for lists that are not in order, a plate that does not start at a column or end at a row,
/// a parallel part that is too wide, and cells that are turned over because the plate leads too near to a side;
/// [`MeshError::TooManyTriangles`] for more than four million triangles; and what [`Outline::check`] finds.
pub fn plate_block(block: &PlateBlock) -> Result<(Outline, Mesh), MeshError> {
    check_ascending("columns", block.columns, 1.0)?;
    check_ascending("rows", block.rows, -1.0)?;
    let (right, base) = (block.columns.len() - 1, block.rows.len() - 1);
    let column = inner(block.columns, block.top, "x of the plate's top")?;
    let row = inner(block.rows, block.tip[1], "y of the plate's tip")?;
    let shift = Shift::new(block)?;
    let cells = Cells::new(block.columns, block.rows, |x, y| [x + shift.at(x, y), y])?;
    let top = block.rows[0];
    let corners = [[0, 0], [0, base], [right, base], [right, 0]];
    let mut points: Vec<Point> = corners.map(|[i, j]| [block.columns[i], block.rows[j]]).to_vec();
    points.extend([[block.top, top], block.tip]);
    let lines = [(0, 1), (1, 2), (2, 3), (3, 4), (4, 5), (4, 0)].map(|(from, to)| Line { from, to }).to_vec();
    let uses = [(0, true), (1, true), (2, true), (3, true), (4, true), (4, false), (5, true)];
    let loops = vec![uses.map(|(line, forward)| LineUse { line, forward }).to_vec()];
    let outline = Outline { points, lines, regions: vec![RegionOutline { loops }] };
    let chains = vec![
        (0..=base).map(|j| cells.number(0, j)).collect(),
        (0..=right).map(|i| cells.number(i, base)).collect(),
        (0..=base).rev().map(|j| cells.number(right, j)).collect(),
        (column..=right).rev().map(|i| cells.number(i, 0)).collect(),
        (0..=row).map(|j| cells.number(column, j)).collect(),
        (0..=column).rev().map(|i| cells.number(i, 0)).collect(),
    ];
    let mesh = cells.mesh(&outline, chains)?;
    Ok((outline, mesh))
}

/// Index of a value in a list, which must be there and not at an end.
fn inner(list: &[f64], value: f64, what: &'static str) -> Result<usize, MeshError> {
    let index = list.iter().position(|&c| c == value).unwrap_or(0);
    if index == 0 || index + 1 == list.len() {
        let allowed = "one of the columns or rows, exactly, but not the first or last";
        return Err(MeshError::BadGrid { what, index, value, allowed });
    }
    Ok(index)
}

/// How far corners of cells are shifted to the right of where their column is at the top.
struct Shift {
    /// Where columns begin to be shifted, are shifted fully, are so no more, and are not shifted at all.
    zones: [f64; 4],
    top: f64,
    tip: Point,
    /// From the plate's top to its tip, along x.
    by: f64,
    below: Below,
}

impl Shift {
    fn new(block: &PlateBlock) -> Result<Self, MeshError> {
        let (left, right) = (block.columns[0], block.columns[block.columns.len() - 1]);
        for (index, side) in [left, right].into_iter().enumerate() {
            let value = block.parallel[index];
            if !(value >= 0.0 && value < (block.top - side).abs()) {
                let (what, allowed) =
                    ("width of the parallel part", "from 0 to less than the distance of the side");
                return Err(MeshError::BadGrid { what, index, value, allowed });
            }
        }
        let zones = [left, block.top - block.parallel[0], block.top + block.parallel[1], right];
        let by = block.tip[0] - block.top;
        Ok(Self { zones, top: block.rows[0], tip: block.tip, by, below: block.below })
    }

    fn at(&self, x: f64, y: f64) -> f64 {
        let [left, from, to, right] = self.zones;
        let part = ((x - left) / (from - left)).min((right - x) / (right - to)).min(1.0);
        let depth = (self.top - y) / (self.top - self.tip[1]);
        let depth = if self.below == Below::Vertical { depth.min(1.0) } else { depth };
        part * depth * self.by
    }
}
