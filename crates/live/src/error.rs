use std::path::{Path, PathBuf};

use soilctl_plant::PlantError;
use soilctl_session::SessionError;
use thiserror::Error;

/// What can go wrong with a live session.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum LiveError {
    /// A socket could not be made, opened, read or written.
    #[error("{}: {reason}; check that the other program runs, and the path and its permissions", path.display())]
    Socket {
        /// Path of the socket.
        path: PathBuf,
        /// What the operating system said.
        reason: String,
    },
    /// The path of a socket is taken.
    #[error("{} is taken: {by}; give another path, or end the other program", path.display())]
    Taken {
        /// Path of the socket.
        path: PathBuf,
        /// By what.
        by: &'static str,
    },
    /// A thread could not be started.
    #[error("the {thread} thread could not be started: {reason}; close some programs")]
    Thread {
        /// Which.
        thread: &'static str,
        /// What the operating system said.
        reason: std::io::Error,
    },
    /// A thread ended unexpectedly.
    #[error("the {0} thread ended unexpectedly; please report this")]
    Lost(&'static str),
    /// The other side speaks another protocol, or none.
    #[error("{} does not speak protocol {known}: {found}; use programs of one version", path.display())]
    Protocol {
        /// Path of the socket.
        path: PathBuf,
        /// The version that this program speaks.
        known: u32,
        /// What it said.
        found: String,
    },
    /// The driver went away or broke the protocol. The arm was brought to the safe state.
    #[error("the driver behind {} {reason}; start it again, and then a new session", path.display())]
    Driver {
        /// Path of its socket.
        path: PathBuf,
        /// What happened.
        reason: String,
    },
    /// A device is to lead the plate in a session that does not keep to the clock.
    #[error(
        "a device that leads the plate needs a session in real time; simulated time would not wait for it"
    )]
    DeviceNeedsRealTime,
    /// A log.
    #[error(transparent)]
    Session(#[from] SessionError),
    /// The simulated plant.
    #[error(transparent)]
    Plant(#[from] PlantError),
}

impl LiveError {
    pub(crate) fn socket(path: &Path, reason: &dyn std::fmt::Display) -> Self {
        Self::Socket { path: path.to_owned(), reason: reason.to_string() }
    }
}
