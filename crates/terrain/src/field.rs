use crate::error::{TerrainError, within};

/// The most cells of a grid: 4096 x 4096.
pub const MOST_CELLS: usize = 1 << 24;

/// Heights of a soil surface over square cells, between walls.
///
/// Cell (i, j) has its centre at `((i + 1/2) cell, (j + 1/2) cell)`; x runs along a row, y from row to row.
#[derive(Debug, Clone, PartialEq)]
pub struct HeightField {
    columns: usize,
    rows: usize,
    cell_m: f64,
    pub(crate) heights_m: Vec<f64>,
    /// Room for what moves in a step: through faces along x and along y, over corners that rise and fall along x.
    pub(crate) flux_m: Vec<f64>,
    /// Share of each cell that the present stroke has swept.
    pub(crate) swept: Vec<f64>,
}

impl HeightField {
    /// A level surface of `columns` x `rows` cells with sides of `cell_m` (m, 1e-6 to 1e3) at `height_m` (m, -1e3 to
    /// 1e3).
    ///
    /// # Errors
    /// [`TerrainError::Cells`], [`TerrainError::OutOfRange`].
    pub fn level(columns: usize, rows: usize, cell_m: f64, height_m: f64) -> Result<Self, TerrainError> {
        let cells = columns.checked_mul(rows).filter(|cells| (1..=MOST_CELLS).contains(cells));
        let Some(cells) = cells else {
            return Err(TerrainError::Cells { columns, rows, most: MOST_CELLS });
        };
        within("side of a cell", cell_m, "m", [1e-6, 1e3], "1e-6 to 1000 m")?;
        check_height(height_m)?;
        let (heights_m, flux_m, swept) = (vec![height_m; cells], vec![0.0; 4 * cells], vec![0.0; cells]);
        Ok(Self { columns, rows, cell_m, heights_m, flux_m, swept })
    }

    /// A surface of given heights in m (-1e3 to 1e3), row by row.
    ///
    /// # Errors
    /// Those of [`HeightField::level`], and [`TerrainError::Heights`].
    pub fn from_heights(columns: usize, cell_m: f64, heights_m: Vec<f64>) -> Result<Self, TerrainError> {
        let rows = heights_m.len().checked_div(columns).unwrap_or(0);
        let mut field = Self::level(columns, rows, cell_m, 0.0)?;
        if heights_m.len() != field.heights_m.len() {
            return Err(TerrainError::Heights { found: heights_m.len(), expected: field.heights_m.len() });
        }
        for height in &heights_m {
            check_height(*height)?;
        }
        field.heights_m = heights_m;
        Ok(field)
    }

    /// Cells along x.
    #[must_use]
    pub const fn columns(&self) -> usize {
        self.columns
    }

    /// Cells along y.
    #[must_use]
    pub const fn rows(&self) -> usize {
        self.rows
    }

    /// Side of a cell in m.
    #[must_use]
    pub const fn cell_m(&self) -> f64 {
        self.cell_m
    }

    /// Heights in m, row by row.
    #[must_use]
    pub fn heights_m(&self) -> &[f64] {
        &self.heights_m
    }

    /// Length and width of the box in m.
    #[must_use]
    #[allow(clippy::cast_precision_loss, reason = "at most 2^24 cells")]
    pub fn size_m(&self) -> [f64; 2] {
        [self.columns as f64 * self.cell_m, self.rows as f64 * self.cell_m]
    }

    /// Height in m at a place (m), of the cell that holds it; `None` outside the box.
    #[must_use]
    pub fn height_at_m(&self, place_m: [f64; 2]) -> Option<f64> {
        self.heights_m.get(self.cell_of(place_m)?).copied()
    }

    /// Volume of the soil above height 0 in m3, summed with the rounding errors carried along (Neumaier 1974).
    #[must_use]
    pub fn volume_m3(&self) -> f64 {
        let (mut sum, mut lost) = (0.0_f64, 0.0);
        for height in &self.heights_m {
            let next = sum + height;
            lost += if sum.abs() >= height.abs() { (sum - next) + height } else { (height - next) + sum };
            sum = next;
        }
        (sum + lost) * self.cell_m * self.cell_m
    }

    /// The steepest slope, height over length, between a cell and any of its eight neighbours.
    #[must_use]
    pub fn steepest_slope(&self) -> f64 {
        let (n, h) = (self.columns, &self.heights_m);
        let mut straight = 0.0_f64;
        let mut diagonal = 0.0_f64;
        for j in 0..self.rows {
            for i in 0..n {
                let k = j * n + i;
                let (right, up) = (i + 1 < n, j + 1 < self.rows);
                if right {
                    straight = straight.max((h[k + 1] - h[k]).abs());
                }
                if up {
                    straight = straight.max((h[k + n] - h[k]).abs());
                }
                if right && up {
                    diagonal = diagonal.max((h[k + n + 1] - h[k]).abs()).max((h[k + n] - h[k + 1]).abs());
                }
            }
        }
        straight.max(diagonal * std::f64::consts::FRAC_1_SQRT_2) / self.cell_m
    }

    /// Index of the cell that holds a place.
    pub(crate) fn cell_of(&self, [x, y]: [f64; 2]) -> Option<usize> {
        let along = |place: f64, count: usize| {
            let cell = (place / self.cell_m).floor();
            // A cell number of at most 2^24 is exact.
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, clippy::cast_precision_loss)]
            (cell >= 0.0 && cell < count as f64).then_some(cell as usize)
        };
        Some(along(y, self.rows)? * self.columns + along(x, self.columns)?)
    }
}

fn check_height(height_m: f64) -> Result<f64, TerrainError> {
    within("height", height_m, "m", [-1e3, 1e3], "-1000 to 1000 m")
}
