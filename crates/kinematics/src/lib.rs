#![doc = include_str!("../README.md")]

mod arm;
mod arm_at;
pub mod config;
mod error;
mod flexion;
mod flexion_fit;
mod forward;
mod frames;
mod gravity;
mod inertia;
mod inverse;
mod jacobian;
mod joint;
mod pose;
mod posture;
mod space;
mod stiffness;
mod tip_force;
mod transmission;
mod urdf;
mod validate;
mod velocity;

pub use arm::{Arm, LIMIT_TOLERANCE_RAD};
pub use arm_at::ArmAt;
pub use config::ArmConfig;
pub use error::{KinematicsError, Singularity};
pub use flexion::{Compliance, thesis_elbow_offset_rad};
pub use flexion_fit::{ComplianceFit, Push};
pub use frames::{Frame, LinkFrames};
pub use inertia::LinkBody;
pub use jacobian::Jacobian;
pub use joint::Joint;
pub use pose::TaskPose;
pub use space::{
    JointAngles, JointTorques, JointVelocities, MotorAngles, MotorTorques, MotorVelocities, TaskForce,
    TaskVelocity,
};
pub use stiffness::{CartesianStiffness, CylindricalStiffness, Wrist};
pub use transmission::Transmission;
pub use urdf::urdf;
pub use velocity::VelocitySolution;
