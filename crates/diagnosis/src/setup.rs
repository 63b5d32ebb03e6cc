//! Everything a fit needs that does not change from one candidate to the next.

use std::collections::{BTreeMap, BTreeSet};

use soilctl_effects::{
    ALTERNATIVE_MODELS, Active, Base, Channel, Effect, EffectId, Mechanics, Range, force_n,
};

use crate::channels::Baseline;
use crate::correlation::Correlation;
use crate::data::{Data, Prior};
use crate::generic::indicator;
use crate::learnt::Learnt;
use crate::spec::{Choice, Spec};
use crate::surface::Surface;

/// How far a force model may be mixed into the one in use without being an effect: standard deviation of the share.
/// Coulomb's plane wedge is known to be far off at high interface friction (by up to 30 %), so it is believed least.
/// Empirical: with them, no effect is named in 120 hidden campaigns without one, half of which another model made.
const ALTERNATIVE_SD: [f64; 4] = [0.1, 0.5, 0.3, 0.5];
/// Least error of a force model between tool angles, as a standard deviation of ln force. Empirical: models with a bracket have 0.5 to 2 %.
const LEAST_MODEL_ERROR: f64 = 0.007;
/// Least scatter between batches, as a standard deviation of ln force: nobody prepares sand better than to 1 %.
const LEAST_BATCH_SCATTER: f64 = 0.01;

/// Standard deviation of how far a setting of the twin is off, over the most that it may be: as if anything up to that were as likely.
pub(crate) const SETTING_SD: f64 = 0.577;

/// Standard deviation in deg of the interface friction that a soil has of its own beside an offset of it that a simulated arm showed: none to speak of.
const OWN_DELTA_SD: f64 = 0.01;

/// Data, model and nuisance of a campaign.
#[derive(Clone)]
pub(crate) struct FitSetup<'a> {
    pub(crate) data: &'a Data,
    pub(crate) surface: &'a Surface,
    pub(crate) baselines: BTreeMap<Channel, Baseline>,
    /// Regressors of ln force with the standard deviation of their coefficients: batches, tool angles, models.
    pub(crate) nuisance: Vec<(Vec<f64>, f64)>,
    /// How many of the nuisance regressors, from the first, are batches.
    pub(crate) batch_terms: usize,
    /// Standard deviation of ln force between batches.
    pub(crate) batch_sd: f64,
    /// Whether forces are those of a simulated arm, as far as one was asked, and not those of a model file.
    compares_signals: bool,
    /// Amplitudes of `side_effects_3d`: at most what the force model proves that ends add, if it does.
    ends: Range,
}

impl<'a> FitSetup<'a> {
    /// Prepares a campaign; model errors are taken at `phi_deg`.
    pub(crate) fn new(data: &'a Data, surface: &'a Surface, phi_deg: f64) -> Self {
        let baselines = data.channels.keys().map(|&channel| (channel, Baseline::of(channel, data))).collect();
        let n = data.len();
        let batch_sd = data.campaign.density_sd_rel.max(LEAST_BATCH_SCATTER);
        let mut nuisance = Vec::new();
        let batch_terms = if data.batches > 1 { data.batches } else { 0 };
        for batch in 0..batch_terms {
            nuisance.push((indicator(&data.batch, batch), batch_sd));
        }
        for (level, &alpha) in data.levels_deg.iter().enumerate() {
            if data.levels_deg.len() > 1 && data.levels_deg.len() < n {
                let mean = data.delta_set_deg(0);
                let sd = surface.half_width(alpha, phi_deg, mean).max(LEAST_MODEL_ERROR);
                nuisance.push((indicator(&data.level, level), sd));
            }
        }
        for (which, &sd) in ALTERNATIVE_SD.iter().enumerate().take(ALTERNATIVE_MODELS.len()) {
            let direction: Result<Vec<f64>, _> = (0..n)
                .map(|i| {
                    surface.ln_alternative(which, data.rows[i].alpha_deg, phi_deg, data.delta_set_deg(i))
                })
                .collect();
            if let Ok(direction) = direction {
                let mean = direction.iter().sum::<f64>() / n as f64;
                if direction.iter().any(|x| (x - mean).abs() > 1e-3) {
                    nuisance.push((direction.iter().map(|x| x - mean).collect(), sd));
                }
            }
        }
        let ends = ends_at_most(data, surface, phi_deg);
        Self { data, surface, baselines, nuisance, batch_terms, batch_sd, compares_signals: true, ends }
    }

