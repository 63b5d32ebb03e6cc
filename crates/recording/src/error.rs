use std::path::PathBuf;

use soilctl_motion::MotionError;
use soilctl_session::SessionError;
use thiserror::Error;

/// Why a log could not be made into a recording.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum RecordingError {
    /// The log is none of soilctl's, or too little of it is left.
    #[error(
        "{file} cannot be shown: it has no {what}; `rerun {file}` shows what Rerun itself makes of a log"
    )]
    NotOurs {
        /// The log.
        file: String,
        /// What is missing.
        what: &'static str,
    },
    /// The arm in the log is not allowed.
    #[error(
        "the description of the arm in {file} is wrong: {reason}; `soilctl log doctor` says what else is"
    )]
    Arm {
        /// The log.
        file: String,
        /// What is wrong with it.
        reason: String,
    },
    /// The recording could not be written.
    #[error("{}: {reason}; check the path, the permissions and the free space", path.display())]
    Write {
        /// The file.
        path: PathBuf,
        /// What the operating system or the encoder said.
        reason: String,
    },
    /// The log.
    #[error(transparent)]
    Session(#[from] SessionError),
    /// A recording of another program.
    #[error("{file} cannot be shown: {problem}")]
    Motion {
        /// The recording.
        file: String,
        /// What is wrong, and what to do.
        problem: Box<MotionError>,
    },
}
