//! Effects that could explain a campaign, each simulated whole, and ranked by all readings.
//!
//! Responses that are learnt from single strokes are those of an arm without effects. An effect that keeps a plate from sinking changes what all others
//! do, and what responses leave over was taken for a second effect. So those that come into question are simulated in the whole campaign. Each has
//! the soil that is fitted beside it, and so has the arm without effects: a soil that was fitted by the table alone leaves more over than most effects do.

use std::collections::BTreeSet;

use soilctl_campaign::CampaignError;
use soilctl_diagnosis::{
    Data, Diagnosis, Explanation, Fitted, FoundEffect, Readings, Status, THRESHOLD, TURN_ALIKE,
};
use soilctl_effects::{EffectId, Loaded};

use super::Against;
use super::resimulated::{Again, expect_scene};
use crate::AppError;
use crate::text::measured;

/// An effect is as likely as the best if its ln evidence lies behind by less than this, or by less than this part of what the best adds: a twin
/// is not the arm. Empirical.
const AS_LIKELY: (f64, f64) = (5.0, 0.1);
/// What the noise of the arm without effects may make of ln evidence, one way or the other: that of one campaign had a standard deviation of 8 over
/// three seeds. Empirical.
const CHANCE: f64 = 10.0;
/// Most effects that are simulated alone, the part of the best one's ln Bayes factor that one must have alone to be tried, and to be tried at
/// several sizes, unless it was found.
const MOST: usize = 5;
const LEAST_SHARE: f64 = 0.2;
const LEAST_SHARE_OF_SIZES: f64 = 0.5;

/// ln evidence of data, of these readings of theirs.
type LogEvidence<'a> = &'a dyn Fn(&Data, &Readings) -> Result<f64, AppError>;

/// How data are weighed: the diagnosis, sizes and soil of a set that was decided for, and ln of the probability of forces and columns with what is
/// known and nothing else.
pub(super) struct Weights<'a> {
    pub(super) diagnosis: &'a dyn Fn(&Data) -> Result<Diagnosis, AppError>,
    pub(super) fitted: &'a dyn Fn(&Data) -> Result<Fitted, AppError>,
    pub(super) log_evidence: LogEvidence<'a>,
}

/// Strokes by which contenders are weighed: whole batches with so many or a few more, since each contender is simulated. Empirical: contests
/// of campaigns of 24 strokes decide.
const STROKES: usize = 20;

/// The part of a campaign by which contenders are weighed.
struct Part {
    /// Its batches; all if `None`.
    batches: Option<Vec<usize>>,
    strokes: Vec<bool>,
}

impl Part {
    fn of(data: &Data) -> Self {
        let batches = data.sample(STROKES);
        let strokes = batches.as_ref().map_or_else(|| vec![true; data.len()], |of| data.of_batches(of));
        Self { batches, strokes }
    }

    /// Whether less than half of its strokes takes part.
    fn is_little(&self, strokes: &[bool]) -> bool {
        2 * taking_part(strokes) < taking_part(&self.strokes)
    }
}

/// A set of effects, and the readings beside the simulated arm that has them.
struct Contender {
    ids: Vec<EffectId>,
    /// Their sizes on that arm.
    effects: Vec<FoundEffect>,
    /// Whether these are others than strokes tell beside responses.
    is_off: bool,
    beside: Data,
    /// Whether strokes of a kind go different ways there.
    jumps: bool,
    /// ln evidence of what all contenders expect, over that of the better arm without effects, once it is weighed.
    adds: f64,
    is_weighed: bool,
}

/// A set of effects that is to be simulated.
struct Set {
    ids: Vec<EffectId>,
    /// Those of them whose sizes are known.
    held: Vec<FoundEffect>,
    /// By how many standard deviations sizes are off those that strokes tell.
    off: f64,
}

impl Set {
    /// Effects with the sizes that strokes tell.
    fn of(ids: &[EffectId]) -> Self {
        Self { ids: ids.to_vec(), held: Vec::new(), off: 0.0 }
    }
}

/// What came of simulating a set of effects.
enum Tried {
    Weighed(Box<Contender>),
    /// Most strokes that the measured arm made are of kinds that sink on this one.
    Sinks,
    /// Strokes speak against one of the effects, the simulated arm cannot show it, or the work was stopped.
    NotShown,
}

impl Contender {
    /// Its effects, if strokes do not tell their sizes.
    fn held(&self) -> &[FoundEffect] {
        if self.is_off { &self.effects } else { &[] }
    }
}

