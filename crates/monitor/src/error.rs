use soilctl_campaign::CampaignError;
use soilctl_live::LiveError;
use soilctl_motion::MotionError;
use soilctl_session::SessionError;
use soilctl_web::WebError;
use thiserror::Error;

/// Why a monitor could not be started.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum MonitorError {
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
    /// A thread could not be started.
    #[error("the {thread} thread could not be started: {reason}; close some programs")]
    Thread {
        /// Which.
        thread: &'static str,
        /// What the operating system said.
        reason: std::io::Error,
    },
    /// The address cannot be listened at, there is no token, or no thread.
    #[error(transparent)]
    Web(#[from] WebError),
    /// A log cannot be made.
    #[error("{path} cannot be written: {reason}; choose another place with --log")]
    File {
        /// The log.
        path: String,
        /// What the operating system said.
        reason: std::io::Error,
    },
    /// The soil or the arm of a session that is to be begun.
    #[error(transparent)]
    Campaign(#[from] CampaignError),
    /// The live session.
    #[error(transparent)]
    Live(#[from] LiveError),
    /// The log.
    #[error(transparent)]
    Session(#[from] SessionError),
}
