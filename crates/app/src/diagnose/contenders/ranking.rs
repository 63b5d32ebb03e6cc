//! How contenders are ranked: by the readings that all of them say what to expect of.

use soilctl_diagnosis::{Data, Fitted, FoundEffect, Readings};
use soilctl_effects::EffectId;

use super::{MATTERS, Weights};
use crate::AppError;

/// Strokes by which contenders are weighed: whole batches with so many or a few more, since each contender is simulated. Empirical: contests
/// of campaigns of 24 strokes decide.
pub(super) const STROKES: usize = 20;

/// The part of a campaign by which contenders are weighed.
pub(super) struct Part {
    /// Its batches; all if `None`.
    pub(super) batches: Option<Vec<usize>>,
    pub(super) strokes: Vec<bool>,
}

impl Part {
    pub(super) fn of(data: &Data) -> Self {
        let batches = data.sample(STROKES);
        let strokes = batches.as_ref().map_or_else(|| vec![true; data.len()], |of| data.of_batches(of));
        Self { batches, strokes }
    }

    /// Whether less than half of its strokes takes part.
    pub(super) fn is_little(&self, strokes: &[bool]) -> bool {
        2 * taking_part(strokes) < taking_part(&self.strokes)
    }
}

/// A set of effects, and the readings beside the simulated arm that has them.
pub(super) struct Contender {
    pub(super) ids: Vec<EffectId>,
    /// Their sizes on that arm.
    pub(super) effects: Vec<FoundEffect>,
    /// Whether these are others than strokes tell beside responses.
    pub(super) is_off: bool,
    /// Sizes and soil for which readings ask beside that arm, where it was learnt how strokes respond.
    pub(super) nearer: Option<Fitted>,
    pub(super) beside: Data,
    /// ln evidence of what all contenders expect, over that of the better arm without effects, once it is weighed.
    pub(super) adds: f64,
    pub(super) is_weighed: bool,
}

impl Contender {
    /// Its effects, if strokes do not tell their sizes.
    pub(super) fn held(&self) -> &[FoundEffect] {
        if self.is_off { &self.effects } else { &[] }
    }

    /// Sizes that are told beside it, or else its own, if strokes do not tell these.
    pub(super) fn told(&self) -> &[FoundEffect] {
        self.nearer.as_ref().map_or(self.held(), |nearer| &nearer.effects)
    }

    /// What readings ask for beside it, if a size differs by enough to matter.
    pub(super) fn at_other_sizes(&self) -> Option<Fitted> {
        let nearer = self.nearer.as_ref()?;
        let differs = |of: &FoundEffect| {
            let same = nearer.effects.iter().filter(|other| other.id == of.id);
            same.map(|other| (other.amplitude - of.amplitude).abs()).any(|by| by > MATTERS * of.amplitude_sd)
        };
        self.effects.iter().any(differs).then(|| nearer.clone())
    }
}

/// The readings of which all contenders, and the arms without effects, say what to expect; `None` if too few strokes are left. Strokes on the brink may
/// fail the soil on one arm and sink on the other: that says little of either.
fn shared(plain: &[Data], contenders: &[Contender], part: &Part) -> Option<Readings> {
    let all = plain.iter().chain(contenders.iter().map(|of| &of.beside)).map(Data::readings);
    let shared = all.reduce(|mut shared, of| {
        shared.keep(&of);
        shared
    })?;
    (!part.is_little(&shared.strokes)).then_some(shared)
}

/// Takes a further contender in; `false` if its arm leaves too few strokes to weigh it with the others, and then it is none of them.
pub(super) fn join(plain: &[Data], contenders: &mut Vec<Contender>, further: Contender, part: &Part) -> bool {
    contenders.push(further);
    let joins = shared(plain, contenders, part).is_some();
    if !joins {
        contenders.pop();
    }
    joins
}

/// Weighs the readings that all contenders share, most evidence first; `false` if these are too few, and then nothing is weighed.
/// `before` is what a ranking before this one weighed and ln evidence of the better arm without effects, which stay as they are where it
/// is the same readings.
pub(super) fn rank(
    plain: &[Data],
    contenders: &mut [Contender],
    part: &Part,
    weights: &Weights<'_>,
    before: &mut Option<(Readings, f64)>,
) -> Result<bool, AppError> {
    let Some(shared) = shared(plain, contenders, part) else { return Ok(false) };
    let without = match before.take().filter(|(readings, _)| *readings == shared) {
        Some((_, without)) => without,
        None => {
            let mut most = f64::NEG_INFINITY;
            for of in plain {
                most = most.max((weights.log_evidence)(of, &shared)?);
            }
            contenders.iter_mut().for_each(|of| of.is_weighed = false);
            most
        }
    };
    for of in contenders.iter_mut().filter(|of| !of.is_weighed) {
        (of.adds, of.is_weighed) = ((weights.log_evidence)(&of.beside, &shared)? - without, true);
    }
    *before = Some((shared, without));
    contenders.sort_by(|a, b| b.adds.total_cmp(&a.adds));
    Ok(true)
}

