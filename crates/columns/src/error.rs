use thiserror::Error;

use crate::Kind;

/// What can go wrong while a table is written.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ColumnsError {
    /// The file cannot be written.
    #[error(transparent)]
    Io(#[from] std::io::Error),
    /// CSV cannot be written.
    #[error(transparent)]
    Csv(#[from] csv::Error),
    /// Parquet cannot be written.
    #[error(transparent)]
    Parquet(#[from] parquet::errors::ParquetError),
    /// A row with too few or too many cells.
    #[error("row {row} has {found} cells, but the table has {expected} columns; give each column one cell")]
    Width {
        /// The row, from 1.
        row: usize,
        /// Cells in the row.
        found: usize,
        /// Columns of the table.
        expected: usize,
    },
    /// A cell that its column does not take.
    #[error("row {row}, column {column} is {found:?}, but the column holds cells of kind {kind:?}")]
    Cell {
        /// The row, from 1.
        row: usize,
        /// The column, from 1.
        column: usize,
        /// What is there.
        found: String,
        /// What the column holds.
        kind: Kind,
    },
}

impl From<ColumnsError> for std::io::Error {
    fn from(problem: ColumnsError) -> Self {
        match problem {
            ColumnsError::Io(problem) => problem,
            ColumnsError::Csv(problem) => problem.into(),
            ColumnsError::Parquet(_) | ColumnsError::Width { .. } | ColumnsError::Cell { .. } => {
                Self::other(problem)
            }
        }
    }
}
