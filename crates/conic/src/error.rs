use std::path::PathBuf;

use thiserror::Error;

/// Why there is no answer at all.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ConicError {
    /// A program that failed could not be written.
    #[error("{}: {message}; give another folder for failed programs, or none", path.display())]
    Dump {
        /// The file.
        path: PathBuf,
        /// What the system says.
        message: String,
    },
    /// The solver refused the program.
    #[error("the cone solver refused the program: {message}; please report the problem file")]
    Refused {
        /// The solver's words.
        message: String,
    },
}
