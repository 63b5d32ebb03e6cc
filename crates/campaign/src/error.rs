use std::path::{Path, PathBuf};

use soilctl_controller::ControllerError;
use soilctl_earth_pressure::EarthPressureError;
use soilctl_effects::{Covariate, EffectId, EffectsError};
use soilctl_jobs::JobsError;
use soilctl_kinematics::KinematicsError;
use soilctl_plant::PlantError;
use soilctl_session::SessionError;
use soilctl_strokes::StrokesError;
use thiserror::Error;

/// What can be wrong with a campaign.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum CampaignError {
    /// A file or folder could not be read or written.
    #[error("{}: {reason}; check the path, the permissions and the free space", path.display())]
    File {
        /// The file or folder.
        path: PathBuf,
        /// What the operating system said.
        reason: String,
    },
    /// A plan is not the TOML that is expected.
    #[error("{file}: {problem}")]
    Plan {
        /// The plan.
        file: String,
        /// What is wrong, with the key or the place.
        problem: String,
    },
    /// An effect of a model file that the simulated plant cannot show.
    #[error(
        "{file}: the effect `{effect}` cannot be simulated: {reason}; take it out of the file, or use `predict`"
    )]
    Effect {
        /// The model file.
        file: String,
        /// Id of the effect.
        effect: EffectId,
        /// Why not.
        reason: &'static str,
    },
    /// An empirical term of a model file that the simulated plant cannot show.
    #[error(
        "{file}: an empirical term over {over} cannot be simulated: all simulated strokes move at the speed that the controller's settings give; take \
         it out of the file, or use `predict`"
    )]
    Term {
        /// The model file.
        file: String,
        /// The condition.
        over: Covariate,
    },
    /// A folder that holds another campaign, or a thread that could not be started.
    #[error(transparent)]
    Jobs(#[from] JobsError),
    /// Settings of the controller, or strokes.
    #[error(transparent)]
    Controller(#[from] ControllerError),
    /// The arm.
    #[error(transparent)]
    Kinematics(#[from] KinematicsError),
    /// The plant or its soil.
    #[error(transparent)]
    Plant(#[from] PlantError),
    /// The force model.
    #[error(transparent)]
    Model(#[from] EarthPressureError),
    /// The model file.
    #[error(transparent)]
    Effects(#[from] EffectsError),
    /// A log.
    #[error(transparent)]
    Session(#[from] SessionError),
    /// `campaign.json`.
    #[error(transparent)]
    Strokes(#[from] StrokesError),
}

impl CampaignError {
    pub(crate) fn file(path: &Path, reason: &dyn std::fmt::Display) -> Self {
        Self::File { path: path.to_owned(), reason: reason.to_string() }
    }
}
