//! A set of effects that was decided for elsewhere than in a fit.

use std::collections::BTreeMap;

use soilctl_effects::EffectId;

use crate::data::Data;

/// A set of effects that was decided for, effects that are as likely, and amplitudes that strokes no longer tell, with their standard deviations.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Decided {
    pub(crate) best: Vec<EffectId>,
    pub(crate) as_likely: Vec<EffectId>,
    pub(crate) held: BTreeMap<EffectId, (f64, f64)>,
}

impl Decided {
    pub(crate) fn has(&self, id: EffectId) -> bool {
        self.best.contains(&id) || self.as_likely.contains(&id)
    }
}

impl Data {
    /// Takes a set of effects as the best explanation, of which strokes tell the sizes only, with those that are as likely in the place of it.
    pub fn decide(&mut self, best: &[EffectId], as_likely: &[EffectId]) {
        self.decided =
            Some(Decided { best: best.to_vec(), as_likely: as_likely.to_vec(), held: BTreeMap::new() });
    }

    /// Takes the size of an effect that was decided for as a simulated arm tells it: amplitude and standard deviation in the unit of its parameter.
    /// Strokes tell the soil beside it. Without a decision it does nothing.
    pub fn hold(&mut self, id: EffectId, amplitude: f64, sd: f64) {
        if let Some(decided) = &mut self.decided {
            decided.held.insert(id, (amplitude, sd));
        }
    }

    /// Amplitude and standard deviation of an effect whose size is held.
    pub(crate) fn held(&self, id: EffectId) -> Option<(f64, f64)> {
        self.decided.as_ref()?.held.get(&id).copied()
    }
}
