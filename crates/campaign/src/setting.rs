//! Settings of a simulated plant that nobody measures of a real one, and by how much they may be off.

use soilctl_plant::config::PlantConfig;

use crate::unlike::{CONTACT, FRICTION, SAND};
use crate::{CampaignError, Plan};

/// Joints whose drives lift and lower the plate.
const SHOULDER: usize = 1;
const ELBOW: usize = 2;

/// A setting, or some that go together.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Setting {
    /// Way to failure.
    Mobilisation,
    /// How sharply the force bends over at failure.
    Bend,
    /// How much strength is lost after failure.
    LossOfStrength,
    /// The way over which it is lost.
    WayOfLoss,
    /// Elastic way along the plate.
    TangentWay,
    /// Time in which the wedge follows the inclination of the force.
    WedgeTime,
    /// Bearing of the plate's edge.
    Bearing,
    /// Drift of the plate while it goes in, as steep plates do.
    InsertionDrift,
    /// The same at any angle.
    MisalignmentDrift,
    /// Length of heaps.
    HeapLength,
    /// Dry friction of the shoulder's drive.
    ShoulderFriction,
    /// Dry friction of the elbow's drive.
    ElbowFriction,
    /// Viscous friction of all drives.
    ViscousFriction,
}

impl Setting {
    /// All of them.
    pub const ALL: [Self; 13] = [
        Self::Mobilisation,
        Self::Bend,
        Self::LossOfStrength,
        Self::WayOfLoss,
        Self::TangentWay,
        Self::WedgeTime,
        Self::Bearing,
        Self::InsertionDrift,
        Self::MisalignmentDrift,
        Self::HeapLength,
        Self::ShoulderFriction,
        Self::ElbowFriction,
        Self::ViscousFriction,
    ];

    /// What it is, in words.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Mobilisation => "the way to failure",
            Self::Bend => "the sharpness of the bend at failure",
            Self::LossOfStrength => "the loss of strength",
            Self::WayOfLoss => "the way of the loss of strength",
            Self::TangentWay => "the elastic way along the plate",
            Self::WedgeTime => "the time in which the wedge follows",
            Self::Bearing => "the bearing of the plate's edge",
            Self::InsertionDrift => "the drift of an insertion",
            Self::MisalignmentDrift => "the drift by misalignment",
            Self::HeapLength => "the length of heaps",
            Self::ShoulderFriction => "the shoulder's dry friction",
            Self::ElbowFriction => "the elbow's dry friction",
            Self::ViscousFriction => "the viscous friction of the drives",
        }
    }

    /// The factor by which it may be off, up or down, above 1. Empirical.
    #[must_use]
    pub const fn most(self) -> f64 {
        match self {
            Self::Mobilisation
            | Self::Bend
            | Self::LossOfStrength
            | Self::WayOfLoss
            | Self::Bearing
            | Self::InsertionDrift
            | Self::MisalignmentDrift
            | Self::HeapLength => SAND,
            Self::TangentWay | Self::WedgeTime => CONTACT,
            Self::ShoulderFriction | Self::ElbowFriction | Self::ViscousFriction => FRICTION,
        }
    }

    fn times(self, plant: &mut PlantConfig, factor: f64) {
        let (ground, drives) = (&mut plant.ground, &mut plant.drives);
        match self {
            Self::Mobilisation => {
                ground.loose_mobilisation *= factor;
                ground.dense_mobilisation *= factor;
            }
            Self::Bend => {
                ground.gradual_exponent *= factor;
                ground.drastic_exponent *= factor;
            }
            Self::LossOfStrength => ground.residual_drop *= factor,
            Self::WayOfLoss => ground.residual_way_m *= factor,
            Self::TangentWay => ground.tangent_way_m *= factor,
            Self::WedgeTime => ground.wedge_time_s *= factor,
            Self::Bearing => ground.bearing_shape *= factor,
            Self::InsertionDrift => ground.insertion_drift *= factor,
            Self::MisalignmentDrift => ground.misalignment_drift *= factor,
            Self::HeapLength => ground.heap_length *= factor,
            Self::ShoulderFriction => drives.friction_nm[SHOULDER] *= factor,
            Self::ElbowFriction => drives.friction_nm[ELBOW] *= factor,
            Self::ViscousFriction => drives.viscous_nms_per_rad.iter_mut().for_each(|value| *value *= factor),
        }
    }
}

impl Plan {
    /// The same plan on a plant whose setting is off by a factor.
    ///
    /// # Errors
    /// [`CampaignError::Plan`], or what the plant refuses, if the setting is then beyond its range.
    pub fn with_setting(&self, setting: Setting, factor: f64) -> Result<Self, CampaignError> {
        let mut plan = self.clone();
        let model = plan.file().model.clone();
        plan.change(&format!("{} times {factor}", setting.name()), &model, |_, plant| {
            setting.times(plant, factor)
        })?;
        Ok(plan)
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::*;

    /// Each setting changes the plant, up and down, and the factor undoes itself.
    #[test]
    fn every_setting_changes_the_plant() {
        let plan = crate::demonstration("ticino_loose", "table", 0.5, 1, 23.0, true).unwrap();
        for setting in Setting::ALL {
            let most = setting.most();
            let up = plan.with_setting(setting, most).unwrap();
            let down = plan.with_setting(setting, 1.0 / most).unwrap();
            assert_ne!(up.plant().config(), plan.plant().config(), "{setting:?}");
            assert_ne!(up.plant().config(), down.plant().config(), "{setting:?}");
            assert_eq!(plan.with_setting(setting, 1.0).unwrap().plant().config(), plan.plant().config());
        }
    }
}
