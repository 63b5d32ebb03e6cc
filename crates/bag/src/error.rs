use std::path::Path;

use soilctl_session::SessionError;
use thiserror::Error;

use crate::Kind;

/// What can go wrong with a recording.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum BagError {
    /// A file could not be opened or read.
    #[error("{file}: {reason}; check the path and the permissions")]
    File {
        /// The file.
        file: String,
        /// What the operating system said.
        reason: String,
    },
    /// The file or folder is no recording.
    #[error(
        "{file} is not a recording that can be read: {reason}; give an MCAP file, a ROS 2 bag (.db3 or its folder with \
         metadata.yaml) or a ROS 1 bag of version 2.0"
    )]
    NotARecording {
        /// The file.
        file: String,
        /// What is wrong at its beginning.
        reason: String,
    },
    /// What is compressed grows beyond all measure.
    #[error(
        "{file} has more than {most} bytes once it is decompressed, against {packed} now; if it is to be trusted, decompress it with `zstd -d` first"
    )]
    TooLarge {
        /// The file.
        file: String,
        /// Its size as it is, in bytes.
        packed: u64,
        /// The largest size allowed, in bytes.
        most: u64,
    },
    /// A topic that is needed is not there.
    #[error("the recording has no topic {wanted} with {kind}; its topics are {known}; name one of them")]
    Topic {
        /// The topic asked for, or the usual one.
        wanted: String,
        /// What its messages should tell.
        kind: Kind,
        /// The topics with their types.
        known: String,
    },
    /// A topic that is there, but whose messages cannot be read.
    #[error(
        "the messages on {topic} cannot be read: {reason}; name another topic, or record it anew with its definition"
    )]
    Unreadable {
        /// The topic.
        topic: String,
        /// Why.
        reason: String,
    },
    /// The caller asked the work to end.
    #[error("stopped before the end of the recording")]
    Stopped,
    /// A log of ours.
    #[error(transparent)]
    Session(SessionError),
}

impl BagError {
    pub(crate) fn file(path: &Path, reason: &dyn std::fmt::Display) -> Self {
        Self::File { file: path.display().to_string(), reason: reason.to_string() }
    }

    pub(crate) fn not_a_recording(path: &Path, reason: impl Into<String>) -> Self {
        Self::NotARecording { file: path.display().to_string(), reason: reason.into() }
    }
}

impl From<SessionError> for BagError {
    fn from(error: SessionError) -> Self {
        match error {
            SessionError::File { path, reason } => Self::File { file: path.display().to_string(), reason },
            SessionError::NotALog { file, reason } => Self::NotARecording { file, reason },
            SessionError::Stopped => Self::Stopped,
            other => Self::Session(other),
        }
    }
}
