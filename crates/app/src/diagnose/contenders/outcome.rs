//! What comes of a contest.

use soilctl_diagnosis::THRESHOLD;
use soilctl_effects::EffectId;

/// An effect is as likely as the best if its ln evidence lies behind by less than this, or by less than this part of what the best adds: a twin
/// is not the arm. Empirical.
pub(super) const AS_LIKELY: (f64, f64) = (5.0, 0.1);
/// What the noise of the arm without effects may make of ln evidence, one way or the other: that of one campaign had a standard deviation of 8 over
/// three seeds. Empirical.
pub(super) const CHANCE: f64 = 10.0;
/// What comes of a contest.
pub(super) struct Outcome {
    /// The set of effects that explains the readings best.
    pub(super) best: Vec<EffectId>,
    /// Effects that may stand in the place of the only one of `best`.
    pub(super) as_likely: Vec<EffectId>,
    /// What the arm without effects says of it.
    pub(super) bearing: Bearing,
}

/// Whether a set of effects adds more to the arm without effects than its number of effects costs, and more to arms with fewer than may be chance, as one of its effects
/// has to do alone.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Bearing {
    /// It does.
    Out,
    /// Not by enough.
    Open,
    /// The arm without effects is likelier by more than may be chance.
    Denied,
}

/// The outcome of a contest: sets of effects with what they add to the ln evidence of the arm without any. Each further effect has to earn its place. `untried` are effects of which the simulated arm has no say.
pub(super) fn outcome(weighed: &[(&[EffectId], f64)], untried: Vec<EffectId>) -> Option<Outcome> {
    type Weighed<'a> = (&'a [EffectId], f64);
    let score = |(ids, adds): &Weighed<'_>| adds - THRESHOLD * ids.len() as f64;
    let most = weighed.iter().max_by(|a, b| score(a).total_cmp(&score(b)))?;
    let behind = AS_LIKELY.0.max(AS_LIKELY.1 * most.1);
    // A part of it that is as likely is the simpler answer.
    let is_simpler = |(ids, adds): &&Weighed<'_>| {
        ids.len() < most.0.len() && ids.iter().all(|id| most.0.contains(id)) && *adds > most.1 - behind
    };
    let simpler = weighed.iter().filter(is_simpler);
    let best = simpler.max_by(|a, b| score(a).total_cmp(&score(b))).unwrap_or(most);
    let close = |(ids, adds): &&Weighed<'_>| ids.len() == 1 && *ids != best.0 && *adds > best.1 - behind;
    let as_likely = match best.0.len() {
        1 => weighed.iter().filter(close).flat_map(|(ids, _)| ids.to_vec()).chain(untried).collect(),
        _ => untried,
    };
    // The best of fewer effects: none, or one of a pair.
    let fewer = weighed.iter().filter(|(ids, _)| ids.len() < best.0.len());
    let lesser = fewer.map(|(_, adds)| *adds).fold(0.0, f64::max);
    // Two effects that are there are not both as good as nothing alone: what they make together then is a shape that neither has.
    let mut alone = weighed.iter().filter(|(ids, _)| matches!(ids, [id] if best.0.contains(id)));
    let is_seen = alone.any(|(_, adds)| *adds > CHANCE);
    let bearing = match score(best) {
        adds if adds > 0.0 && best.1 - lesser > CHANCE && is_seen => Bearing::Out,
        adds if adds > -CHANCE => Bearing::Open,
        _ => Bearing::Denied,
    };
    Some(Outcome { best: best.0.to_vec(), as_likely, bearing })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::*;

    #[test]
    fn the_best_has_to_beat_the_arm_without_effects_and_a_second_effect_to_earn_its_place() {
        let [a, b, c] = [EffectId::Backlash, EffectId::CableFlex, EffectId::FtCrosstalk];
        let of = |ids: &[EffectId], adds| (ids.to_vec(), adds);
        let found = |all: &[(Vec<EffectId>, f64)], untried: &[EffectId]| {
            let all: Vec<(&[EffectId], f64)> = all.iter().map(|(ids, adds)| (&ids[..], *adds)).collect();
            let outcome = outcome(&all, untried.to_vec()).unwrap();
            (outcome.best, outcome.as_likely, outcome.bearing)
        };
        // Behind by less than a tenth of 60, or by less than 5.
        let all = [of(&[a], 60.0), of(&[b], 54.5), of(&[c], 53.5)];
        assert_eq!(found(&all, &[]), (vec![a], vec![b], Bearing::Out));
        let all = [of(&[a], 20.0), of(&[b], 15.5), of(&[c], 14.5)];
        assert_eq!(found(&all, &[]), (vec![a], vec![b], Bearing::Out));
        // One that comes within a tenth of a pair that has it is the answer, and what is as likely as it is so, too.
        let close = [of(&[a, b], 151.7), of(&[a], 141.4), of(&[c], 128.4)];
        assert_eq!(found(&close, &[]), (vec![a], vec![c], Bearing::Out));
        assert_eq!(found(&[of(&[a, b], 157.7), of(&[a], 141.4)], &[]), (vec![a, b], vec![], Bearing::Out));
        // What cannot be simulated stays open.
        assert_eq!(found(&all[..1], &[c]), (vec![a], vec![c], Bearing::Out));
        // A pair that adds no more than another effect costs, or than makes two as likely, is not the best; one that adds more is, and what it has is not
        // as likely as it.
        let pair = |beyond: f64| [of(&[a, b], 20.0 + beyond * THRESHOLD), of(&[a], 20.0), of(&[b], 19.0)];
        assert_eq!(found(&pair(0.9), &[]), (vec![a], vec![b], Bearing::Out));
        assert_eq!(found(&pair(1.1), &[]), (vec![a], vec![b], Bearing::Out));
        assert_eq!(found(&pair(1.5), &[]), (vec![a, b], vec![], Bearing::Open));
        assert_eq!(found(&pair(2.9), &[]), (vec![a, b], vec![], Bearing::Out));
        // Nor is a pair of which neither adds more than chance may: a step in depth of 25 % was such a one.
        assert_eq!(found(&[of(&[a, b], 23.0), of(&[a], 5.7), of(&[b], -7.0)], &[]).2, Bearing::Open);
        assert_eq!(found(&[of(&[a, b], 33.0), of(&[a], 10.1), of(&[b], -7.0)], &[]).2, Bearing::Out);
        assert_eq!(found(&[of(&[a], 0.9 * THRESHOLD), of(&[b], -3.0)], &[]).2, Bearing::Open);
        // No effect is as likely as one that adds no more than chance may.
        assert_eq!(found(&[of(&[a], 9.9)], &[]).2, Bearing::Open);
        assert_eq!(found(&[of(&[a], 10.1)], &[]).2, Bearing::Out);
        assert_eq!(found(&[of(&[a], THRESHOLD - 10.1), of(&[b], -30.0)], &[]).2, Bearing::Denied);
        assert!(outcome(&[], vec![c]).is_none());
    }
}