/// Takes the sizes of effects as known.
fn hold(data: &mut Data, effects: &[FoundEffect]) {
    effects.iter().for_each(|of| data.hold(of.id, of.amplitude, of.amplitude_sd));
}

/// Why a contest is none.
const SINKS: &str = "too few of the strokes fail the soil of the simulated arm that has what they ask for";

/// The simulated arm in words.
fn arm(effects: &[FoundEffect]) -> String {
    let each = |of: &FoundEffect| {
        format!("{} of {}", of.id, measured(of.amplitude, of.amplitude_sd, of.id.effect().parameter.unit))
    };
    match effects {
        [] => "the simulated arm without effects".to_owned(),
        _ => format!("the simulated arm with {}", effects.iter().map(each).collect::<Vec<_>>().join(", ")),
    }
}

impl Again<'_> {
    /// Simulates what could explain the campaign and decides by the readings. Nothing is decided where nothing was found, where the simulated
    /// arm cannot show what was found, or where the work is stopped.
    pub(super) fn contest(
        &self,
        against: &Against,
        data: &mut Data,
        diagnosis: &mut Diagnosis,
        weights: &Weights<'_>,
    ) -> Result<(), AppError> {
        let found: Vec<EffectId> = diagnosis.effects.iter().map(|found| found.id).collect();
        if found.is_empty() {
            return Ok(());
        }
        let in_question = in_question(diagnosis);
        let part = Part::of(data);
        self.watch.note(&format!(
            "{} come into question: {} of the {} strokes once more on the simulated arm with each of them, and with what was found beside the best",
            in_question.iter().map(|id| id.name()).collect::<Vec<_>>().join(", "),
            taking_part(&part.strokes),
            data.len()
        ));
        let plain = self.refitted(against, data, &part, weights)?;
        let base = plain.first();
        let mut contenders = Vec::new();
        // What the simulated arm has no say about stays as likely as it was found to be.
        let mut untried = Vec::new();
        for id in in_question {
            match self.contender(against, data, &part, &Set::of(&[id]), weights, base)? {
                Tried::Weighed(contender) => {
                    // Where an effect that passes the controller makes strokes go another way, one size of it says little of another.
                    let is_uneven = contender.jumps && id.effect().site.passes_the_controller();
                    let is_wanted =
                        found.contains(&id) || has_alone(&diagnosis.alone, id, LEAST_SHARE_OF_SIZES);
                    let further = if is_uneven && is_wanted { &[-1.0, 1.0][..] } else { &[] };
                    contenders.push(*contender);
                    for off in further {
                        let set = Set { off: *off, ..Set::of(&[id]) };
                        if let Tried::Weighed(other) =
                            self.contender(against, data, &part, &set, weights, base)?
                        {
                            contenders.push(*other);
                            if shared(&plain, &contenders, &part).is_none() {
                                contenders.pop();
                            }
                        }
                    }
                }
                Tried::Sinks if found.contains(&id) => {
                    self.doubt(diagnosis, SINKS);
                    return Ok(());
                }
                Tried::NotShown if found.contains(&id) => return Ok(()),
                Tried::Sinks | Tried::NotShown => untried.push(id),
            }
        }
        let in_set: Vec<EffectId> = in_set(diagnosis).collect();
        untried.retain(|id| {
            TURN_ALIKE.contains(id) || in_set.contains(id) && is_likely_alone(&diagnosis.alone, *id)
        });
        let mut ranked = None;
        if !rank(&plain, &mut contenders, &part, weights, &mut ranked)? {
            self.doubt(diagnosis, SINKS);
            return Ok(());
        }
        let Some(first) = contenders.first() else { return Ok(()) };
        let beside = |more: &[EffectId]| Set {
            ids: [first.ids.as_slice(), more].concat(),
            held: first.held().to_vec(),
            off: 0.0,
        };
        let more = |id: &&EffectId| !first.ids.contains(id);
        let mut sets: Vec<Set> = found.iter().filter(more).map(|id| beside(&[*id])).collect();
        if found.len() > 2 {
            sets.push(Set::of(&found));
        }
        for set in sets {
            let Tried::Weighed(further) = self.contender(against, data, &part, &set, weights, base)? else {
                continue;
            };
            contenders.push(*further);
            // A set whose arm leaves too few strokes to weigh it with the others is not one of them.
            if shared(&plain, &contenders, &part).is_none() {
                contenders.pop();
            }
        }
        rank(&plain, &mut contenders, &part, weights, &mut ranked)?;
        // Of one set at several sizes the best counts.
        let mut seen: Vec<Vec<EffectId>> = Vec::new();
        contenders.retain(|of| {
            let is_first = !seen.contains(&of.ids);
            seen.push(of.ids.clone());
            is_first
        });
        for of in &contenders {
            self.watch.note(&format!("{}: ln evidence of all readings {:+.1}", arm(&of.effects), of.adds));
        }
        let Some(outcome) = outcome(&contenders, untried) else { return Ok(()) };
        match outcome.bearing {
            Bearing::Out | Bearing::Open => {
                data.decide(&outcome.best, &outcome.as_likely);
                // The size is that of the arm that was weighed.
                let best = contenders.iter().find(|of| of.ids == outcome.best);
                hold(data, best.map_or(&[], Contender::held));
            }
            Bearing::Denied => {
                self.watch.note(
                    "the simulated arm without effects explains the readings better than with any of them",
                );
                data.decide(&[], &[]);
            }
        }
        *diagnosis = (weights.diagnosis)(data)?;
        match outcome.bearing {
            Bearing::Open => {
                self.doubt(
                    diagnosis,
                    "a simulated arm with fewer effects, or none, explains the readings about as well",
                );
            }
            Bearing::Out if !is_same_set(&outcome.best, diagnosis.effects.iter().map(|found| found.id)) => {
                self.doubt(diagnosis, "responses ask for other effects than the simulated arms");
            }
            Bearing::Out | Bearing::Denied => {}
        }
        Ok(())
    }

    /// The campaign beside the arms without effects: one with the soil that all signals ask for, unless too many strokes sink there, and the one that it
    /// was compared with. The first of them is what all others are compared with.
    fn refitted(
        &self,
        against: &Against,
        data: &Data,
        part: &Part,
        weights: &Weights<'_>,
    ) -> Result<Vec<Data>, AppError> {
        let refitted = match self.contender(against, data, part, &Set::of(&[]), weights, None)? {
            Tried::Weighed(without) => without.beside,
            Tried::Sinks | Tried::NotShown => return Ok(vec![data.clone()]),
        };
        let mut compared = data.clone();
        compared.expect_as(&refitted);
        Ok(vec![refitted, compared])
    }

    /// A firm name that the contest does not bear out is provisional.
    fn doubt(&self, diagnosis: &mut Diagnosis, why: &str) {
        if diagnosis.status == Status::Named {
            diagnosis.status = Status::Provisional;
            self.watch.note(&format!("{why}: what responses ask for is provisional"));
        }
    }

    /// The campaign with a set of effects, as it is fitted with them alone, on the simulated arm; what it expects beyond what `base` does is cleared of
    /// chance.
    fn contender(
        &self,
        against: &Against,
        data: &Data,
        part: &Part,
        Set { ids, held, off }: &Set,
        weights: &Weights<'_>,
        base: Option<&Data>,
    ) -> Result<Tried, AppError> {
        let mut alone = data.clone();
        alone.decide(ids, &[]);
        hold(&mut alone, held);
        let mut fitted = (weights.fitted)(&alone)?;
        if fitted.effects.len() == ids.len() && *off != 0.0 {
            // With the soil that strokes ask for beside that size.
            for of in &mut fitted.effects {
                let size = of.amplitude + off * of.amplitude.signum() * of.amplitude_sd;
                if size * of.amplitude > 0.0 {
                    of.amplitude = size;
                }
            }
            hold(&mut alone, &fitted.effects);
            fitted = (weights.fitted)(&alone)?;
        }
        if fitted.effects.len() != ids.len() {
            return Ok(Tried::NotShown);
        }
        let file = fitted.model_file(data, &against.model, against.known());
        let simulated = match self.simulate(&file, &data.campaign, part.batches.as_deref()) {
            Err(AppError::Campaign(CampaignError::Effect { .. } | CampaignError::Term { .. })) => {
                return Ok(Tried::NotShown);
            }
            found => found?,
        };
        let Some(simulated) = simulated else { return Ok(Tried::NotShown) };
        let offset_deg = file.soil.delta_offset_deg.value;
        let model = Loaded::new(file, "the simulated soil")?;
        let mut beside = data.clone();
        beside.know(&model);
        beside.expect_of(&part.strokes, &simulated.data, true, offset_deg);
        expect_scene(&mut beside, &simulated.data, &model);
        let jumps = base.is_some_and(|base| beside.expect_as(base));
        let strokes = beside.readings().strokes;
        if part.is_little(&strokes) {
            self.watch.note(&format!(
                "of {} strokes, {} fail the soil of {} and are of a kind that is not on the brink: too few to be weighed",
                taking_part(&part.strokes),
                taking_part(&strokes),
                arm(&fitted.effects)
            ));
            return Ok(Tried::Sinks);
        }
        Ok(Tried::Weighed(Box::new(Contender {
            ids: ids.clone(),
            is_off: *off != 0.0 || !held.is_empty(),
            effects: fitted.effects,
            beside,
            jumps,
            adds: 0.0,
            is_weighed: false,
        })))
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

/// Weighs the readings that all contenders share, most evidence first; `false` if these are too few, and then nothing is weighed.
/// `before` is what a ranking before this one weighed and ln evidence of the better arm without effects, which stay as they are where it
/// is the same readings.
fn rank(
    plain: &[Data],
    contenders: &mut [Contender],
    part: &Part,
    weights: &Weights<'_>,
    before: &mut Option<(Readings, f64)>,
) -> Result<bool, AppError> {
    let Some(shared) = shared(plain, contenders, part) else { return Ok(false) };
    let without = match before {
        Some((readings, without)) if *readings == shared => *without,
        _ => {
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

fn taking_part(strokes: &[bool]) -> usize {
    strokes.iter().filter(|takes_part| **takes_part).count()
}

/// What comes of a contest.
struct Outcome {
    /// The set of effects that explains the readings best.
    best: Vec<EffectId>,
    /// Effects that may stand in the place of the only one of `best`.
    as_likely: Vec<EffectId>,
    /// What the arm without effects says of it.
    bearing: Bearing,
}

/// Whether a set of effects adds more to the arm without effects than its number of effects costs, and more to arms with fewer than may be chance.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Bearing {
    /// It does.
    Out,
    /// Not by enough.
    Open,
    /// The arm without effects is likelier by more than may be chance.
    Denied,
}

/// The outcome of contenders that were weighed; each further effect has to earn its place. `untried` are effects of which the simulated arm has no say.
fn outcome(contenders: &[Contender], untried: Vec<EffectId>) -> Option<Outcome> {
    let score = |of: &Contender| of.adds - THRESHOLD * of.ids.len() as f64;
    let most = contenders.iter().max_by(|a, b| score(a).total_cmp(&score(b)))?;
    let behind = AS_LIKELY.0.max(AS_LIKELY.1 * most.adds);
    // A part of it that is as likely is the simpler answer.
    let is_simpler = |of: &&Contender| {
        of.ids.len() < most.ids.len()
            && of.ids.iter().all(|id| most.ids.contains(id))
            && of.adds > most.adds - behind
    };
    let simpler = contenders.iter().filter(is_simpler);
    let best = simpler.max_by(|a, b| score(a).total_cmp(&score(b))).unwrap_or(most);
    let close = |of: &&Contender| of.ids.len() == 1 && of.ids != best.ids && of.adds > best.adds - behind;
    let as_likely = match best.ids.len() {
        1 => contenders.iter().filter(close).flat_map(|of| of.ids.clone()).chain(untried).collect(),
        _ => untried,
    };
    // The best of fewer effects: none, or one of a pair.
    let fewer = contenders.iter().filter(|of| of.ids.len() < best.ids.len());
    let lesser = fewer.map(|of| of.adds).fold(0.0, f64::max);
    let bearing = match score(best) {
        adds if adds > 0.0 && best.adds - lesser > CHANCE => Bearing::Out,
        adds if adds > -CHANCE => Bearing::Open,
        _ => Bearing::Denied,
    };
    Some(Outcome { best: best.ids.clone(), as_likely, bearing })
}

/// Effects that are not told apart from what was found.
fn in_set(diagnosis: &Diagnosis) -> impl Iterator<Item = EffectId> + '_ {
    diagnosis.equivalence_set.iter().filter_map(|of| match of {
        Explanation::Effect(id) => Some(*id),
        Explanation::Unknown(_) => None,
    })
}

/// Whether effects are those of a set, in any order.
fn is_same_set(set: &[EffectId], ids: impl Iterator<Item = EffectId>) -> bool {
    set.iter().copied().collect::<BTreeSet<_>>() == ids.collect()
}

/// Whether an effect alone is about as likely as the likeliest: where several were found, another one may stand for the second of them only.
fn is_likely_alone(alone: &[(EffectId, f64)], id: EffectId) -> bool {
    let most = alone.first().map_or(0.0, |(_, log_bayes)| *log_bayes);
    let behind = AS_LIKELY.0.max(AS_LIKELY.1 * most);
    alone.iter().any(|(of, log_bayes)| *of == id && *log_bayes > most - behind)
}

/// Whether an effect alone has more than this part of the ln Bayes factor of the best one.
fn has_alone(alone: &[(EffectId, f64)], id: EffectId, share: f64) -> bool {
    let most = alone.first().map_or(0.0, |(_, log_bayes)| *log_bayes);
    alone.iter().any(|(of, log_bayes)| *of == id && *log_bayes > share * most.max(0.0))
}

/// Effects that may be what is missing: what was found, what is not told apart from it, and the likeliest alone. Of two that turn the slip alike, each
/// brings the other.
fn in_question(diagnosis: &Diagnosis) -> Vec<EffectId> {
    let found = diagnosis.effects.iter().map(|found| found.id);
    let likely = |id: &EffectId| has_alone(&diagnosis.alone, *id, LEAST_SHARE);
    let alone = diagnosis.alone.iter().map(|(id, _)| *id).filter(likely);
    // What a set of several leaves open is which is beside the first of them, not what may be there alone.
    let in_set = in_set(diagnosis).filter(|id| diagnosis.effects.len() < 2 || likely(id));
    let mut ids = Vec::new();
    for id in found.chain(in_set).chain(alone) {
        if !ids.contains(&id) && ids.len() < MOST {
            ids.push(id);
        }
    }
    if ids.iter().any(|id| TURN_ALIKE.contains(id)) {
        let other = TURN_ALIKE.into_iter().filter(|id| !ids.contains(id)).collect::<Vec<_>>();
        ids.extend(other);
    }
    ids
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use std::cell::RefCell;

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
            jumps: false,
            adds,
            is_weighed: false,
        }
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
        let fitted = |_: &Data| unreachable!("nothing is fitted by a ranking");
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
        // One on which the other kind sinks leaves nothing to weigh them all by.
        contenders.push(contender(&[EffectId::ForceDrift], 0.0, beside(Some(1e-3), Some(0.2), "a")));
        assert!(super::shared(&plain, &contenders, &part).is_none());
    }

    /// Beside a bias of the sensor that explains nearly everything, what may stand for a small second effect is no rival of the bias.
    #[test]
    fn a_rival_of_a_second_effect_is_none_of_the_first() {
        let [bias, flex, ends] = [EffectId::ForceBias, EffectId::CableFlex, EffectId::SideEffects3d];
        let alone = [(bias, 120.0), (flex, 109.0), (ends, 4.0)];
        assert_eq!(alone.map(|(id, _)| is_likely_alone(&alone, id)), [true, true, false]);
        assert!(!is_likely_alone(&alone, EffectId::WallProximity) && !is_likely_alone(&[], bias));
    }

    #[test]
    fn a_part_of_what_the_arms_ask_for_is_not_what_they_ask_for() {
        let [a, b] = [EffectId::SideEffects3d, EffectId::DensityGradient];
        let same = |ids: &[EffectId]| is_same_set(&[a, b], ids.iter().copied());
        assert!(same(&[a, b]) && same(&[b, a]) && !same(&[a]) && !same(&[]));
    }

    #[test]
    fn the_best_has_to_beat_the_arm_without_effects_and_a_second_effect_to_earn_its_place() {
        let [a, b, c] = [EffectId::Backlash, EffectId::CableFlex, EffectId::FtCrosstalk];
        let of = |ids: &[EffectId], adds| contender(ids, adds, beside(None, None, ""));
        let found = |all: &[Contender], untried: &[EffectId]| {
            let outcome = outcome(all, untried.to_vec()).unwrap();
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
        assert_eq!(found(&[of(&[a], 0.9 * THRESHOLD), of(&[b], -3.0)], &[]).2, Bearing::Open);
        // No effect is as likely as one that adds no more than chance may.
        assert_eq!(found(&[of(&[a], 9.9)], &[]).2, Bearing::Open);
        assert_eq!(found(&[of(&[a], 10.1)], &[]).2, Bearing::Out);
        assert_eq!(found(&[of(&[a], THRESHOLD - 10.1), of(&[b], -30.0)], &[]).2, Bearing::Denied);
        assert!(outcome(&[], vec![c]).is_none());
    }
}
