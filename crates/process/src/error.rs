use thiserror::Error;

/// What can be wrong with recorded strokes.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum ProcessError {
    /// Columns of one trace have different lengths.
    #[error("column {column} has {found} samples, t_s has {expected}; give each column one value a sample")]
    Lengths {
        /// Name of the column.
        column: &'static str,
        /// Its length.
        found: usize,
        /// Length of the time column.
        expected: usize,
    },
    /// A number that is not finite.
    #[error("{column} is {value} at sample {index} (from 0); every sample must be a finite number")]
    NotFinite {
        /// Name of the column.
        column: &'static str,
        /// Sample, from 0.
        index: usize,
        /// What is there.
        value: f64,
    },
    /// Time that stands still or runs backwards.
    #[error(
        "t_s goes from {before} to {after} s at sample {index} (from 0); sort the samples by time and drop repeated ones"
    )]
    Time {
        /// Sample, from 0.
        index: usize,
        /// Time of the sample before in s.
        before: f64,
        /// Time of the sample in s.
        after: f64,
    },
    /// Too little to work with.
    #[error("{found} {what}, at least {least} are needed")]
    TooFew {
        /// What is counted.
        what: &'static str,
        /// How many there are.
        found: usize,
        /// How many are needed.
        least: usize,
    },
    /// A URDF that can't be read.
    #[error("the URDF can't be used: {0}")]
    Urdf(String),
    /// A frame that the URDF doesn't have.
    #[error("the URDF has no link {frame:?}; it has {known}")]
    NoFrame {
        /// What was asked for.
        frame: String,
        /// The links there are.
        known: String,
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
}

/// `value` if it is finite and above zero.
pub(crate) fn positive(what: &'static str, value: f64, unit: &'static str) -> Result<f64, ProcessError> {
    if value.is_finite() && value > 0.0 {
        Ok(value)
    } else {
        Err(ProcessError::OutOfRange { what, value, unit, allowed: "a finite number above 0" })
    }
}
