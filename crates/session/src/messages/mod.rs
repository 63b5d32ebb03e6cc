//! The messages of a log, field by field as their ROS 2 definitions in `msg/` and in ROS itself.

mod controller;
mod definitions;
mod request;
mod ros;
mod words;

pub use controller::{ControllerStep, EventMessage, Keyframe, SoilTruth};
pub(crate) use definitions::definition;
pub use ros::{
    Header, JointState, Quaternion, StringMessage, TfMessage, Time, Transform, TransformStamped, Vector3,
    Wrench, WrenchStamped,
};
pub use words::{variant, word};
