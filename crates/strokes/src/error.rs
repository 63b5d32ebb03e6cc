use std::fmt;

use thiserror::Error;

/// A cell of a stroke table.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Place {
    /// Name of the file.
    pub file: String,
    /// Line in the file, from 1.
    pub line: usize,
    /// Name of the column.
    pub column: String,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}, line {}, column {}", self.file, self.line, self.column)
    }
}

/// What can be wrong with a stroke table or a campaign description.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum StrokesError {
    /// A file could not be read or written.
    #[error("{file}: {problem}")]
    File {
        /// Name of the file.
        file: String,
        /// What the system says.
        problem: String,
    },
    /// Nothing in the file.
    #[error("{file} is empty; it must start with a header that names at least {columns}")]
    Empty {
        /// Name of the file.
        file: String,
        /// The columns that it needs, separated by commas.
        columns: String,
    },
    /// A header without rows.
    #[error("{file} has a header but no strokes; add at least one row")]
    NoRows {
        /// Name of the file.
        file: String,
    },
    /// Two strokes of one name.
    #[error(
        "{file}, lines {first} and {second}: both strokes have the stroke_id {stroke_id:?}; give each stroke its own, or \
         remove the row that is there twice"
    )]
    SameName {
        /// Name of the file.
        file: String,
        /// The name.
        stroke_id: String,
        /// Line of the first one, from 1.
        first: usize,
        /// Line of the second one.
        second: usize,
    },
    /// More than the reader takes.
    #[error("{file} has more than {limit}; split it into several files")]
    TooLarge {
        /// Name of the file.
        file: String,
        /// The limit with its unit.
        limit: String,
    },
    /// Bytes that are not text.
    #[error(
        "{file}, line {line}: byte {at} of {cell} is 0x{byte:02x}, which is not UTF-8; save the file as UTF-8"
    )]
    NotUtf8 {
        /// Name of the file.
        file: String,
        /// Line in the file, from 1.
        line: usize,
        /// Which cell.
        cell: String,
        /// Place of the first bad byte in the cell, from 1.
        at: usize,
        /// The byte.
        byte: u8,
    },
    /// A required column is not in the header.
    #[error("{file} has no column {column}, which is required; its columns are {found}{hint}")]
    MissingColumn {
        /// Name of the file.
        file: String,
        /// The column.
        column: &'static str,
        /// The columns found, separated by commas.
        found: String,
        /// What may have happened, or nothing.
        hint: &'static str,
    },
    /// Two columns of one name.
    #[error(
        "{file}, line {line}: column {column:?} appears twice, as number {first} and {second}; rename or remove one"
    )]
    DuplicateColumn {
        /// Name of the file.
        file: String,
        /// Line of the header.
        line: usize,
        /// The name.
        column: String,
        /// Number of the first one, from 1.
        first: usize,
        /// Number of the second one.
        second: usize,
    },
    /// A row that is longer or shorter than the header.
    #[error(
        "{file}, line {line} has {found} cells, but the header has {expected}; look for a missing or extra comma"
    )]
    Ragged {
        /// Name of the file.
        file: String,
        /// Line in the file, from 1.
        line: usize,
        /// Cells in this row.
        found: usize,
        /// Cells in the header.
        expected: usize,
    },
    /// A required cell without content.
    #[error("{place} is empty, but every stroke needs it ({allowed}); fill it or remove the row")]
    EmptyCell {
        /// Where.
        place: Place,
        /// The allowed range with its unit.
        allowed: String,
    },
    /// Text where a number must be.
    #[error(
        "{place} is {text:?}, which is not a number; it must be {allowed}, or empty if optional and not measured"
    )]
    NotANumber {
        /// Where.
        place: Place,
        /// What stands there.
        text: String,
        /// The allowed range with its unit.
        allowed: String,
    },
    /// A number that cannot be meant: not finite, or outside the range of its column.
    #[error("{place} is {text}; it must be {allowed}; correct the cell or remove the row")]
    OutOfRange {
        /// Where.
        place: Place,
        /// What stands there.
        text: String,
        /// The allowed range with its unit.
        allowed: String,
    },
    /// A force claimed to be known exactly, or better.
    #[error(
        "{place} is {text}, a force without uncertainty; give a positive standard deviation in N, or use the exact \
         data mode (--exact)"
    )]
    ZeroUncertainty {
        /// Where.
        place: Place,
        /// What stands there.
        text: String,
    },
    /// Repeated strokes with equal forces.
    #[error(
        "{file}, lines {lines}: the {count} strokes at {label} have the same force_n, so their standard deviation is \
         0 N; give force_sd_n (above 0 N) for them, or use the exact data mode (--exact)"
    )]
    ZeroSpread {
        /// Name of the file.
        file: String,
        /// The lines, separated by commas.
        lines: String,
        /// Number of strokes.
        count: usize,
        /// The geometry in words.
        label: String,
    },
    /// A stroke whose uncertainty is unknown.
    #[error(
        "{file}, line {line}: the only stroke at {label} has no force_sd_n, so its uncertainty is unknown; give \
         force_sd_n (above 0 N) or repeat the stroke with equal alpha_deg, depth_m and width_m"
    )]
    LoneStroke {
        /// Name of the file.
        file: String,
        /// Line in the file, from 1.
        line: usize,
        /// The geometry in words.
        label: String,
    },
    /// A campaign description that is not JSON, or not an object.
    #[error("{file} is not a JSON object: {problem}")]
    NotAnObject {
        /// Name of the file.
        file: String,
        /// What is wrong, with line and column where it is known.
        problem: String,
    },
    /// A key of a campaign description with a value that cannot be meant.
    #[error("{file}, key {key} is {found}; it must be {allowed}, or left out (then it is {default})")]
    BadKey {
        /// Name of the file.
        file: String,
        /// The key; `instrument.` before it if it is inside of that object.
        key: String,
        /// What stands there.
        found: String,
        /// What is allowed, with its unit.
        allowed: &'static str,
        /// The value taken when the key is left out.
        default: String,
    },
    /// A key of a campaign description that nobody reads.
    #[error(
        "{file}, key {key} is none that means anything; the known key most like it is {nearest}; correct or remove it \
         (known are {known})"
    )]
    UnknownKey {
        /// Name of the file.
        file: String,
        /// The key; `instrument.` before it if it is inside of that object.
        key: String,
        /// The known key that is most like it.
        nearest: String,
        /// All known keys, separated by commas.
        known: String,
    },
}

impl StrokesError {
    /// A problem with a file as the system words it.
    pub(crate) fn file(file: &str, problem: &dyn fmt::Display) -> Self {
        Self::File { file: file.into(), problem: problem.to_string() }
    }
}
