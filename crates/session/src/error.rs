use std::path::{Path, PathBuf};

use soilctl_controller::ControllerError;
use soilctl_kinematics::KinematicsError;
use thiserror::Error;

/// What can go wrong with a log.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum SessionError {
    /// A file could not be opened, read or written.
    #[error("{}: {reason}; check the path, the permissions and the free space", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// What the operating system said.
        reason: String,
    },
    /// The log could not be written any further; what was flushed before can be read.
    #[error(
        "the log could not be written after {steps} steps: {reason}; what was written before can be read, free some space \
         and go on in a new file"
    )]
    Write {
        /// Steps that were handed to the file.
        steps: u64,
        /// What the operating system or the encoder said.
        reason: String,
    },
    /// The thread that writes the log could not be started.
    #[error("the thread that writes the log could not be started: {0}; close some programs")]
    Thread(std::io::Error),
    /// The file is no log at all.
    #[error("{file} is not an MCAP file: {reason}; give a log that soilctl or a ROS 2 recorder wrote")]
    NotALog {
        /// The file.
        file: String,
        /// What is wrong at its beginning.
        reason: String,
    },
    /// The log lacks something that is needed.
    #[error("{file} has no {what}; {advice}")]
    Missing {
        /// The file.
        file: String,
        /// What is missing.
        what: String,
        /// What to do.
        advice: &'static str,
    },
    /// A message does not have the form that its type says.
    #[error(
        "message {number} on {topic} cannot be decoded: {reason}; `soilctl log doctor` says what else is wrong"
    )]
    Message {
        /// The topic.
        topic: String,
        /// Number of the message on its topic, from 0.
        number: u64,
        /// What is wrong.
        reason: String,
    },
    /// A record of another version.
    #[error(
        "{what} has version {found}; this program reads version {known}, use the program that wrote the log"
    )]
    Version {
        /// Which record.
        what: &'static str,
        /// The version found.
        found: String,
        /// The version that is understood.
        known: u32,
    },
    /// A key frame that is not there.
    #[error("there is no key frame {wanted}; the log has {available}, counted from 0")]
    NoKeyframe {
        /// The number asked for.
        wanted: u32,
        /// How many there are.
        available: u32,
    },
    /// A topic that cannot be exported.
    #[error("{topic} cannot be exported as a table; choose one of {known}")]
    NoTable {
        /// The topic asked for.
        topic: String,
        /// The topics that can.
        known: String,
    },
    /// The caller asked the work to end.
    #[error("stopped before the end of the log")]
    Stopped,
    /// A state could not be encoded as a key frame, or decoded.
    #[error("a key frame cannot be read or written: {0}; the log is damaged or of another program")]
    Keyframe(postcard::Error),
    /// Settings of the controller.
    #[error(transparent)]
    Controller(#[from] ControllerError),
    /// The arm.
    #[error(transparent)]
    Kinematics(#[from] KinematicsError),
    /// Settings that could not be put into TOML.
    #[error("the settings could not be put into TOML: {0}")]
    Toml(#[from] toml::ser::Error),
}

impl SessionError {
    pub(crate) fn file(path: &Path, reason: &dyn std::fmt::Display) -> Self {
        Self::File { path: path.to_owned(), reason: reason.to_string() }
    }
}

/// The reason behind an error of the MCAP library, which keeps what the system said to itself.
pub(crate) fn reason(error: &mcap::McapError) -> String {
    match error {
        mcap::McapError::Io(inner) => inner.to_string(),
        mcap::McapError::Parse(_) => "a record is malformed".to_owned(),
        other => other.to_string(),
    }
}
