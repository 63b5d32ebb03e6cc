use soilctl_campaign::logged_truth;
use soilctl_controller::Sensed;
use soilctl_plant::{Drive, Hardware, Plant};
use soilctl_session::Truth;

use crate::LiveError;
use crate::driver::SocketDriver;

/// What a session drives.
pub enum Rig {
    /// The simulated plant.
    Plant(Box<Plant>),
    /// A driver of one's own behind a socket.
    Driver(Box<SocketDriver>),
}

impl Rig {
    pub(crate) const fn is_simulated(&self) -> bool {
        matches!(self, Self::Plant(_))
    }

    /// Prepares the soil anew; a real soil was prepared by somebody.
    pub(crate) fn prepare_soil(&mut self) {
        if let Self::Plant(plant) = self
            && let Some(ground) = plant.ground_mut()
        {
            ground.prepare();
        }
    }

    /// What a simulation knows, now.
    pub(crate) fn truth(&self) -> Option<Truth> {
        let Self::Plant(plant) = self else { return None };
        Some(logged_truth(plant.truth()))
    }

    /// Whether there will be no more readings. Allocates nothing.
    pub(crate) const fn is_gone(&self) -> bool {
        match self {
            Self::Plant(_) => false,
            Self::Driver(driver) => driver.is_gone(),
        }
    }

    /// Why the rig is of no use any more, if it is not.
    pub(crate) fn gone(&self) -> Option<LiveError> {
        match self {
            Self::Plant(_) => None,
            Self::Driver(driver) => driver.gone(),
        }
    }
}

impl Hardware for Rig {
    type Error = LiveError;

    fn exchange(&mut self, drive: &Drive) -> Result<Sensed, LiveError> {
        match self {
            Self::Plant(plant) => Ok(plant.exchange(drive)?),
            Self::Driver(driver) => driver.exchange(drive),
        }
    }
}
