//! Effects of a model file on the simulated plant.
//!
//! What the soil does differently goes through the catalogue itself: the limit force is multiplied by the ratio of the
//! catalogue's force with the effect to that without it, at the plate's true place, depth and angle. What sensors and drives
//! do differently is put where it is in the arm.

mod arm;
mod place;
mod sensors;
mod soil;

use std::sync::Arc;
use std::sync::atomic::AtomicUsize;

use soilctl_controller::Sensed;
use soilctl_effects::{Active, Covariate, ModelFile, Site, SoilSite, SurfaceSite};
use soilctl_plant::config::PlantConfig;
use soilctl_plant::{Contact, Effects, SoilChange};

use crate::{CampaignError, Plan};
use sensors::Sensors;
use soil::SoilEffects;

/// The effects of a model file, if the plant can show them all and its empirical terms.
pub(crate) fn shown(file: &ModelFile, name: &str) -> Result<Vec<Active>, CampaignError> {
    let effects = file.active(name)?;
    if file.empirical.iter().any(|term| term.over.contains(&Covariate::Speed)) {
        return Err(CampaignError::Term { file: name.to_owned(), over: Covariate::Speed });
    }
    match effects.iter().find(|active| active.effect.varies_with == Some(Covariate::Speed)) {
        Some(of_speed) => Err(CampaignError::Effect {
            file: name.to_owned(),
            effect: of_speed.effect.id,
            reason: "all simulated strokes move at the speed that the controller's settings give",
        }),
        None => Ok(effects),
    }
}

/// The plant's description with the effects on its drives.
pub(crate) fn change_drives(effects: &[Active], plan: &Plan, config: &mut PlantConfig) {
    for active in effects {
        if let Site::Drive(site) = active.effect.site {
            arm::change(site, active.amplitude, plan, config);
        }
    }
}

/// All effects of a model file in one batch.
pub(crate) struct PlantEffects {
    soil: SoilEffects,
    sensors: Sensors,
    interface_rad: f64,
    depth_m: f64,
}

impl PlantEffects {
    /// Effects in a batch of a plan; `stroke` is the number of the stroke in the plan that is being made.
    pub(crate) fn new(
        effects: &[Active],
        file: &ModelFile,
        plan: &Plan,
        batch: usize,
        stroke: Arc<AtomicUsize>,
    ) -> Result<Self, CampaignError> {
        let mut soil = SoilEffects::new(&file.reference, &file.empirical, plan, batch, Arc::clone(&stroke))?;
        let mut sensors = Sensors::new(plan, stroke);
        let (mut interface_deg, mut depth_m) = (0.0, 0.0);
        for &active in effects {
            match active.effect.site {
                Site::Surface(SurfaceSite::Height) => depth_m += active.amplitude,
                Site::Soil(SoilSite::Strength | SoilSite::Loosening)
                | Site::Surface(SurfaceSite::Slope | SurfaceSite::Load)
                | Site::Model => soil.add(active, false),
                Site::Soil(SoilSite::Mobilisation) => soil.add(active, true),
                Site::Interface => interface_deg += active.amplitude,
                Site::Sensor(site) => sensors.add(site, active.amplitude, plan),
                // In the plant's description already.
                Site::Drive(_) => {}
            }
        }
        Ok(Self { soil, sensors, interface_rad: f64::to_radians(interface_deg), depth_m })
    }
}

impl Effects for PlantEffects {
    fn soil(&mut self, contact: &Contact, change: &mut SoilChange) {
        change.interface_rad += self.interface_rad;
        change.depth_m += self.depth_m;
        self.soil.change(contact, change);
    }

    fn sensed(&mut self, sensed: &mut Sensed) {
        self.sensors.change(sensed);
    }
}