    /// Interface friction minus its set-point, deg, before the strokes are looked at. It is the same thing as an offset of the interface friction: strokes tell the
    /// sum, and where a simulated arm showed what an offset does, beyond what a formula knows of the soil's own, all of it is the effect.
    pub(crate) fn delta(&self, spec: &Spec) -> Prior {
        let is_offset = |c: &Choice| c.learnt && c.effect.id == EffectId::InterfaceFrictionOffset;
        match spec.choices.iter().any(is_offset) {
            true => Prior { mean: 0.0, sd: OWN_DELTA_SD },
            false => self.data.delta,
        }
    }

    /// Plausible amplitudes of an effect in this campaign.
    pub(crate) fn range(&self, effect: &Effect) -> Range {
        if effect.id == EffectId::SideEffects3d { self.ends } else { effect.range }
    }

    /// ln force of a stroke, with `effects`, for a friction angle (deg), an offset of the interface friction (deg) and ln of the
    /// density over its prior mean. `None` where the model has no answer.
    pub(crate) fn ln_force(&self, stroke: usize, soil: [f64; 3], effects: &[Active]) -> Option<f64> {
        let data = self.data;
        let base = Base {
            phi_deg: soil[0],
            delta_deg: (data.delta_set_deg(stroke) + soil[1]).max(0.0),
            density_kg_m3: data.density.mean * soil[2].exp(),
            gravity_m_s2: data.gravity_m_s2,
        };
        let learnt = |active: &Active| data.learnt.get(&active.effect.id).filter(|_| self.compares_signals);
        let by_formula: Vec<Active> =
            effects.iter().filter(|active| learnt(active).is_none()).copied().collect();
        let shown = effects
            .iter()
            .filter_map(|active| Some(learnt(active)?.ln_force(stroke, active.amplitude)))
            .sum::<f64>();
        let scene = data.scene.as_ref().filter(|_| self.compares_signals).map_or(0.0, |scene| scene[stroke]);
        let plain = force_n(self.surface, &data.strokes[stroke], &data.reference, &base, &by_formula).ok()?;
        Some(plain.ln() + data.known_ln[stroke] + shown + scene)
    }

    /// What is known and `more`.
    pub(crate) fn known_and(&self, more: impl IntoIterator<Item = Active>) -> Vec<Active> {
        self.data.known.iter().map(|known| known.active).chain(more).collect()
    }

    /// Channels that every fit of forces has: those that read the interface friction, those that share with the forces what the twin may be
    /// off by, and those that vary together.
    pub(crate) fn core(&self) -> BTreeSet<Channel> {
        let shared =
            |channel: &Channel| self.twin().iter().any(|setting| setting.channels().contains(channel));
        let varies = |channel: &Channel| self.correlation().is_some_and(|of| of.has(*channel));
        self.baselines
            .iter()
            .filter(|(channel, baseline)| baseline.reads_delta || shared(channel) || varies(channel))
            .map(|(channel, _)| *channel)
            .collect()
    }

