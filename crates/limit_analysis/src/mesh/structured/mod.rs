//! Meshes of cells in rows and columns, each cell cut into four triangles by its diagonals: the classic meshes of
//! limit analysis.
//!
//! Rows run along the top, the first at the top; columns go from left to right. Corners and lines of the outlines are
//! numbered from the upper left corner down, along the base, up, and back along the top. Everything is region 0.

mod cells;
mod plate;

pub use plate::{Below, PlateBlock, plate_block};

use super::MeshError;
use super::extract::Mesh;
use super::outline::{Line, LineUse, Outline, RegionOutline};
use super::vector::along;
use cells::{Cells, check_ascending};

/// A rectangle with cells between the given coordinates (m).
///
/// `columns` ascend and `rows` descend, at least two of each. The outline has the points upper left, lower left, lower
/// right, upper right, and the four lines between them in this order.
///
/// # Errors
///
/// [`MeshError::BadGrid`] for lists that are too short or not in order, [`MeshError::TooManyTriangles`] for more than
/// four million triangles, and what [`Outline::check`] finds, such as coordinates that are not finite.
pub fn rectangle(columns: &[f64], rows: &[f64]) -> Result<(Outline, Mesh), MeshError> {
    let cells = Cells::new(columns, rows, |x, y| [x, y])?;
    frame(cells)
}

/// A convex quadrilateral with cells between the given fractions of its sides, which ascend from 0 to 1.
///
/// `corners` are the upper left, lower left, lower right and upper right one, so they run counter-clockwise. `across`
/// are fractions from left to right and `down` from the top to the base.
///
/// # Errors
///
/// As for [`rectangle`]; and [`MeshError::BadGrid`] if the quadrilateral is not convex or runs clockwise.
pub fn block(corners: [[f64; 2]; 4], across: &[f64], down: &[f64]) -> Result<(Outline, Mesh), MeshError> {
    for (what, list) in [("fractions across", across), ("fractions down", down)] {
        check_ascending(what, list, 1.0)?;
        let ends = [list[0], list[list.len() - 1]];
        if ends != [0.0, 1.0] {
            let index = if ends[0] == 0.0 { list.len() - 1 } else { 0 };
            let allowed = "0 at the beginning of the list and 1 at its end";
            return Err(MeshError::BadGrid { what, index, value: list[index], allowed });
        }
    }
    let [upper_left, lower_left, lower_right, upper_right] = corners;
    let heights: Vec<f64> = down.iter().map(|v| -v).collect();
    let at =
        |u: f64, v: f64| along(along(upper_left, lower_left, -v), along(upper_right, lower_right, -v), u);
    frame(Cells::new(across, &heights, at)?)
}

/// The mesh of cells whose outline is just their frame.
fn frame(cells: Cells) -> Result<(Outline, Mesh), MeshError> {
    let [right, base] = cells.last();
    let corners = [[0, 0], [0, base], [right, base], [right, 0]];
    let lines = (0..4).map(|i| Line { from: i, to: (i + 1) % 4 }).collect();
    let loops = vec![(0..4).map(|line| LineUse { line, forward: true }).collect()];
    let outline = Outline {
        points: corners.map(|[i, j]| cells.at(i, j)).to_vec(),
        lines,
        regions: vec![RegionOutline { loops }],
    };
    let chains = vec![
        (0..=base).map(|j| cells.number(0, j)).collect(),
        (0..=right).map(|i| cells.number(i, base)).collect(),
        (0..=base).rev().map(|j| cells.number(right, j)).collect(),
        (0..=right).rev().map(|i| cells.number(i, 0)).collect(),
    ];
    let mesh = cells.mesh(&outline, chains)?;
    Ok((outline, mesh))
}

/// Coordinates from `from` to `to`, both included, with `count` intervals of which each is `ratio` times as long as the
/// one before. `count` is 1 to a million and `ratio` positive.
///
/// # Errors
///
/// [`MeshError::BadGrid`] for other counts and ratios, and if the ends are not finite.
pub fn graded(from: f64, to: f64, count: usize, ratio: f64) -> Result<Vec<f64>, MeshError> {
    let bad = |index, value, allowed| Err(MeshError::BadGrid { what: "graded list", index, value, allowed });
    if !(1..=1_000_000).contains(&count) {
        return bad(0, count as f64, "a count from 1 to a million");
    }
    if !(ratio > 0.0 && ratio.is_finite()) {
        return bad(0, ratio, "a ratio that is positive and finite");
    }
    if let Some(&end) = [from, to].iter().find(|c| !c.is_finite()) {
        return bad(if from.is_finite() { count } else { 0 }, end, "finite");
    }
    // Lengths relative to the longest, so that none overflows.
    let from_longest = |i: usize| if ratio > 1.0 { count - 1 - i } else { i };
    let shrink = ratio.min(1.0 / ratio);
    let mut sums = vec![0.0];
    for i in 0..count {
        sums.push(sums[i] + shrink.powf(from_longest(i) as f64));
    }
    let total = sums[count];
    let mut list: Vec<f64> = sums.into_iter().map(|s| from + (to - from) * (s / total)).collect();
    list[count] = to;
    Ok(list)
}
