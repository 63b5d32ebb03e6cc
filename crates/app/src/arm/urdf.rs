//! An arm as a URDF, for viewers and ROS tools.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::read;
use crate::{AppError, Watch};

/// The arm as a URDF.
#[derive(Debug, Clone, Default, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
pub struct Request {
    /// Arm file (.toml)
    #[arg(long, value_name = "FILE")]
    pub arm: Option<PathBuf>,
}

/// An arm as a URDF.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Answer {
    /// The URDF document.
    pub urdf: String,
}

impl crate::Answer for Answer {
    const SCHEMA: &'static str = "soilctl.arm-urdf/1";
}

/// Writes the arm as a URDF.
///
/// # Errors
/// [`AppError`] if the file of the arm makes no sense.
pub fn run(request: &Request, _watch: &dyn Watch) -> Result<Answer, AppError> {
    Ok(Answer { urdf: soilctl_kinematics::urdf(&read(request.arm.as_deref())?) })
}
