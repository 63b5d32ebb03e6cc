//! Strokes of a simulated arm that go another way for reasons of their own.

use std::collections::BTreeMap;

use soilctl_effects::Channel;

use crate::transfer::Node;

/// By how much strokes of the simulated arm go another way for reasons of their own: one that is on the brink of sinking does so with one setting and
/// not with the next. Sums of squares over settings, by stroke of the campaign.
#[derive(Debug, Clone, Default)]
pub(crate) struct Unsteadiness {
    settings: usize,
    ln_force: Vec<f64>,
    channels: BTreeMap<Channel, Vec<f64>>,
    /// Further variance of a signal, by stroke.
    further: BTreeMap<(Option<Channel>, usize), f64>,
}

impl Unsteadiness {
    /// Part of the mean square of `(up + down) / 2 - plain` that is the variance of a difference of two strokes, if all three scatter by the same.
    const OF_A_DIFFERENCE: f64 = 2.0 / 1.5;

    /// Takes what a setting did alike, up and down.
    pub(crate) fn add(&mut self, alike: &Node) {
        let add = |sums: &mut Vec<f64>, values: &[f64]| {
            sums.resize(values.len(), 0.0);
            sums.iter_mut().zip(values).for_each(|(sum, value)| *sum += value * value);
        };
        self.settings += 1;
        add(&mut self.ln_force, &alike.ln_force);
        for (channel, values) in &alike.channels {
            add(self.channels.entry(*channel).or_default(), values);
        }
    }

    /// Variance of a stroke over the same one, simulated: of ln force (`None`), or of a column.
    pub(crate) fn variance(&self, channel: Option<Channel>, stroke: usize) -> f64 {
        let sum = self.sums(channel).get(stroke).copied().unwrap_or_default();
        let further = self.further.get(&(channel, stroke)).copied().unwrap_or_default();
        Self::OF_A_DIFFERENCE * sum / self.settings.max(1) as f64 + further
    }

    /// Takes a stroke to scatter by a further variance: of ln force (`None`), or of a column.
    pub(crate) fn widen(&mut self, channel: Option<Channel>, stroke: usize, variance: f64) {
        *self.further.entry((channel, stroke)).or_default() += variance;
    }

    /// Its mean over the strokes.
    pub(crate) fn mean_variance(&self, channel: Option<Channel>) -> f64 {
        let strokes = self.sums(channel).len();
        (0..strokes).map(|stroke| self.variance(channel, stroke)).sum::<f64>() / strokes.max(1) as f64
    }

    fn sums(&self, channel: Option<Channel>) -> &[f64] {
        match channel {
            None => &self.ln_force,
            Some(channel) => self.channels.get(&channel).map_or(&[], Vec::as_slice),
        }
    }
}
