//! What a fit adds to the baseline.

use std::collections::BTreeSet;

use soilctl_effects::{Active, Channel, Effect, EffectId};

use crate::data::Data;
use crate::learnt::Learnt;

/// One effect with everything but the size of its amplitude.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Choice {
    pub(crate) effect: &'static Effect,
    pub(crate) sign: f64,
    pub(crate) shape: f64,
    /// Whether channels that its amplitude fixes are believed to show it.
    pub(crate) linked: bool,
    /// Whether channels respond with a strength of their own.
    pub(crate) responds: bool,
    /// Whether forces and channels respond as a simulated arm showed it.
    pub(crate) learnt: bool,
}

impl Choice {
    /// What its amplitude makes of a column of a stroke; 0 of a column that does not show it.
    pub(crate) fn shift(&self, data: &Data, channel: Channel, stroke: usize, active: &Active) -> f64 {
        if self.learnt {
            let learnt = data.learnt.get(&self.effect.id);
            learnt.map_or(0.0, |learnt| learnt.shift(channel, stroke, active.amplitude))
        } else if self.linked && self.effect.linked.contains(&channel) {
            self.effect.shift(channel, active.amplitude, active.shape, &data.reading(stroke))
        } else {
            0.0
        }
    }
}

/// Effects and shapes without a name.
#[derive(Debug, Clone, Default)]
pub(crate) struct Spec {
    pub(crate) choices: Vec<Choice>,
    /// Regressors of ln force, of unit root mean square.
    pub(crate) generic: Vec<Vec<f64>>,
    /// Amplitudes that are kept as they are, by choice; empty if they are fitted.
    pub(crate) fixed: Vec<f64>,
}

impl Spec {
    pub(crate) fn with(&self, choice: Choice) -> Self {
        let mut more = self.clone();
        more.choices.push(choice);
        more
    }

    /// Its effects, in the order in which they were added.
    pub(crate) fn ids(&self) -> Vec<EffectId> {
        self.choices.iter().map(|choice| choice.effect.id).collect()
    }

    /// Channels whose expectation the choices change.
    pub(crate) fn touched(&self, data: &Data) -> BTreeSet<Channel> {
        let mut touched = BTreeSet::new();
        for choice in &self.choices {
            if choice.learnt {
                touched.extend(data.learnt.get(&choice.effect.id).into_iter().flat_map(Learnt::channels));
            } else if choice.linked {
                touched.extend(choice.effect.linked);
            }
            if choice.responds {
                touched.extend(choice.effect.responses.iter().map(|response| response.channel));
            }
        }
        touched.retain(|channel| data.channels.contains_key(channel));
        touched
    }

    /// Whether forces are part of the fit: always but for effects that only channels show.
    pub(crate) fn on_force(&self) -> bool {
        self.choices.is_empty()
            || !self.generic.is_empty()
            || self.choices.iter().any(|c| c.learnt || c.effect.acts_on_force())
    }
}
