//! The messages of a log, field by field as their ROS 2 definitions in `msg/` and in ROS itself.

mod controller;
mod definitions;
mod request;
mod ros;
mod words;

use serde::Serialize;
use serde::de::DeserializeOwned;

pub use controller::{ControllerStep, EventMessage, Keyframe, SoilTruth};
pub(crate) use definitions::definition;
pub use ros::{
    Header, JointState, Quaternion, StringMessage, TfMessage, Time, Transform, TransformStamped, Vector3,
    Wrench, WrenchStamped,
};
pub use words::{variant, word};

/// A message as it stands in a log: CDR, little endian.
///
/// # Errors
/// In words, of a message that CDR cannot hold.
pub fn encode<T: Serialize>(message: &T) -> Result<Vec<u8>, String> {
    let mut bytes = Vec::new();
    crate::cdr::encode(message, &mut bytes).map_err(|error| error.to_string())?;
    Ok(bytes)
}

/// The message in the bytes of a log: CDR, little endian.
///
/// # Errors
/// In words, if they are not such a message.
pub fn decode<T: DeserializeOwned>(bytes: &[u8]) -> Result<T, String> {
    crate::cdr::decode(bytes)
}
