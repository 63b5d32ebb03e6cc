//! What recordings of other programs do not say, for those verbs that show them.

use std::path::{Path, PathBuf};

use soilctl_app::topics::Topics;
use soilctl_motion::{Settings, Sought};

use crate::error::CliError;

/// What a recording of another program does not say.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Recordings of other programs")]
pub(crate) struct BagArgs {
    #[command(flatten)]
    topics: Topics,

    /// Link whose origin is marked [default: plate_tip, or the link behind most joints]
    #[arg(long, value_name = "LINK")]
    plate_frame: Option<String>,

    /// Folder with the meshes that the URDF names, or with packages that have them; may be repeated [default: beside --urdf]
    #[arg(long, value_name = "DIR")]
    mesh_root: Vec<PathBuf>,
}

impl BagArgs {
    pub(crate) fn settings(&self) -> Result<Settings, CliError> {
        Ok(Settings {
            urdf: self.topics.urdf_text()?,
            joint_topic: self.topics.joint_topic.clone(),
            wrench_topic: self.topics.wrench_topic.clone(),
            end_link: self.plate_frame.clone(),
            sensor_link: self.topics.sensor_frame.clone(),
            meshes: Sought {
                roots: self.mesh_root.clone(),
                urdf_folder: self.topics.urdf.as_deref().and_then(Path::parent).map(Path::to_owned),
            },
            surface_z_m: self.topics.surface_z_m,
        })
    }
}
