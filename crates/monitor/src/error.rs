use std::net::SocketAddr;

use soilctl_live::LiveError;
use soilctl_motion::MotionError;
use soilctl_session::SessionError;
use thiserror::Error;

/// Why a monitor could not be started.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum MonitorError {
    /// The address could not be listened at.
    #[error("{address} cannot be listened at: {reason}; give another address, or port 0 for any free port")]
    Listen {
        /// The address.
        address: SocketAddr,
        /// What the operating system said.
        reason: std::io::Error,
    },
    /// A log of another program does not hold what is needed, or something of it cannot be used.
    #[error("{file} cannot be played: {problem}")]
    Bag {
        /// Name of the log.
        file: String,
        /// What is wrong and what to do.
        problem: Box<MotionError>,
    },
    /// The arm file in a log, or of a session, is not allowed.
    #[error("the description of the arm is wrong: {0}")]
    Scene(String),
    /// The session ended while it was asked.
    #[error("the session has ended: {0}")]
    Ended(String),
    /// The session does not say what it runs with.
    #[error("the session does not say which arm it runs; use programs of one version")]
    Silent,
    /// The system gave no random bytes for the token.
    #[error("the system gives no random numbers ({0}), so there can be no token; leave commands off")]
    Random(String),
    /// A thread could not be started.
    #[error("the {thread} thread could not be started: {reason}; close some programs")]
    Thread {
        /// Which.
        thread: &'static str,
        /// What the operating system said.
        reason: std::io::Error,
    },
    /// The live session.
    #[error(transparent)]
    Live(#[from] LiveError),
    /// The log.
    #[error(transparent)]
    Session(#[from] SessionError),
}