    /// How strokes respond to settings in which the simulated arm may be off.
    pub(crate) fn twin(&self) -> &'a [Learnt] {
        if self.compares_signals { &self.data.twin } else { &[] }
    }

    /// How the readings of one stroke vary together.
    pub(crate) fn correlation(&self) -> Option<&'a Correlation> {
        self.data.correlation.as_ref().filter(|_| self.compares_signals)
    }

    /// Variance that a row has since strokes of the simulated arm go another way for reasons of their own: of ln force, or of a column.
    pub(crate) fn unsteadiness(&self, channel: Option<Channel>, stroke: usize) -> f64 {
        if self.compares_signals { self.data.unsteadiness.variance(channel, stroke) } else { 0.0 }
    }

    /// Whether the forces take part in the fit of a set of effects.
    pub(crate) fn needs_forces(&self, spec: &Spec) -> bool {
        spec.on_force() || !self.twin().is_empty() || self.correlation().is_some()
    }

    /// The same campaign with batches as the only nuisance, for predictions that a model file can repeat.
    pub(crate) fn without_model_error(&self) -> Self {
        let nuisance = self.nuisance[..self.batch_terms].to_vec();
        Self { nuisance, compares_signals: false, ..self.clone() }
    }
}

/// Amplitudes of `side_effects_3d` that the catalogue and the force model both have; where they share none, those of the catalogue.
fn ends_at_most(data: &Data, surface: &Surface, phi_deg: f64) -> Range {
    let range = EffectId::SideEffects3d.effect().range;
    let delta = data.delta_set_deg(0);
    let at = data.levels_deg.iter().map(|&alpha| surface.most_of_ends(alpha, phi_deg, delta));
    match at.collect::<Option<Vec<f64>>>().and_then(|most| most.into_iter().reduce(f64::max)) {
        Some(most) if most > range.low => Range { high: most.min(range.high), ..range },
        _ => range,
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "helpers of tests")]

    use soilctl_earth_pressure::model;
    use soilctl_strokes::{Campaign, StrokeRow};

    use super::*;

    /// An offset of the interface friction that a simulated arm showed is all that differs from the set-point; beside one by a formula the soil has its own.
    #[test]
    fn an_offset_that_was_shown_is_all_of_it() {
        let row =
            StrokeRow { alpha_deg: 90.0, depth_m: 0.01, width_m: 0.05, force_n: 5.0, ..StrokeRow::default() };
        let data = Data::new("test", vec![row], Campaign::default()).unwrap();
        let surface = Surface::new(model("chen").unwrap(), (90.0, 90.0)).unwrap();
        let setup = FitSetup::new(&data, &surface, 35.0);
        let delta = |id: EffectId, learnt: bool| {
            let choice =
                Choice { effect: id.effect(), sign: 1.0, shape: 0.0, linked: true, responds: false, learnt };
            setup.delta(&Spec::default().with(choice))
        };
        let offset = EffectId::InterfaceFrictionOffset;
        assert_eq!([delta(offset, false), delta(EffectId::FtCrosstalk, true)], [data.delta; 2]);
        assert_eq!(delta(offset, true), Prior { mean: 0.0, sd: OWN_DELTA_SD });
    }

    /// By the mechanism of blocks alone, computed without the table, ends add 4.0 of 4.3 at most at phi 30 and delta 15 deg.
    #[test]
    fn ends_add_no_more_than_the_force_model_proves() {
        let row = StrokeRow {
            alpha_deg: 90.0,
            depth_m: 0.01,
            width_m: 0.05,
            force_n: 5.0,
            delta_set_deg: Some(15.0),
            ..StrokeRow::default()
        };
        let data = Data::new("test", vec![row], Campaign::default()).unwrap();
        let high = |id: &str, phi: f64| {
            let surface = Surface::new(model(id).unwrap(), (90.0, 90.0)).unwrap();
            let setup = FitSetup::new(&data, &surface, phi);
            (setup.range(EffectId::SideEffects3d.effect()), setup.range(EffectId::Cohesion.effect()))
        };
        let catalogue = EffectId::SideEffects3d.effect().range;
        assert_eq!(high("chen", 30.0), (catalogue, EffectId::Cohesion.effect().range));
        let (ends, cohesion) = high("table", 30.0);
        assert_eq!((ends.low, cohesion), (catalogue.low, EffectId::Cohesion.effect().range));
        assert!((ends.high - 4.0 / 4.31).abs() < 0.05, "{ends:?}");
        assert!(high("table", 40.0).0.high > ends.high);
    }
}
