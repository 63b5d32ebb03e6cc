//! Where the joints, forces and links of a bag of another program are.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::request::finite;
use crate::{AppError, files};

/// Where the joints, forces and links of a bag of another program are.
#[derive(Debug, Clone, Default, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
#[group(skip)]
pub struct Topics {
    /// Topic of the joint states [default: /joint_states, or the only one]
    #[arg(long, value_name = "TOPIC")]
    pub joint_topic: Option<String>,

    /// Topic of the wrenches of soil on plate [default: /wrench, or the only one]
    #[arg(long, value_name = "TOPIC")]
    pub wrench_topic: Option<String>,

    /// URDF of the arm [default: the one in the bag]
    #[arg(long, value_name = "FILE")]
    pub urdf: Option<PathBuf>,

    /// Link of the wrenches [default: the frame in their headers]
    #[arg(long, value_name = "LINK")]
    pub sensor_frame: Option<String>,

    /// Height of the soil in the URDF's root frame (m)
    #[arg(long = "surface-z", value_name = "M", value_parser = finite, allow_negative_numbers = true)]
    pub surface_z_m: Option<f64>,
}

impl Topics {
    /// The text of the URDF that was given.
    ///
    /// # Errors
    /// [`AppError::File`] if it cannot be read.
    pub fn urdf_text(&self) -> Result<Option<String>, AppError> {
        self.urdf.as_deref().map(files::read_text).transpose()
    }
}
