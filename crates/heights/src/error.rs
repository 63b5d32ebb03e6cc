use soilctl_bag::BagError;
use thiserror::Error;

/// Why there is no height map, or nothing to be told of two of them.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum HeightsError {
    /// A file could not be opened or read.
    #[error("{file}: {reason}; check the path and the permissions")]
    File {
        /// The file.
        file: String,
        /// What the operating system said.
        reason: String,
    },
    /// A file that is no height map, or not one that is read.
    #[error("{file} is no height map that can be read: {reason}")]
    Format {
        /// The file.
        file: String,
        /// What is wrong with it, and what to do.
        reason: String,
    },
    /// A line of a text file.
    #[error("{file}, line {line}: {reason}")]
    Line {
        /// The file.
        file: String,
        /// Line of the file, from 1 on.
        line: u64,
        /// What is wrong with it.
        reason: String,
    },
    /// More cells or points than are read.
    #[error(
        "{file} has {count} {what}; at most {most} are read: crop it to the ground around the plate, or make it coarser"
    )]
    TooLarge {
        /// The file, or what was to be made.
        file: String,
        /// What there is too much of.
        what: &'static str,
        /// How much there is.
        count: u64,
        /// How much may be.
        most: u64,
    },
    /// A value outside of its range.
    #[error("{what} is {value} {unit}; it must be {allowed}")]
    OutOfRange {
        /// What it is.
        what: &'static str,
        /// Its value.
        value: f64,
        /// Its unit.
        unit: &'static str,
        /// What is allowed.
        allowed: &'static str,
    },
    /// Maps that have nothing to do with each other.
    #[error(
        "{cells} cells of the map before the stroke are seen in the one after it, too few to compare; both must be of the same ground in the same frame, in m"
    )]
    NoOverlap {
        /// Cells with heights in both.
        cells: usize,
    },
    /// The plate is not on the map.
    #[error(
        "the plate's face at x = {x_m} m, y = {y_m} m is not on the ground seen before and after, which reaches from x = {} to {} m and y = {} to {} m; give its place in the frame of the maps",
        x_range_m[0], x_range_m[1], y_range_m[0], y_range_m[1]
    )]
    PlateOutside {
        /// Where the plate should be.
        x_m: f64,
        /// Where the plate should be.
        y_m: f64,
        /// What the map covers.
        x_range_m: [f64; 2],
        /// What the map covers.
        y_range_m: [f64; 2],
    },
    /// A recording.
    #[error(transparent)]
    Bag(#[from] BagError),
}

impl HeightsError {
    pub(crate) fn file(file: &str, reason: &dyn std::fmt::Display) -> Self {
        Self::File { file: file.to_owned(), reason: reason.to_string() }
    }

    pub(crate) fn format(file: &str, reason: impl Into<String>) -> Self {
        Self::Format { file: file.to_owned(), reason: reason.into() }
    }
}

/// `value` if it is finite and within its range.
pub(crate) fn within(
    what: &'static str,
    value: f64,
    unit: &'static str,
    range: [f64; 2],
    allowed: &'static str,
) -> Result<f64, HeightsError> {
    if (range[0]..=range[1]).contains(&value) {
        Ok(value)
    } else {
        Err(HeightsError::OutOfRange { what, value, unit, allowed })
    }
}
