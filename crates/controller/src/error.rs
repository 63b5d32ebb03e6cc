use soilctl_kinematics::KinematicsError;
use soilctl_soil::Rounded;
use thiserror::Error;

/// What can be wrong with settings or a stroke plan. A running controller has no errors but events: see
/// [`EventKind`](crate::EventKind).
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum ControllerError {
    /// A file could not be read.
    #[error("cannot read {file}: {reason}; check the path and the permissions")]
    Io {
        /// The file as it was asked for.
        file: String,
        /// What the operating system said.
        reason: String,
    },
    /// A file is not the TOML that is expected.
    #[error("{file}: {problem}")]
    Syntax {
        /// The file.
        file: String,
        /// What the parser said, with line and column.
        problem: String,
    },
    /// A key holds a value that is not allowed.
    #[error("{file}: `{key}` is {}{}{unit}; it must be {allowed}", Rounded(*.value), if .unit.is_empty() { "" } else { " " })]
    Config {
        /// The file.
        file: String,
        /// Full name of the key, with the place in a list if it is one.
        key: String,
        /// The value found, in `unit`.
        value: f64,
        /// Unit of `value`.
        unit: &'static str,
        /// The allowed range, and why or what to do.
        allowed: String,
    },
    /// A stroke of a plan cannot be reached by the arm.
    #[error(
        "{file}: stroke {number} cannot be reached at {place}: {problem}; change its radius, base or tool angle"
    )]
    Unreachable {
        /// The file.
        file: String,
        /// Number of the stroke, from 1.
        number: usize,
        /// Above the soil or in it.
        place: &'static str,
        /// What the arm says.
        problem: Box<KinematicsError>,
    },
}
