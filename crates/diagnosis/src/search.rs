//! Which effects, alone and together, explain a campaign best.

use std::collections::{BTreeMap, BTreeSet};

use soilctl_effects::{Channel, EffectId};

use crate::DiagnosisError;
use crate::explanation::Dependence;
use crate::fit::{Fit, everything, fit};
use crate::generic::{Generic, rivals, shapes};
use crate::setup::FitSetup;
use crate::spec::{Choice, Spec};

/// ln prior of an effect showing, or not showing, in the channels that its amplitude fixes: ln 0.9 and ln 0.1. Empirical: with
/// 0.05 for the latter, false names below lambda 8 rose beyond their bar of 5 %.
pub(crate) const LN_LINKED: [f64; 2] = [-0.105, -2.303];
/// ln prior of channels responding, or not: ln 0.6 and ln 0.4. Empirical.
pub(crate) const LN_RESPONDS: [f64; 2] = [-0.511, -0.916];
/// Sets that are extended in each round. Empirical: the members of a pair are among the first four alone, or exchanged for them later.
const BEAM: usize = 4;
/// Most effects in a set: what 48 strokes tell apart.
const MOST_EFFECTS: usize = 3;
/// ln Bayes factor by which forces alone may speak against an effect on them. Empirical.
const DENIED: f64 = 1.0;
/// What an effect must earn in ln evidence to be believed: ln 28 = 3.3 are the odds against any one of the catalogue, the rest is a
/// margin. Empirical.
pub const THRESHOLD: f64 = 3.6;

/// A set of effects with its fit.
#[derive(Debug, Clone)]
pub(crate) struct Scored {
    pub(crate) spec: Spec,
    pub(crate) fit: Fit,
    /// ln Bayes factor over the baseline, averaged over signs and shapes.
    pub(crate) log_bayes: f64,
    /// ln Bayes factor of this very variant.
    pub(crate) gain: f64,
}

impl Scored {
    /// What is left after each effect has paid.
    pub(crate) fn score(&self) -> f64 {
        self.log_bayes - THRESHOLD * self.spec.choices.len() as f64
    }

    fn same_set(&self, other: &Self) -> bool {
        let set = |scored: &Self| scored.spec.ids().into_iter().collect::<BTreeSet<_>>();
        set(self) == set(other)
    }
}

/// A shape without a name with its gain in ln evidence.
#[derive(Debug, Clone)]
pub(crate) struct ScoredShape {
    pub(crate) over: Dependence,
    /// Its regressors of ln force.
    pub(crate) columns: Vec<Vec<f64>>,
    pub(crate) log_bayes: f64,
}

/// The evidence of a campaign without effects, and everything measured against it.
pub(crate) struct Search<'a> {
    pub(crate) setup: &'a FitSetup<'a>,
    pub(crate) baseline: Fit,
    core: BTreeSet<Channel>,
    channel_evidence: BTreeMap<Channel, f64>,
    include: Vec<bool>,
    pub(crate) shapes: Vec<Generic>,
}

impl<'a> Search<'a> {
    pub(crate) fn new(setup: &'a FitSetup<'a>) -> Result<Self, DiagnosisError> {
        Self::of_strokes(setup, everything(setup))
    }

    /// The same of the strokes that are included.
    pub(crate) fn of_strokes(setup: &'a FitSetup<'a>, include: Vec<bool>) -> Result<Self, DiagnosisError> {
        let core = setup.core();
        let failed = || DiagnosisError::NoFit {
            file: setup.data.name.clone(),
            model: "the baseline".into(),
            problem: "the search for friction angle and density found nothing finite".into(),
        };
        let baseline = fit(setup, &Spec::default(), &core, true, &include).ok_or_else(failed)?;
        let mut channel_evidence = BTreeMap::new();
        for &channel in setup.baselines.keys().filter(|c| !core.contains(c)) {
            let alone = fit(setup, &Spec::default(), &BTreeSet::from([channel]), false, &include)
                .ok_or_else(failed)?;
            channel_evidence.insert(channel, alone.log_evidence);
        }
        Ok(Self { setup, baseline, core, channel_evidence, include, shapes: shapes(setup.data) })
    }

    /// ln probability of everything that was read, without effects that are still to be found.
    pub(crate) fn log_evidence(&self) -> f64 {
        self.baseline.log_evidence + self.channel_evidence.values().sum::<f64>()
    }

    /// Fit and ln Bayes factor of one set over the baseline.
    pub(crate) fn evaluate(&self, spec: &Spec) -> Option<(Fit, f64)> {
        let touched = spec.touched(self.setup.data);
        let with_force = self.setup.needs_forces(spec);
        let mut channels = touched;
        let mut against = 0.0;
        if with_force {
            channels.extend(&self.core);
            against += self.baseline.log_evidence;
        }
        against += channels.iter().filter_map(|channel| self.channel_evidence.get(channel)).sum::<f64>();
        if !with_force && channels.is_empty() {
            return None;
        }
        let found = fit(self.setup, spec, &channels, with_force, &self.include)?;
        let gain = found.log_evidence - against;
        gain.is_finite().then_some((found, gain))
    }

