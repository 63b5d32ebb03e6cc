use std::path::PathBuf;

use thiserror::Error;

/// Why a solution cannot be read, or a bound is not proven.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum CertificateError {
    /// The file cannot be opened, read or written.
    #[error("{}: {message}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// What the system says.
        message: String,
    },
    /// The file is larger than what is read.
    #[error("{} has more than {limit} bytes; is it a saved solution?", path.display())]
    TooLarge {
        /// The file.
        path: PathBuf,
        /// The largest size that is read.
        limit: u64,
    },
    /// The text is not a solution.
    #[error("{} is not a saved solution: {message}", path.display())]
    Format {
        /// The file.
        path: PathBuf,
        /// What is wrong where.
        message: String,
    },
    /// The file says that it is something else.
    #[error("the schema is \"{found}\"; this program reads \"{expected}\"")]
    Schema {
        /// What the file says.
        found: String,
        /// What it must say.
        expected: &'static str,
    },
    /// A number is outside its range.
    #[error("{quantity} of {place} is {value} {unit}; it must be {allowed}")]
    OutOfRange {
        /// The quantity.
        quantity: &'static str,
        /// Where it is.
        place: String,
        /// The number.
        value: f64,
        /// Its unit.
        unit: &'static str,
        /// What is allowed.
        allowed: &'static str,
    },
    /// An index points at nothing.
    #[error("{place} names {what} {index}, but there are {count}, counted from 0")]
    NoSuch {
        /// Where the index is.
        place: String,
        /// What it should point at.
        what: &'static str,
        /// The index.
        index: usize,
        /// How many there are.
        count: usize,
    },
    /// Lists that belong together have different lengths.
    #[error("{list} has {found} entries; it needs {needed}, one for each {each}")]
    Length {
        /// The list.
        list: &'static str,
        /// Its length.
        found: usize,
        /// The length it must have.
        needed: usize,
        /// What it has one entry for.
        each: &'static str,
    },
    /// The statement contradicts itself or has no clear meaning.
    #[error("the statement is not a problem: {place}: {problem}")]
    BadStatement {
        /// Which part.
        place: String,
        /// What is wrong with it.
        problem: &'static str,
    },
    /// The statement means something, but there is no proof for it here yet.
    #[error("not covered yet: {place}: {what}")]
    NotCovered {
        /// Which part.
        place: String,
        /// What is not covered.
        what: &'static str,
    },
    /// The triangles do not cover the regions exactly once.
    #[error("the mesh does not fit the regions: {place}: {problem}")]
    BadMesh {
        /// Which part.
        place: String,
        /// What is wrong with it.
        problem: &'static str,
    },
    /// The field is not built as it must be.
    #[error("the field breaks a rule of its construction: {place}: {problem}")]
    BadField {
        /// Which part.
        place: String,
        /// Which rule.
        problem: &'static str,
    },
    /// A quantity that must not be negative may be.
    #[error(
        "not proven: {quantity} at {place} must be at least zero, but may be as low as {low:.3e} {unit}; \
         solve again with a larger margin"
    )]
    NotProven {
        /// The quantity.
        quantity: &'static str,
        /// Where.
        place: String,
        /// The least value that it may have; minus infinity where an operation overflows.
        low: f64,
        /// Its unit.
        unit: &'static str,
    },
    /// A proven lower bound above a proven upper bound: the checker itself is wrong.
    #[error(
        "proven bounds contradict each other ({lower} > {upper}): this is a fault of the checker, please report it"
    )]
    Contradiction {
        /// Lower bound.
        lower: f64,
        /// Upper bound.
        upper: f64,
    },
}
