//! Effects on the soil's strength, by the catalogue's own laws.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use soilctl_earth_pressure::plane_model;
use soilctl_effects::{Active, Base, DirectMechanics, Reference, Stroke, force_n};
use soilctl_plant::{Contact, SoilChange};

use super::place;
use crate::{CampaignError, Plan};

/// Changes of depth (m) and tool angle (rad) from which on the ratio is worked out again.
const STEP: [f64; 2] = [1e-4, 2e-3];

/// The share by which effects change the limit force.
pub(super) struct SoilEffects {
    active: Vec<Active>,
    reference: Reference,
    base: Base,
    mechanics: DirectMechanics,
    width_m: f64,
    batch_fraction: f64,
    places: Vec<place::Place>,
    stroke: Arc<AtomicUsize>,
    /// Way to failure that goes with a gradual failure.
    slower: bool,
    last: Option<Last>,
}

/// The last ratio and where it holds.
#[derive(Clone, Copy)]
struct Last {
    stroke: usize,
    at: [f64; 2],
    ratio: f64,
}

impl SoilEffects {
    /// No effect yet.
    pub(super) fn new(
        reference: &Reference,
        plan: &Plan,
        batch: usize,
        stroke: Arc<AtomicUsize>,
    ) -> Result<Self, CampaignError> {
        let soil = plan.soil();
        let last = plan.batches().saturating_sub(1).max(1);
        #[allow(clippy::cast_precision_loss, reason = "at most 1024 batches")]
        let batch_fraction = batch as f64 / last as f64;
        Ok(Self {
            slower: false,
            active: Vec::new(),
            reference: reference.clone(),
            base: Base {
                phi_deg: soil.phi_deg,
                delta_deg: soil.delta_deg,
                density_kg_m3: soil.density_kg_m3,
                gravity_m_s2: soil.gravity_m_s2,
            },
            mechanics: DirectMechanics::new(plane_model(&plan.file().model)?),
            width_m: plan.plant().arm().config().plate.width_m,
            batch_fraction,
            places: place::places(plan),
            stroke,
            last: None,
        })
    }

    /// One more effect; `slower` if failure is more gradual with it.
    pub(super) fn add(&mut self, effect: Active, slower: bool) {
        self.active.push(effect);
        self.slower |= slower;
    }

    pub(super) fn change(&mut self, contact: &Contact, change: &mut SoilChange) {
        if self.active.is_empty() || contact.depth_m < 1e-3 {
            return;
        }
        let stroke = self.stroke.load(Ordering::Relaxed);
        let at = [contact.depth_m, contact.tool_angle_rad];
        let near =
            |last: &Last| last.stroke == stroke && (0..2).all(|i| (last.at[i] - at[i]).abs() < STEP[i]);
        let ratio = match self.last.filter(near) {
            Some(last) => last.ratio,
            None => {
                let ratio = self.ratio(contact, stroke);
                self.last = Some(Last { stroke, at, ratio });
                ratio
            }
        };
        change.limit_force *= ratio;
        if self.slower {
            change.mobilisation_way *= 1.0 / ratio.max(0.1);
        }
    }

    /// Force with all effects over that without. Where the catalogue has no answer, as at a depth that its force models
    /// do not know, the soil is as without effects.
    fn ratio(&self, contact: &Contact, number: usize) -> f64 {
        let place = self.places.get(number).copied().unwrap_or_default();
        let stroke = Stroke {
            alpha_deg: contact.tool_angle_rad.to_degrees(),
            depth_m: contact.depth_m,
            width_m: self.width_m,
            delta_set_deg: None,
            ln_speed: None,
            radius_position: Some(place.radius_position),
            base_deg: Some(place.base_deg),
            base_position: Some(place.base_position),
            gap_prior_m: place.gap_prior_m,
            wall_m: Some(contact.wall_m),
            time_fraction: Some(place.time_fraction),
            batch_fraction: Some(self.batch_fraction),
        };
        let force =
            |effects: &[Active]| force_n(&self.mechanics, &stroke, &self.reference, &self.base, effects);
        match (force(&self.active), force(&[])) {
            // Rounded, so that the last bits of a system's exponential do not matter.
            (Ok(with), Ok(without)) => (with / without * 1e9).round() * 1e-9,
            _ => 1.0,
        }
    }
}