    /// The best variant of a set with one more effect; `log_bayes` averages over the variants.
    pub(crate) fn add(&self, seed: Option<&Scored>, id: EffectId) -> Option<Scored> {
        let start = seed.map_or_else(Spec::default, |scored| scored.spec.clone());
        // What averaging over its own variants took from the seed, it takes from every set that is built on it.
        let paid = seed.map_or(0.0, |scored| scored.log_bayes - scored.gain);
        let mut best: Option<(f64, f64, Spec, Fit)> = None;
        let mut terms = Vec::new();
        for (choice, ln_prior) in self.variants(id) {
            let spec = start.with(choice);
            let Some((found, gain)) = self.evaluate(&spec) else { continue };
            let weighted = gain + ln_prior + paid;
            terms.push(weighted);
            if best.as_ref().is_none_or(|(most, ..)| weighted > *most) {
                best = Some((weighted, gain, spec, found));
            }
        }
        let (most, gain, spec, fit) = best?;
        if gain > seed.map_or(0.0, |scored| scored.gain) + 0.5 * THRESHOLD
            && self.denied_by_forces(&start, &spec)
        {
            return None;
        }
        let log_bayes = most + terms.iter().map(|t| (t - most).exp()).sum::<f64>().ln();
        Some(Scored { spec, fit, log_bayes, gain })
    }

    /// Whether the last effect of a set changes forces, but the forces by themselves speak against it: then readings of
    /// traces, whose baselines are less well known, do not make it.
    fn denied_by_forces(&self, start: &Spec, spec: &Spec) -> bool {
        let Some(last) = spec.choices.last().filter(|choice| choice.effect.acts_on_force()) else {
            return false;
        };
        // What a simulated arm showed of the forces is part of what it showed of the columns.
        if last.learnt || !(last.linked || last.responds) {
            return false;
        }
        let forces = |spec: &Spec| -> Option<f64> {
            let choices = spec.choices.iter().filter(|choice| choice.effect.acts_on_force());
            let bare = choices.map(|choice| Choice { linked: false, responds: false, ..*choice }).collect();
            self.evaluate(&Spec { choices: bare, ..Spec::default() }).map(|(_, gain)| gain)
        };
        matches!((forces(start), forces(spec)), (Some(before), Some(after)) if after < before - DENIED)
    }

    fn variants(&self, id: EffectId) -> Vec<(Choice, f64)> {
        let (data, effect) = (self.setup.data, id.effect());
        let present = |channel: &Channel| data.channels.contains_key(channel);
        if let Some(learnt) = data.learnt.get(&id) {
            let signs: Vec<f64> =
                effect.range.signs().iter().copied().filter(|sign| learnt.has_sign(*sign)).collect();
            // What a controller leaves visible.
            let shape = effect.simulated_shape();
            let choice = |sign| Choice { effect, sign, shape, linked: true, responds: false, learnt: true };
            let even = -(signs.len() as f64).ln();
            return signs.into_iter().map(|sign| (choice(sign), even)).collect();
        }
        let told = |shape: &f64| effect.needs(*shape).is_none_or(|channel| present(&channel));
        let shapes: Vec<f64> = effect.shapes().iter().copied().filter(told).collect();
        let signs = effect.range.signs();
        let linked: &[(bool, f64)] = if !effect.linked.iter().any(present) {
            &[(false, 0.0)]
        } else if effect.acts_on_force() {
            &[(true, LN_LINKED[0]), (false, LN_LINKED[1])]
        } else {
            &[(true, 0.0)]
        };
        let responds: &[(bool, f64)] = if effect.responses.iter().any(|r| present(&r.channel)) {
            &[(true, LN_RESPONDS[0]), (false, LN_RESPONDS[1])]
        } else {
            &[(false, 0.0)]
        };
        let even = -((shapes.len() * signs.len()) as f64).ln();
        let mut variants = Vec::new();
        for &shape in &shapes {
            for &sign in signs {
                for &(linked, a) in linked {
                    // What the amplitude fixes and a reading denies is not saved by readings of any strength.
                    let denied = !linked && effect.linked.iter().any(present);
                    for &(responds, b) in responds.iter().filter(|(responds, _)| !(denied && *responds)) {
                        let choice = Choice { effect, sign, shape, linked, responds, learnt: false };
                        variants.push((choice, even + a + b));
                    }
                }
            }
        }
        variants
    }

    /// A set of effects, put together one by one; `None` if one of them has no answer.
    pub(crate) fn together(&self, ids: &[EffectId]) -> Option<Scored> {
        ids.iter().try_fold(None, |seed: Option<Scored>, id| self.add(seed.as_ref(), *id).map(Some))?
    }

