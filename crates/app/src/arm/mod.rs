//! What an arm and its controller's settings are like, without moving anything.

pub mod skewing;
pub mod urdf;

use std::path::Path;

use soilctl_kinematics::Arm;

use crate::AppError;

/// The arm of a file, or that of the thesis.
fn read(path: Option<&Path>) -> Result<Arm, AppError> {
    Ok(path.map_or_else(|| Ok(Arm::thesis()), Arm::read)?)
}
