use crate::HeightsError;
use crate::error::within;

/// The most cells of a map: 4096 x 4096.
pub const MOST_CELLS: usize = 1 << 24;
/// The most that a height may be from zero, in m: all of the ground is within, and the usual codes for no data are not.
pub const MOST_HEIGHT_M: f64 = 9000.0;
/// The most that a coordinate may be from zero, in m: the largest of any projection of the Earth.
const MOST_PLACE_M: f64 = 1e8;

/// A regular grid of places: cells in columns and rows, which may be turned or sheared against the axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grid {
    columns: usize,
    rows: usize,
    origin_m: [f64; 2],
    column_m: [f64; 2],
    row_m: [f64; 2],
}

impl Grid {
    /// `columns` x `rows` cells (at most [`MOST_CELLS`]). `origin_m` is the centre of the first cell (m, within 1e8), `column_m` and `row_m` lead
    /// from a cell to the next in its row and in its column (m, each 1e-6 to 1e3 long, at least 1 deg apart).
    ///
    /// # Errors
    /// [`HeightsError::TooLarge`], [`HeightsError::OutOfRange`].
    pub fn new(
        size: [usize; 2],
        origin_m: [f64; 2],
        column_m: [f64; 2],
        row_m: [f64; 2],
    ) -> Result<Self, HeightsError> {
        let [columns, rows] = size;
        let cells = columns.saturating_mul(rows);
        if cells > MOST_CELLS {
            let file = "the map".to_owned();
            return Err(HeightsError::TooLarge {
                file,
                what: "cells",
                count: cells as u64,
                most: MOST_CELLS as u64,
            });
        }
        within("number of cells", cells as f64, "", [1.0, f64::MAX], "at least 1")?;
        for x in origin_m {
            within("coordinate of the map", x, "m", [-MOST_PLACE_M, MOST_PLACE_M], "within 1e8 m of zero")?;
        }
        for step in [column_m, row_m] {
            within("side of a cell", length(step), "m", [1e-6, 1e3], "1e-6 to 1000 m: is the map in m?")?;
        }
        let grid = Self { columns, rows, origin_m, column_m, row_m };
        let sine = grid.area_m2() / (length(column_m) * length(row_m));
        within(
            "sine of the angle between rows and columns",
            sine,
            "",
            [0.0175, 1.0 + 1e-9],
            "at least 0.0175",
        )?;
        Ok(grid)
    }

    /// Cells in a row, and rows.
    #[must_use]
    pub const fn size(&self) -> [usize; 2] {
        [self.columns, self.rows]
    }

    /// Cells.
    #[must_use]
    pub const fn cells(&self) -> usize {
        self.columns * self.rows
    }

    /// Area of a cell in m2.
    #[must_use]
    pub fn area_m2(&self) -> f64 {
        (self.column_m[0] * self.row_m[1] - self.column_m[1] * self.row_m[0]).abs()
    }

    /// Side of a square as large as a cell, in m.
    #[must_use]
    pub fn cell_m(&self) -> f64 {
        self.area_m2().sqrt()
    }

    /// Centre of a cell in m.
    #[must_use]
    pub fn place(&self, cell: usize) -> [f64; 2] {
        let (i, j) = ((cell % self.columns) as f64, (cell / self.columns) as f64);
        [0, 1].map(|axis| self.origin_m[axis] + i * self.column_m[axis] + j * self.row_m[axis])
    }

    /// Column and row at a place (m), with what is between cells; whole numbers are their centres.
    #[must_use]
    pub fn at(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let (x, y) = (x - self.origin_m[0], y - self.origin_m[1]);
        let ([a, b], [c, d]) = (self.column_m, self.row_m);
        let determinant = a * d - b * c;
        [(d * x - c * y) / determinant, (a * y - b * x) / determinant]
    }

    /// The cell that holds a place (m).
    #[must_use]
    pub fn cell_of(&self, place: [f64; 2]) -> Option<usize> {
        // Of an edge between two cells, the second.
        let [i, j] = self.at(place).map(|at| (at + 0.5).floor());
        let inside = (0.0..self.columns as f64).contains(&i) && (0.0..self.rows as f64).contains(&j);
        inside.then_some(j as usize * self.columns + i as usize)
    }

    /// The up to eight cells around a cell.
    pub(crate) fn around(&self, cell: usize) -> impl Iterator<Item = usize> + use<> {
        let (columns, rows) = (self.columns, self.rows);
        let (i, j) = (cell % columns, cell / columns);
        let near = move |x: usize, most: usize| x.saturating_sub(1)..=(x + 1).min(most.saturating_sub(1));
        near(j, rows)
            .flat_map(move |b| near(i, columns).map(move |a| b * columns + a))
            .filter(move |other| *other != cell)
    }