    /// Every effect alone, best first.
    pub(crate) fn singles(&self) -> Vec<Scored> {
        let mut found: Vec<Scored> =
            self.setup.data.candidates().filter_map(|id| self.add(None, id)).collect();
        sort(&mut found);
        found
    }

    /// Sets of growing size, best first within each size; the first entry holds the single effects.
    pub(crate) fn sets(&self) -> Vec<Vec<Scored>> {
        let mut sizes = vec![self.singles()];
        while sizes.len() < MOST_EFFECTS {
            let last = &sizes[sizes.len() - 1];
            let Some(best) = last.first() else { break };
            // Another effect is only looked for if what is there is worth extending.
            let before = if sizes.len() == 1 { 0.0 } else { sizes[sizes.len() - 2][0].log_bayes };
            if best.log_bayes < before + 0.5 * THRESHOLD {
                break;
            }
            let mut next: Vec<Scored> = Vec::new();
            for seed in last.iter().take(if sizes.len() == 1 { BEAM } else { 2 }) {
                self.extend(seed, &mut next);
            }
            sort(&mut next);
            // The members of the best set are seeds too, so that each of them can be exchanged for anything.
            if let (1, Some(best)) = (sizes.len(), next.first().cloned()) {
                for id in best.spec.ids() {
                    let seed = last.iter().skip(BEAM).find(|single| single.spec.ids() == [id]);
                    if let Some(seed) = seed {
                        self.extend(seed, &mut next);
                    }
                }
                sort(&mut next);
            }
            sizes.push(next);
        }
        sizes
    }

    fn extend(&self, seed: &Scored, next: &mut Vec<Scored>) {
        let known = seed.spec.ids();
        for id in self.setup.data.candidates().filter(|id| !known.contains(id)) {
            let Some(found) = self.add(Some(seed), id) else { continue };
            match next.iter_mut().find(|other| other.same_set(&found)) {
                Some(other) if other.log_bayes < found.log_bayes => *other = found,
                Some(_) => {}
                None => next.push(found),
            }
        }
    }

    /// Whether a column that an effect of the set would shift is there and does not show it.
    pub(crate) fn is_denied_by_a_reading(&self, spec: &Spec) -> bool {
        let read = |channel: &Channel| self.setup.data.channels.contains_key(channel);
        spec.choices.iter().any(|choice| !choice.linked && choice.effect.linked.iter().any(read))
    }

    /// ln Bayes factor of a set that may also shift all forces by a constant.
    pub(crate) fn at_any_level(&self, of: &Scored) -> f64 {
        let level = vec![1.0; self.setup.data.len()];
        let spec = Spec { generic: vec![level], ..of.spec.clone() };
        self.evaluate(&spec).map_or(f64::NEG_INFINITY, |(_, gain)| gain)
    }

    /// The shape over the condition of one of a set's effects that explains more in its place, averaged over such shapes; with its
    /// ln Bayes factor.
    pub(crate) fn shape_instead(&self, of: &Scored) -> Option<(Dependence, f64)> {
        let choices = &of.spec.choices;
        let paid = of.log_bayes - of.gain;
        let mut best: Option<(Dependence, f64)> = None;
        for (k, out) in choices.iter().enumerate() {
            let mut spec = of.spec.clone();
            spec.choices.remove(k);
            let found: Vec<(Dependence, f64)> = rivals(self.setup.data, out.effect)
                .into_iter()
                .filter_map(|shape| {
                    spec.generic = shape.columns;
                    self.evaluate(&spec).map(|(_, gain)| (shape.over, gain + paid))
                })
                .collect();
            let Some(&(over, most)) = found.iter().max_by(|a, b| a.1.total_cmp(&b.1)) else { continue };
            let mean = found.iter().map(|(_, gain)| (gain - most).exp()).sum::<f64>() / found.len() as f64;
            let averaged = most + mean.ln();
            if averaged > best.as_ref().map_or(of.log_bayes, |(_, known)| *known) {
                best = Some((over, averaged));
            }
        }
        best
    }

    /// Shapes without a name, added to a set of effects, best first.
    pub(crate) fn shapes_on(&self, seed: Option<&Scored>) -> Vec<ScoredShape> {
        let start = seed.map_or_else(Spec::default, |scored| scored.spec.clone());
        let before = seed.map_or(0.0, |scored| scored.gain);
        let mut found: Vec<ScoredShape> = self
            .shapes
            .iter()
            .filter_map(|shape| {
                let spec = Spec { generic: shape.columns.clone(), ..start.clone() };
                let (_, gain) = self.evaluate(&spec)?;
                Some(ScoredShape {
                    over: shape.over,
                    columns: shape.columns.clone(),
                    log_bayes: gain - before,
                })
            })
            .collect();
        found.sort_by(|a, b| b.log_bayes.total_cmp(&a.log_bayes));
        found
    }
}

fn sort(found: &mut [Scored]) {
    found.sort_by(|a, b| b.log_bayes.total_cmp(&a.log_bayes));
}