pub(super) fn taking_part(strokes: &[bool]) -> usize {
    strokes.iter().filter(|takes_part| **takes_part).count()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use std::cell::RefCell;

    use soilctl_diagnosis::FittedSoil;
    use soilctl_effects::Channel;
    use soilctl_strokes::{Campaign, StrokeRow};

    use super::*;

    /// A campaign of two strokes at each of two tool angles, beside an arm that read these columns of those that did not sink on it.
    fn beside(z_drift_m: Option<f64>, post_slope_norm: Option<f64>, sinks: &str) -> Data {
        let row = |name: &str, z_drift_m, post_slope_norm| StrokeRow {
            stroke_id: Some(name.to_owned()),
            alpha_deg: if "ab".contains(name) { 90.0 } else { 80.0 },
            depth_m: 0.025,
            width_m: 0.1,
            force_n: 5.0,
            z_drift_m,
            post_slope_norm,
            ..StrokeRow::default()
        };
        let of = |rows| Data::new("t", rows, Campaign::default()).unwrap();
        let names = ["a", "b", "c", "d"];
        let mut data = of(names.map(|name| row(name, Some(1e-3), Some(0.2))).to_vec());
        let made = names.into_iter().filter(|name| !sinks.contains(name));
        let simulated = made.map(|name| row(name, z_drift_m, post_slope_norm)).collect();
        data.expect(&of(simulated), false, 0.0);
        data
    }

    fn contender(ids: &[EffectId], adds: f64, beside: Data) -> Contender {
        Contender {
            ids: ids.to_vec(),
            effects: Vec::new(),
            is_off: false,
            beside,
            nearer: None,
            adds,
            is_weighed: false,
        }
    }

    /// Sizes are those that are told beside an arm; it is simulated again with them only if one is off by more than half its standard deviation.
    #[test]
    fn another_size_is_tried_where_it_matters() {
        let of = |amplitude: f64| FoundEffect {
            id: EffectId::Backlash,
            amplitude,
            amplitude_sd: 1e-4,
            shape: 0.0,
            log_bayes_factor: 0.0,
        };
        let soil = FittedSoil {
            phi_deg: 40.0,
            phi_sd_deg: 1.0,
            delta_offset_deg: 0.0,
            delta_offset_sd_deg: 1.0,
            density_kg_m3: 1500.0,
            density_sd_kg_m3: 30.0,
        };
        let mut contender = contender(&[EffectId::Backlash], 0.0, beside(None, None, ""));
        contender.effects = vec![of(1e-3)];
        assert!(contender.told().is_empty() && contender.at_other_sizes().is_none());
        for (size, is_tried) in [(1.04e-3, false), (0.96e-3, false), (1.06e-3, true), (0.94e-3, true)] {
            contender.nearer = Some(Fitted { effects: vec![of(size)], soil });
            assert_eq!(contender.told()[0].amplitude, size);
            assert_eq!(
                contender.at_other_sizes().map(|next| next.effects[0].amplitude),
                is_tried.then_some(size)
            );
        }
        (contender.nearer, contender.is_off) = (None, true);
        assert_eq!(contender.told()[0].amplitude, 1e-3);
    }

    /// An arm that says what to expect of a column or a stroke more than another does not win by that: all are weighed by the same ones.
    #[test]
    fn contenders_are_weighed_by_the_readings_that_all_of_them_expect() {
        let both = || beside(Some(1e-3), Some(0.2), "");
        let mut contenders = vec![
            contender(&[EffectId::Backlash], 0.0, both()),
            contender(&[EffectId::CableFlex], 0.0, beside(Some(1e-3), None, "")),
            contender(&[EffectId::ForceBias], 0.0, beside(Some(1e-3), Some(0.2), "c")),
        ];
        let plain = [both()];
        assert_eq!((plain[0].readings().columns.len(), plain[0].readings().strokes), (2, vec![true; 4]));
        let asked = RefCell::new(Vec::new());
        let log_evidence = |data: &Data, of: &Readings| {
            asked.borrow_mut().push(of.clone());
            Ok(data.readings().columns.intersection(&of.columns).count() as f64)
        };
        let diagnosis = |_: &Data| unreachable!("nothing is diagnosed by a ranking");
        let part = Part::of(&plain[0]);
        let fitted = |_: &Data, _: &[bool]| unreachable!("nothing is fitted by a ranking");
        let weights = Weights { diagnosis: &diagnosis, fitted: &fitted, log_evidence: &log_evidence };
        let mut ranked = None;
        for _ in 0..2 {
            rank(&plain, &mut contenders, &part, &weights, &mut ranked).unwrap();
        }
        let asked = asked.into_inner();
        // With a stroke that sinks its whole kind is left out.
        let shared = Readings { columns: [Channel::ZDrift].into(), strokes: vec![true, true, false, false] };
        assert_eq!(asked, vec![shared; 4]);
        assert!(contenders.iter().all(|of| of.adds.abs() < 1e-12));
        // One on which the other kind sinks leaves nothing to weigh them all by, and is none of them.
        let sinks = contender(&[EffectId::ForceDrift], 0.0, beside(Some(1e-3), Some(0.2), "a"));
        assert!(!join(&plain, &mut contenders, sinks, &part) && contenders.len() == 3);
        assert!(join(&plain, &mut contenders, contender(&[EffectId::ForceDrift], 0.0, both()), &part));
        assert_eq!(contenders.len(), 4);
    }
}