    /// Whether a cell is at the edge of the map.
    pub(crate) const fn is_edge(&self, cell: usize) -> bool {
        let (i, j) = (cell % self.columns, cell / self.columns);
        i == 0 || j == 0 || i + 1 == self.columns || j + 1 == self.rows
    }

    /// Least and greatest coordinates of the centres, in m.
    #[must_use]
    pub fn extent_m(&self) -> [[f64; 2]; 2] {
        let [i, j] = [self.columns - 1, (self.rows - 1) * self.columns];
        let corners = [0, i, j, i + j].map(|cell| self.place(cell));
        [0, 1].map(|axis| {
            corners.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], c| {
                [low.min(c[axis]), high.max(c[axis])]
            })
        })
    }

    /// The part of the grid within `reach_m` of a place along rows and columns, and the first of its columns and rows; `None` if it is
    /// elsewhere.
    fn part(&self, place: [f64; 2], reach_m: f64) -> Option<(Self, [usize; 2])> {
        let at = self.at(place);
        let steps = [length(self.column_m), length(self.row_m)];
        let mut first = [0; 2];
        let mut size = [0; 2];
        for (axis, most) in [self.columns, self.rows].into_iter().enumerate() {
            let half = reach_m / steps[axis];
            let low = (at[axis] - half).ceil().max(0.0);
            let high = (at[axis] + half).floor().min(most as f64 - 1.0);
            if low > high || (high - low).is_nan() {
                return None;
            }
            first[axis] = low as usize;
            size[axis] = high as usize - first[axis] + 1;
        }
        let origin_m = self.place(first[1] * self.columns + first[0]);
        Some((Self { columns: size[0], rows: size[1], origin_m, ..*self }, first))
    }
}

pub(crate) fn length([x, y]: [f64; 2]) -> f64 {
    libm::hypot(x, y)
}

/// Heights of the ground over a grid; where nothing was seen there is none.
#[derive(Debug, Clone, PartialEq)]
pub struct HeightMap {
    grid: Grid,
    heights_m: Vec<Option<f64>>,
}

impl HeightMap {
    /// Heights (m, within [`MOST_HEIGHT_M`] of zero) over the cells of a grid, row by row.
    ///
    /// # Errors
    /// [`HeightsError::OutOfRange`] for a height that is not finite or too far from zero, or if there are not as many as cells.
    pub fn new(grid: Grid, heights_m: Vec<Option<f64>>) -> Result<Self, HeightsError> {
        let count = heights_m.len() as f64;
        within("number of heights", count, "", [grid.cells() as f64; 2], "that of the cells of the grid")?;
        for height in heights_m.iter().flatten() {
            within(
                "a height",
                *height,
                "m",
                [-MOST_HEIGHT_M, MOST_HEIGHT_M],
                "within 9000 m of zero; if it stands for no data, the file must say so",
            )?;
        }
        Ok(Self { grid, heights_m })
    }

    /// Where the cells are.
    #[must_use]
    pub const fn grid(&self) -> &Grid {
        &self.grid
    }

    /// Heights in m, row by row.
    #[must_use]
    pub fn heights_m(&self) -> &[Option<f64>] {
        &self.heights_m
    }

    /// Cells with a height.
    #[must_use]
    pub fn seen(&self) -> usize {
        self.heights_m.iter().flatten().count()
    }

