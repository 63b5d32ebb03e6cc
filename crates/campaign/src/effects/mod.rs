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
use soilctl_effects::{EffectEntry, ModelFile, effect};
use soilctl_plant::config::PlantConfig;
use soilctl_plant::{Contact, Effects, SoilChange};

use crate::{CampaignError, Plan};
use sensors::Sensors;
use soil::SoilEffects;

/// Where an effect of the catalogue acts in the plant.
enum Kind {
    /// On the soil's strength.
    Strength,
    /// On the friction between soil and plate.
    Interface,
    /// On readings.
    Sensor,
    /// On drives.
    Drive,
    /// Nowhere, for this reason.
    None(&'static str),
}

fn kind(id: &str) -> Kind {
    match id {
        "interface_friction_offset" => Kind::Interface,
        "tool_angle_offset"
        | "force_scale"
        | "force_bias"
        | "force_drift"
        | "ft_crosstalk"
        | "encoder_quantisation" => Kind::Sensor,
        "cable_flex" | "backlash" | "backdrive_friction" => Kind::Drive,
        "rate_effect" => {
            Kind::None("all simulated strokes move at the speed that the controller's settings give")
        }
        _ => Kind::Strength,
    }
}

/// Amplitude of an effect; model files are checked when they are read.
fn amplitude(entry: &EffectEntry) -> f64 {
    effect(&entry.id)
        .and_then(|found| entry.parameters.get(found.parameter().name))
        .map_or(0.0, |parameter| parameter.value)
}

/// Refuses effects that the plant cannot show.
pub(crate) fn check(file: &ModelFile, name: &str) -> Result<(), CampaignError> {
    for entry in &file.effects {
        if let Kind::None(reason) = kind(&entry.id) {
            return Err(CampaignError::Effect { file: name.to_owned(), effect: entry.id.clone(), reason });
        }
    }
    Ok(())
}

/// The plant's description with the effects on its drives.
pub(crate) fn change_drives(file: &ModelFile, plan: &Plan, config: &mut PlantConfig) {
    for entry in file.effects.iter().filter(|entry| matches!(kind(&entry.id), Kind::Drive)) {
        arm::change(&entry.id, amplitude(entry), plan, config);
    }
}

/// All effects of a model file in one batch.
pub(crate) struct PlantEffects {
    soil: SoilEffects,
    sensors: Sensors,
    interface_rad: f64,
}

impl PlantEffects {
    /// Effects in a batch of a plan; `stroke` is the number of the stroke in the plan that is being made.
    pub(crate) fn new(
        file: &ModelFile,
        plan: &Plan,
        batch: usize,
        stroke: Arc<AtomicUsize>,
    ) -> Result<Self, CampaignError> {
        let of =
            |wanted: fn(&Kind) -> bool| file.effects.iter().filter(move |entry| wanted(&kind(&entry.id)));
        let interface_deg: f64 = of(|kind| matches!(kind, Kind::Interface)).map(amplitude).sum();
        Ok(Self {
            soil: SoilEffects::new(
                of(|kind| matches!(kind, Kind::Strength)),
                file,
                plan,
                batch,
                Arc::clone(&stroke),
            )?,
            sensors: Sensors::new(of(|kind| matches!(kind, Kind::Sensor)), plan, stroke),
            interface_rad: interface_deg.to_radians(),
        })
    }
}

impl Effects for PlantEffects {
    fn soil(&mut self, contact: &Contact, change: &mut SoilChange) {
        change.interface_rad += self.interface_rad;
        self.soil.change(contact, change);
    }

    fn sensed(&mut self, sensed: &mut Sensed) {
        self.sensors.change(sensed);
    }
}
