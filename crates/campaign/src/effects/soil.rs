//! Effects on the soil's strength, by the catalogue's own laws.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use soilctl_earth_pressure::plane_model;
use soilctl_effects::{Active, Base, Covariate, DirectMechanics, EmpiricalTerm, Reference, Stroke, force_n};
use soilctl_plant::{Contact, SoilChange};

use super::place;
use crate::{CampaignError, Plan};

/// Changes of depth (m) and tool angle (rad) from which on the ratio is worked out again.
const STEP: [f64; 2] = [1e-4, 2e-3];

/// The share by which effects change the limit force.
pub(super) struct SoilEffects {
    active: Vec<Active>,
    terms: Vec<EmpiricalTerm>,
    reference: Reference,
    base: Base,
    mechanics: DirectMechanics,
    width_m: f64,
    batch: usize,
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
    /// Empirical terms, and no effect yet.
    pub(super) fn new(
        reference: &Reference,
        terms: &[EmpiricalTerm],
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
            terms: terms.to_vec(),
            reference: reference.clone(),
            base: Base {
                phi_deg: soil.phi_deg,
                delta_deg: soil.delta_deg,
                density_kg_m3: soil.density_kg_m3,
                gravity_m_s2: soil.gravity_m_s2,
            },
            mechanics: DirectMechanics::new(plane_model(&plan.file().model)?),
            width_m: plan.plant().arm().config().plate.width_m,
            batch,
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
        if (self.active.is_empty() && self.terms.is_empty()) || contact.depth_m < 1e-3 {
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

    /// Force with all effects and terms over that without. Where the catalogue has no answer, as at a depth that its force models
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
        let of_effects = match (force(&self.active), force(&[])) {
            (Ok(with), Ok(without)) => with / without,
            _ => 1.0,
        };
        let of_terms: f64 = self.terms.iter().map(|term| self.ln_factor(term, contact, &place)).sum();
        // Rounded, so that the last bits of a system's exponential do not matter.
        (of_effects * libm::exp(of_terms) * 1e9).round() * 1e-9
    }

    /// Change of ln force by a term where the plate is. Where no clock tells the time, strokes are taken to be evenly spread over that of the file.
    fn ln_factor(&self, term: &EmpiricalTerm, contact: &Contact, place: &place::Place) -> f64 {
        term.at_values(&|condition| match condition {
            Covariate::ToolAngle => Some(contact.tool_angle_rad.to_degrees()),
            Covariate::Depth => Some(contact.depth_m),
            Covariate::Width => Some(self.width_m),
            // Refused before: no stroke of a plan has a speed of its own.
            Covariate::Speed => None,
            Covariate::Radius => Some(place.radius_m),
            Covariate::BaseAngle => Some(place.base_deg),
            Covariate::PriorGap => place.gap_prior_m,
            Covariate::Wall => Some(contact.wall_m),
            Covariate::InterfaceSetPoint => Some(place.delta_set_deg),
            Covariate::Order => Some(place.order),
            Covariate::Time => {
                let (first, last) = self.reference.time_s?;
                Some(first + place.time_fraction * (last - first))
            }
            // As `process` names them.
            Covariate::Batch => self.reference.place_of(&self.batch.to_string()),
        })
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use std::path::Path;

    use super::*;

    const PLAN: &str = "version = 1\nsoil = \"ticino_loose\"\nmodel = \"chen\"\nseed = 1\n[[batches]]\nstrokes = [\n\
        { radius_m = 0.4, base_deg = -20.0, alpha_deg = 90.0, depth_m = 0.0254, delta_set_deg = 20.0 },\n\
        { radius_m = 0.3, base_deg = 20.0, alpha_deg = 80.0, depth_m = 0.0254, delta_set_deg = 22.0 },\n]\n";

    /// A term finds each of its conditions where the plate is, or where the plan has the stroke.
    #[test]
    fn a_term_knows_the_conditions_of_the_stroke_that_is_made() {
        let plan = Plan::from_toml(PLAN, "plan", Path::new(".")).unwrap();
        let reference = Reference {
            depth_m: 0.025,
            alpha_deg: 85.0,
            delta_set_deg: None,
            speed_mps: None,
            time_s: Some((100.0, 300.0)),
            base_deg: None,
            batches: vec!["0".to_owned()],
        };
        let contact = Contact {
            tick: 0,
            preparation: 0,
            tip_m: [0.3, 0.0, 0.0],
            depth_m: 0.02,
            heap_m: 0.0,
            tool_angle_rad: 80_f64.to_radians(),
            speed_m_s: 0.01,
            wall_m: 0.2,
        };
        for (over, value) in [
            (Covariate::ToolAngle, Some(80.0)),
            (Covariate::Depth, Some(0.02)),
            (Covariate::Width, Some(plan.plant().arm().config().plate.width_m)),
            (Covariate::Speed, None),
            (Covariate::Radius, Some(0.3)),
            (Covariate::BaseAngle, Some(20.0)),
            (Covariate::Wall, Some(0.2)),
            (Covariate::InterfaceSetPoint, Some(22.0)),
            (Covariate::Order, Some(2.0)),
            (Covariate::Time, Some(300.0)),
            (Covariate::Batch, Some(0.0)),
        ] {
            // Halfway between the ends of the term.
            let at = value.unwrap_or(0.0);
            let term = EmpiricalTerm {
                over: vec![over],
                at: vec![vec![at - 10.0, at + 10.0]],
                ln_force: vec![0.0, 0.2],
                sd: vec![0.0; 2],
                log_bayes_factor: 0.0,
            };
            let stroke = Arc::new(AtomicUsize::new(1));
            let mut effects = SoilEffects::new(&reference, &[term], &plan, 0, stroke).unwrap();
            let mut change = SoilChange::default();
            effects.change(&contact, &mut change);
            let expected = if value.is_some() { 0.1_f64.exp() } else { 1.0 };
            assert!((change.limit_force - expected).abs() < 1e-8, "{over}: {}", change.limit_force);
        }
    }
}
