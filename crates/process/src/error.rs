use soilctl_bag::{BagError, Kind};
use soilctl_motion::MotionError;
use thiserror::Error;

/// What can be wrong with recorded strokes.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum ProcessError {
    /// Columns of one trace have different lengths.
    #[error("column {column} has {found} samples, t_s has {expected}; give each column one value a sample")]
    Lengths {
        /// Name of the column.
        column: &'static str,
        /// Its length.
        found: usize,
        /// Length of the time column.
        expected: usize,
    },
    /// A number that is not finite.
    #[error("{column} is {value} at sample {index} (from 0); every sample must be a finite number")]
    NotFinite {
        /// Name of the column.
        column: &'static str,
        /// Sample, from 0.
        index: usize,
        /// What is there.
        value: f64,
    },
    /// Time that stands still or runs backwards.
    #[error(
        "t_s goes from {before} to {after} s at sample {index} (from 0); sort the samples by time and drop repeated ones"
    )]
    Time {
        /// Sample, from 0.
        index: usize,
        /// Time of the sample before in s.
        before: f64,
        /// Time of the sample in s.
        after: f64,
    },
    /// Too little to work with.
    #[error("{found} {what}, at least {least} are needed")]
    TooFew {
        /// What is counted.
        what: &'static str,
        /// How many there are.
        found: usize,
        /// How many are needed.
        least: usize,
    },
    /// A stroke of another kind than those that it is compared with.
    #[error(
        "its force at the first look is {ratio:.2} times what the others say, below {limit:.2}: the soil or the stroke is of another kind, and its course says nothing by theirs"
    )]
    Unlike {
        /// Its force over that of the others.
        ratio: f64,
        /// The least by their scatter.
        limit: f64,
    },
    /// A URDF that can't be read.
    #[error("the URDF can't be used: {0}")]
    Urdf(String),
    /// A frame that the URDF doesn't have.
    #[error("the URDF has no link {frame:?}; it has {known}")]
    NoFrame {
        /// What was asked for.
        frame: String,
        /// The links there are.
        known: String,
    },
    /// What is needed and neither the log nor an option gives.
    #[error("{what} is missing: {advice}")]
    Missing {
        /// Name of the quantity, as the option is called.
        what: &'static str,
        /// What to do.
        advice: String,
    },
    /// A topic that is not there, or not of the type that is needed.
    #[error("there is no topic {wanted} of type {message_type}; the log has {known}")]
    Topic {
        /// What was looked for.
        wanted: String,
        /// The type it must have.
        message_type: &'static str,
        /// Topics and types of the log.
        known: String,
    },
    /// Joints that move plate or sensor and that no message names.
    #[error("{topic} never names {missing}, which move the plate or the sensor; it names {named}")]
    Joints {
        /// The topic.
        topic: String,
        /// Joints that are missing.
        missing: String,
        /// Joints that there are.
        named: String,
    },
    /// A log or a stroke in it, in words.
    #[error("{0}")]
    Log(String),
    /// The user wanted to stop.
    #[error("stopped before the log was read to its end")]
    Stopped,
    /// A number outside its range.
    #[error("{what} is {value} {unit}, allowed is {allowed}")]
    OutOfRange {
        /// Name of the quantity.
        what: &'static str,
        /// What was given.
        value: f64,
        /// Its unit.
        unit: &'static str,
        /// In words.
        allowed: &'static str,
    },
}

impl ProcessError {
    /// What the kinematics of the log's arm say.
    pub(crate) fn arm(error: soilctl_kinematics::KinematicsError) -> Self {
        Self::Log(error.to_string())
    }
}

/// `value` if it is finite and above zero.
pub(crate) fn positive(what: &'static str, value: f64, unit: &'static str) -> Result<f64, ProcessError> {
    if value.is_finite() && value > 0.0 {
        Ok(value)
    } else {
        Err(ProcessError::OutOfRange { what, value, unit, allowed: "a finite number above 0" })
    }
}

impl From<BagError> for ProcessError {
    fn from(error: BagError) -> Self {
        match error {
            BagError::Stopped => Self::Stopped,
            BagError::Topic { wanted, kind, known } => {
                let message_type = match kind {
                    Kind::Joints => "sensor_msgs/msg/JointState",
                    Kind::Wrench => "geometry_msgs/msg/WrenchStamped",
                    Kind::Text => "std_msgs/msg/String",
                    Kind::Points => "sensor_msgs/msg/PointCloud2",
                };
                Self::Topic { wanted, message_type, known }
            }
            other => Self::Log(other.to_string()),
        }
    }
}

impl From<MotionError> for ProcessError {
    fn from(error: MotionError) -> Self {
        match error {
            MotionError::Bag(error) => error.into(),
            MotionError::Urdf(error) => error.into(),
            MotionError::Missing { what, advice } => Self::Missing { what, advice },
            MotionError::Joints { topic, missing, named } => Self::Joints { topic, missing, named },
            other => Self::Log(other.to_string()),
        }
    }
}

impl From<soilctl_session::SessionError> for ProcessError {
    fn from(error: soilctl_session::SessionError) -> Self {
        Self::Log(error.to_string())
    }
}

impl From<soilctl_robot::RobotError> for ProcessError {
    fn from(error: soilctl_robot::RobotError) -> Self {
        match error {
            soilctl_robot::RobotError::NoLink { link, known } => Self::NoFrame { frame: link, known },
            other => Self::Urdf(other.to_string()),
        }
    }
}
