use soilctl_soil::Rounded;
use thiserror::Error;

use crate::Joint;

/// What can be wrong with an arm, a posture, a pose or a motion.
///
/// Angles are in degrees here, because messages are read by people. The variants that the functions of a
/// control loop return hold no heap memory.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum KinematicsError {
    /// A number is NaN or infinite.
    #[error(
        "{quantity} is {value}; it must be a finite number: check the sensor or the computation it comes from"
    )]
    NonFinite {
        /// Name of the quantity.
        quantity: &'static str,
        /// The value given.
        value: f64,
    },
    /// A number is finite but outside the range in which it means anything.
    #[error("{quantity} is {} {unit}; it must be {allowed}", Rounded(*.value))]
    OutOfRange {
        /// Name of the quantity.
        quantity: &'static str,
        /// The value given, in `unit`.
        value: f64,
        /// Unit of `value`.
        unit: &'static str,
        /// The allowed range in words.
        allowed: &'static str,
    },
    /// No posture brings the wrist to where the pose needs it.
    #[error(
        "the wrist would be {} m from the shoulder, but upper arm and forearm reach from {} m to {} m; \
         move the pose or turn the plate", Rounded(*.distance_m), Rounded(*.nearest_m), Rounded(*.farthest_m)
    )]
    Unreachable {
        /// Distance that the pose asks for, in m.
        distance_m: f64,
        /// Smallest distance there is, in m.
        nearest_m: f64,
        /// Largest distance there is, in m.
        farthest_m: f64,
    },
    /// The posture exists but a joint cannot go there.
    #[error(
        "the {joint} joint would be at {} deg, outside its limits of {} deg to {} deg; \
         choose another pose", Rounded(*.angle_deg), Rounded(*.lower_deg), Rounded(*.upper_deg)
    )]
    OutOfLimits {
        /// The joint.
        joint: Joint,
        /// Where it would have to be, in degrees.
        angle_deg: f64,
        /// Its lower limit in degrees.
        lower_deg: f64,
        /// Its upper limit in degrees.
        upper_deg: f64,
    },
    /// The map between joints and pose has no inverse here.
    #[error("singular posture: {place}; {measure} is {} and must be at least {}", Rounded(*.value), Rounded(*.least))]
    Singular {
        /// What has become singular.
        place: Singularity,
        /// The number that measures the distance to the singularity, with its unit.
        measure: &'static str,
        /// Its value.
        value: f64,
        /// The smallest value that is accepted.
        least: f64,
    },
    /// Too few or too similar pushes to fit a compliance.
    #[error("{problem}, but {used} of the {given} pushes load the joint; {advice}")]
    Pushes {
        /// What the fit needs.
        problem: &'static str,
        /// Pushes that count.
        used: usize,
        /// Pushes given.
        given: usize,
        /// What to do.
        advice: &'static str,
    },
    /// An arm file could not be read.
    #[error("cannot read {file}: {reason}; check the path and the permissions")]
    Io {
        /// The file as it was asked for.
        file: String,
        /// What the operating system said.
        reason: String,
    },
    /// An arm file is not the TOML that is expected.
    #[error("{file}: {problem}")]
    Syntax {
        /// The file.
        file: String,
        /// What the parser said, with line and column.
        problem: String,
    },
    /// A key of an arm file holds a value that is not allowed.
    #[error("{file}: `{key}` is {}{}{unit}; it must be {allowed}", Rounded(*.value), space(.unit))]
    Config {
        /// The file.
        file: String,
        /// Full name of the key, such as `joints.elbow.lower_deg`.
        key: String,
        /// The value found, in `unit`.
        value: f64,
        /// Unit of `value`.
        unit: &'static str,
        /// The allowed range, and why or what to do.
        allowed: String,
    },
}

/// The places at which the arm loses a direction of motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum Singularity {
    /// The plate's lower edge is on the axis of the base joint.
    #[error("the tip is on or behind the axis of the base joint")]
    BaseAxis,
    /// Upper arm and forearm are in line.
    #[error("upper arm and forearm are in line")]
    StraightElbow,
    /// The tip is in line with the upper arm, so that shoulder and elbow move it in the same direction.
    #[error("the tip is in line with the upper arm")]
    TipInLine,
    /// The hand is at right angles to the arm's plane, where the pitch `n1` is undefined.
    #[error("the hand is at right angles to the arm's plane, where the pitch n1 is undefined")]
    SidewaysHand,
}

/// Between a number and its unit, if it has one.
fn space(unit: &str) -> &'static str {
    if unit.is_empty() { "" } else { " " }
}

/// Refuses numbers that are not finite, or larger in size than `most`.
///
/// `allowed` says the range in words, unit included.
pub(crate) fn check_size(
    quantity: &'static str,
    values: &[f64],
    most: f64,
    unit: &'static str,
    allowed: &'static str,
) -> Result<(), KinematicsError> {
    for &value in values {
        if !value.is_finite() {
            return Err(KinematicsError::NonFinite { quantity, value });
        }
        if value.abs() > most {
            return Err(KinematicsError::OutOfRange { quantity, value, unit, allowed });
        }
    }
    Ok(())
}
