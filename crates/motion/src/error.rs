use soilctl_bag::BagError;
use soilctl_robot::RobotError;
use thiserror::Error;

/// Why a recording tells nothing of an arm.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum MotionError {
    /// The recording, or a topic in it.
    #[error(transparent)]
    Bag(#[from] BagError),
    /// The arm's description.
    #[error("the URDF can't be used: {0}")]
    Urdf(#[from] RobotError),
    /// There is nothing in it.
    #[error("it has no messages")]
    Empty,
    /// What is needed and neither the recording nor an option gives.
    #[error("{what} is missing: {advice}")]
    Missing {
        /// Name of the quantity, as the option is called.
        what: &'static str,
        /// What to do.
        advice: String,
    },
    /// Joints that are needed and that no message names.
    #[error("{topic} never names {missing}, which move the plate or the sensor; it names {named}")]
    Joints {
        /// The topic.
        topic: String,
        /// Joints that are missing.
        missing: String,
        /// Joints that there are.
        named: String,
    },
    /// More messages than memory has room for.
    #[error("it has more than {most} {what}; split it into shorter recordings")]
    TooMany {
        /// What is counted.
        what: &'static str,
        /// The most that are read.
        most: usize,
    },
    /// A topic that has no table.
    #[error("there is no topic {topic}; the recording has {known}")]
    NoTopic {
        /// What was asked for.
        topic: String,
        /// The topics there are.
        known: String,
    },
    /// No message of a topic can be read.
    #[error("no message on {topic} can be read: {reason}")]
    Unreadable {
        /// The topic.
        topic: String,
        /// Why, of the first one.
        reason: String,
    },
    /// A table that cannot be written.
    #[error("{file}: {reason}; check the path, the permissions and the free space")]
    Write {
        /// The file.
        file: String,
        /// What the operating system said.
        reason: String,
    },
}

impl MotionError {
    /// Whether the caller asked the work to end.
    #[must_use]
    pub const fn is_stop(&self) -> bool {
        matches!(self, Self::Bag(BagError::Stopped))
    }
}