    /// Height in m at a place (m), bilinear between the centres of four cells; `None` outside of them, or where one of them that counts
    /// was not seen.
    #[must_use]
    pub fn height_m(&self, place: [f64; 2]) -> Option<f64> {
        let [columns, rows] = self.grid.size();
        // Places that are a centre but for rounding are that cell alone.
        let parts = self.grid.at(place).map(|x| if (x - x.round()).abs() < 1e-6 { x.round() } else { x });
        let first = parts.map(f64::floor);
        let mut height = 0.0;
        for (di, dj) in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)] {
            let share =
                |part: f64, first: f64, d: f64| if d > 0.0 { part - first } else { 1.0 - (part - first) };
            let weight = share(parts[0], first[0], di) * share(parts[1], first[1], dj);
            if weight == 0.0 {
                continue;
            }
            let (i, j) = (first[0] + di, first[1] + dj);
            if !((0.0..columns as f64).contains(&i) && (0.0..rows as f64).contains(&j)) {
                return None;
            }
            height += weight * (*self.heights_m.get(j as usize * columns + i as usize)?)?;
        }
        Some(height)
    }

    /// The part of the map within `reach_m` of a place (m) along its rows and columns; `None` if the map is elsewhere.
    #[must_use]
    pub fn part(&self, place: [f64; 2], reach_m: f64) -> Option<Self> {
        let (grid, [left, below]) = self.grid.part(place, reach_m)?;
        let [columns, rows] = grid.size();
        let heights_m = (0..rows)
            .flat_map(|j| {
                let start = (below + j) * self.grid.columns + left;
                self.heights_m.get(start..start + columns).unwrap_or_default().iter().copied()
            })
            .collect();
        Some(Self { grid, heights_m })
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    fn turned() -> Grid {
        let (c, s) = (0.8, 0.6);
        Grid::new([5, 4], [100.0, -20.0], [0.1 * c, 0.1 * s], [-0.2 * s, 0.2 * c]).unwrap()
    }

    #[test]
    fn places_and_cells_are_inverse() {
        let grid = turned();
        assert!((grid.area_m2() - 0.02).abs() < 1e-12);
        for cell in 0..grid.cells() {
            assert_eq!(grid.cell_of(grid.place(cell)), Some(cell));
        }
        assert_eq!(grid.cell_of([0.0, 0.0]), None);
        assert_eq!(grid.around(0).collect::<Vec<_>>(), [1, 5, 6]);
        assert_eq!(grid.around(7).count(), 8);
    }

    /// A plane is reproduced anywhere between the centres; outside, and beside what was not seen, there is nothing.
    #[test]
    fn a_plane_is_interpolated() {
        let grid = turned();
        let plane = |[x, y]: [f64; 2]| 0.3 * (x - 100.0) - 0.2 * (y + 20.0) + 1.0;
        let mut heights: Vec<_> = (0..grid.cells()).map(|cell| Some(plane(grid.place(cell)))).collect();
        let whole = HeightMap::new(grid, heights.clone()).unwrap();
        heights[6] = None;
        let map = HeightMap::new(grid, heights).unwrap();
        let [a, b] = [grid.place(12), grid.place(18)];
        let middle = [0, 1].map(|axis| 0.7 * a[axis] + 0.3 * b[axis]);
        assert!((whole.height_m(middle).unwrap() - plane(middle)).abs() < 1e-12);
        assert_eq!(map.height_m(grid.place(6)), None);
        assert!(map.height_m(grid.place(7)).is_some());
        let [a, b] = [grid.place(6), grid.place(12)];
        assert_eq!(map.height_m([0, 1].map(|axis| f64::midpoint(a[axis], b[axis]))), None);
        assert_eq!(map.height_m([99.0, -20.0]), None);
        assert_eq!(map.seen(), 19);
    }

    #[test]
    fn a_part_keeps_places_and_heights() {
        let grid = turned();
        let map = HeightMap::new(grid, (0..20).map(|i| Some(f64::from(i))).collect()).unwrap();
        let part = map.part(grid.place(7), 0.21).unwrap();
        assert_eq!(part.grid().size(), [5, 3]);
        let part = map.part(grid.place(12), 0.11).unwrap();
        assert_eq!(part.grid().size(), [3, 1]);
        assert_eq!(part.heights_m(), [11.0, 12.0, 13.0].map(Some));
        for (a, b) in part.grid().place(1).into_iter().zip(grid.place(12)) {
            assert!((a - b).abs() < 1e-12);
        }
        assert!(map.part([0.0, 0.0], 1.0).is_none());
    }

    #[test]
    fn what_makes_no_sense_is_refused() {
        let new = |size, origin, column, row| Grid::new(size, origin, column, row).is_err();
        let (x, y) = ([0.1, 0.0], [0.0, 0.1]);
        assert!(new([0, 4], [0.0; 2], x, y));
        assert!(new([usize::MAX, 4], [0.0; 2], x, y));
        assert!(new([4, 4], [f64::NAN, 0.0], x, y));
        assert!(new([4, 4], [0.0; 2], x, x));
        assert!(new([4, 4], [0.0; 2], [0.0; 2], y));
        let grid = Grid::new([2, 1], [0.0; 2], x, y).unwrap();
        for wrong in [f64::NAN, f64::INFINITY, -9999.0] {
            assert!(HeightMap::new(grid, vec![Some(0.0), Some(wrong)]).is_err());
        }
        assert!(HeightMap::new(grid, vec![None]).is_err());
    }
}
