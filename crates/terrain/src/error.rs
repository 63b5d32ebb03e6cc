use thiserror::Error;

/// What can be wrong with a surface or what is done to it.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum TerrainError {
    /// A grid without cells, or with too many.
    #[error("a grid of {columns} x {rows} cells, allowed are 1 to {most} cells; choose larger cells")]
    Cells {
        /// Cells along x.
        columns: usize,
        /// Cells along y.
        rows: usize,
        /// The most there may be.
        most: usize,
    },
    /// Heights that don't fill the grid.
    #[error("{found} heights for {expected} cells; give one for each cell, row by row")]
    Heights {
        /// Heights given.
        found: usize,
        /// Cells.
        expected: usize,
    },
    /// A number outside its range.
    #[error("{what} is {value} {unit}, allowed is {allowed}")]
    OutOfRange {
        /// Name of the quantity.
        what: &'static str,
        /// What was given.
        value: f64,
        /// Its unit.
        unit: &'static str,
        /// In words.
        allowed: &'static str,
    },
    /// A place outside the grid.
    #[error("nothing of {what} lies inside the box, which reaches from 0 to {x_m} m and from 0 to {y_m} m")]
    Outside {
        /// What was placed.
        what: &'static str,
        /// Length of the box in m.
        x_m: f64,
        /// Width of the box in m.
        y_m: f64,
    },
}

/// `value` if it is finite and within the limits.
pub(crate) fn within(
    what: &'static str,
    value: f64,
    unit: &'static str,
    [low, high]: [f64; 2],
    allowed: &'static str,
) -> Result<f64, TerrainError> {
    if value >= low && value <= high {
        Ok(value)
    } else {
        Err(TerrainError::OutOfRange { what, value, unit, allowed })
    }
}
