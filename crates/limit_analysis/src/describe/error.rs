use std::path::PathBuf;

use thiserror::Error;

/// What is wrong with a problem description. Entries are named by their number in the file, from 1, and their name.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum DescriptionError {
    /// The file cannot be read.
    #[error("{}: {message}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// What the system says.
        message: String,
    },
    /// The file is too long to be a problem description.
    #[error("{}: more than {limit} bytes; a problem description has at most that many", path.display())]
    TooLarge {
        /// The file.
        path: PathBuf,
        /// The limit in bytes.
        limit: u64,
    },
    /// The name of the file does not tell its format.
    #[error("{}: the name must end in .toml or .json", path.display())]
    Ending {
        /// The file.
        path: PathBuf,
    },
    /// The text is not a problem description.
    #[error("{place}: {message}")]
    Format {
        /// The file, or "the text".
        place: String,
        /// What is wrong where, over several lines.
        message: String,
    },
    /// Too much of something.
    #[error("there are {count} {what}, at most {limit} are taken; simplify the problem")]
    TooMuch {
        /// Of what.
        what: &'static str,
        /// How many.
        count: usize,
        /// How many are taken.
        limit: usize,
    },
    /// A number out of range.
    #[error("{entry}: {key} is {value}, allowed is {allowed}")]
    Number {
        /// The entry.
        entry: String,
        /// Its key.
        key: &'static str,
        /// What it says.
        value: f64,
        /// What it may say.
        allowed: &'static str,
    },
    /// A name that no entry has.
    #[error("{entry}: {key} is \"{name}\", but there is none of that name; there is {known}")]
    Unknown {
        /// The entry.
        entry: String,
        /// Its key.
        key: &'static str,
        /// What it says.
        name: String,
        /// What it could say.
        known: String,
    },
    /// An entry that makes no sense by itself.
    #[error("{entry}: {problem}")]
    Entry {
        /// The entry.
        entry: String,
        /// What is wrong and what to do.
        problem: String,
    },
    /// Two entries claim the same soil.
    #[error("{first} and {second} overlap at ({:.6}, {:.6}); move their common edge to one place", at[0], at[1])]
    Overlap {
        /// One entry.
        first: String,
        /// The other.
        second: String,
        /// A place in both, in m.
        at: [f64; 2],
    },
    /// Two lines are almost one.
    #[error(
        "{first} and {second} nearly touch at ({:.9}, {:.9}): closer than {least:.1e} m but not joined; give both the \
         same points there, or keep them apart", at[0], at[1]
    )]
    NearlyTouch {
        /// One entry.
        first: String,
        /// The other.
        second: String,
        /// Where, in m.
        at: [f64; 2],
        /// Least distance in m.
        least: f64,
    },
    /// Outline without a boundary condition.
    #[error(
        "no boundary condition on the outline {parts}; add [[boundary]] entries for it, or default_boundary = \"free\""
    )]
    NoCondition {
        /// The parts, as lines from point to point.
        parts: String,
    },
    /// Two entries say what holds on one line.
    #[error("{first} and {second} both hold between ({:.6}, {:.6}) and ({:.6}, {:.6}); keep one", line[0][0], line[0][1], line[1][0], line[1][1])]
    Conflict {
        /// One entry.
        first: String,
        /// The other.
        second: String,
        /// The line, in m.
        line: [[f64; 2]; 2],
    },
}

impl DescriptionError {
    pub(super) fn entry(entry: impl Into<String>, problem: impl Into<String>) -> Self {
        Self::Entry { entry: entry.into(), problem: problem.into() }
    }
}
