//! Effects that could explain a campaign, each simulated with all strokes or a part that stands for them, and ranked by all readings.
//!
//! Responses that are learnt from single strokes are those of an arm without effects. An effect that keeps a plate from sinking changes what all others
//! do, and what responses leave over was taken for a second effect. So those that come into question are simulated as the campaign was made. Each has
//! the soil that is fitted beside it, and so has the arm without effects: a soil that was fitted by the table alone leaves more over than most effects do.

mod outcome;
mod ranking;

use std::collections::BTreeSet;

use outcome::{AS_LIKELY, Bearing, outcome};
use ranking::{Contender, Part, join, rank, taking_part};
use soilctl_campaign::CampaignError;
use soilctl_diagnosis::{Data, Diagnosis, Explanation, Fitted, FoundEffect, Readings, Status, TURN_ALIKE};
use soilctl_effects::{EffectId, Loaded, SoilEntry};

use super::Against;
use super::resimulated::{Again, expect_scene};
use crate::AppError;
use crate::text::measured;

/// Most effects that are simulated alone, the part of the best one's ln Bayes factor that one must have alone to be tried, and to be tried at
/// another size, unless it was found.
const MOST: usize = 5;
const LEAST_SHARE: f64 = 0.2;
const LEAST_SHARE_OF_SIZES: f64 = 0.5;
/// How often a set is simulated at most, each time with the sizes for which readings ask beside the arm before, and by how many standard deviations
/// one of these must differ.
const ROUNDS: usize = 3;
const MATTERS: f64 = 0.5;

/// Sizes and soil that data tell, by these strokes of theirs.
type FittedBy<'a> = &'a dyn Fn(&Data, &[bool]) -> Result<Fitted, AppError>;
/// ln evidence of data, of these readings of theirs.
type LogEvidence<'a> = &'a dyn Fn(&Data, &Readings) -> Result<f64, AppError>;

/// How data are weighed: the diagnosis, sizes and soil of a set that was decided for as some strokes tell them, and ln of the probability of forces and columns with what is
/// known and nothing else.
pub(super) struct Weights<'a> {
    pub(super) diagnosis: &'a dyn Fn(&Data) -> Result<Diagnosis, AppError>,
    pub(super) fitted: FittedBy<'a>,
    pub(super) log_evidence: LogEvidence<'a>,
}

/// A set of effects that is to be simulated.
struct Set {
    ids: Vec<EffectId>,
    /// Those of them whose sizes are known.
    held: Vec<FoundEffect>,
    /// All sizes with the soil beside them, if these are known.
    fitted: Option<Fitted>,
}

impl Set {
    /// Effects with the sizes that strokes tell.
    fn of(ids: &[EffectId]) -> Self {
        Self { ids: ids.to_vec(), held: Vec::new(), fitted: None }
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

/// Takes the sizes of effects as known.
pub(super) fn hold(data: &mut Data, effects: &[FoundEffect]) {
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
    /// Simulates what could explain the campaign and decides by the readings; the soil that these tell beside the arm with what was decided for. Nothing is
    /// decided, and there is no soil, where nothing was found, where the simulated arm cannot show what was found, or where the work is stopped.
    pub(super) fn contest(
        &self,
        against: &Against,
        data: &mut Data,
        diagnosis: &mut Diagnosis,
        weights: &Weights<'_>,
    ) -> Result<Option<SoilEntry>, AppError> {
        let found: Vec<EffectId> = diagnosis.effects.iter().map(|found| found.id).collect();
        if found.is_empty() {
            return Ok(None);
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
            match self.contender(against, data, &part, Set::of(&[id]), weights, base)? {
                Tried::Weighed(contender) => {
                    contenders.push(*contender);
                    if found.contains(&id) || has_alone(&diagnosis.alone, id, LEAST_SHARE_OF_SIZES) {
                        self.other_sizes(against, data, &part, weights, &plain, &mut contenders)?;
                    }
                }
                Tried::Sinks if found.contains(&id) => {
                    self.doubt(diagnosis, SINKS);
                    return Ok(None);
                }
                Tried::NotShown if found.contains(&id) => return Ok(None),
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
            return Ok(None);
        }
        let Some(first) = contenders.first() else { return Ok(None) };
        let beside = |more: &[EffectId]| Set {
            ids: [first.ids.as_slice(), more].concat(),
            held: first.held().to_vec(),
            fitted: None,
        };
        let more = |id: &&EffectId| !first.ids.contains(id);
        let mut sets: Vec<Set> = found.iter().filter(more).map(|id| beside(&[*id])).collect();
        if found.len() > 2 {
            sets.push(Set::of(&found));
        }
        for set in sets {
            if let Tried::Weighed(further) = self.contender(against, data, &part, set, weights, base)? {
                join(&plain, &mut contenders, *further, &part);
            }
        }
        rank(&plain, &mut contenders, &part, weights, &mut ranked)?;
        for of in &contenders {
            self.watch.note(&format!("{}: ln evidence of all readings {:+.1}", arm(&of.effects), of.adds));
        }
        // Of one set at several sizes the best counts.
        let mut seen: Vec<Vec<EffectId>> = Vec::new();
        contenders.retain(|of| {
            let is_first = !seen.contains(&of.ids);
            seen.push(of.ids.clone());
            is_first
        });
        let weighed: Vec<(&[EffectId], f64)> = contenders.iter().map(|of| (&of.ids[..], of.adds)).collect();
        let Some(outcome) = outcome(&weighed, untried) else { return Ok(None) };
        let mut soil = None;
        match outcome.bearing {
            Bearing::Out | Bearing::Open => {
                data.decide(&outcome.best, &outcome.as_likely);
                // Sizes are those for which readings ask beside the best arm: there errors of responses matter least.
                let best = contenders.iter().find(|of| of.ids == outcome.best);
                hold(data, best.map_or(&[], Contender::told));
                let nearer = best.and_then(|best| best.nearer.as_ref());
                soil = nearer.map(|of| of.model_file(data, &against.model, against.known()).soil);
            }
            Bearing::Denied => {
                self.watch.note(
                    "the simulated arm without effects explains the readings better than with any of them",
                );
                data.decide(&[], &[]);
            }
        }
        *diagnosis = (weights.diagnosis)(data)?;
        let is_best = is_same_set(&outcome.best, diagnosis.effects.iter().map(|found| found.id));
        match outcome.bearing {
            Bearing::Open => {
                self.doubt(
                    diagnosis,
                    "a simulated arm with fewer effects, or none, explains the readings about as well",
                );
            }
            Bearing::Out if !is_best => {
                self.doubt(diagnosis, "responses ask for other effects than the simulated arms");
            }
            Bearing::Out | Bearing::Denied => {}
        }
        Ok(soil.filter(|_| is_best))
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
        let refitted = match self.contender(against, data, part, Set::of(&[]), weights, None)? {
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
        Set { ids, held, fitted }: Set,
        weights: &Weights<'_>,
        base: Option<&Data>,
    ) -> Result<Tried, AppError> {
        let is_off = fitted.is_some() || !held.is_empty();
        let fitted = match fitted {
            Some(fitted) => fitted,
            None => {
                let mut alone = data.clone();
                alone.decide(&ids, &[]);
                hold(&mut alone, &held);
                (weights.fitted)(&alone, &[])?
            }
        };
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
        let beside = |of: &Loaded, shows: bool| {
            let mut beside = data.clone();
            beside.know(of);
            beside.expect_of(&part.strokes, &simulated.data, shows, of.file().soil.delta_offset_deg.value);
            expect_scene(&mut beside, &simulated.data, of);
            base.iter().for_each(|base| beside.expect_as(base));
            beside
        };
        let mut without = file.clone();
        let with = beside(&Loaded::new(file, "the simulated soil")?, true);
        let strokes = with.readings().strokes;
        if part.is_little(&strokes) {
            self.watch.note(&format!(
                "of {} strokes, {} fail the soil of {} and are of a kind that is not on the brink: too few to be weighed",
                taking_part(&part.strokes),
                taking_part(&strokes),
                arm(&fitted.effects)
            ));
            return Ok(Tried::Sinks);
        }
        // What that arm leaves over tells how far the sizes are off.
        without.effects.truncate(against.known().len());
        let mut left = beside(&Loaded::new(without, "the simulated soil")?, !against.known().is_empty());
        left.decide(&ids, &[]);
        let nearer = match left.count_from(&fitted.effects) {
            true => {
                Some((weights.fitted)(&left, &strokes)?).filter(|nearer| nearer.effects.len() == ids.len())
            }
            false => None,
        };
        let effects = fitted.effects;
        Ok(Tried::Weighed(Box::new(Contender {
            ids,
            is_off,
            effects,
            nearer,
            beside: with,
            adds: 0.0,
            is_weighed: false,
        })))
    }

    /// Simulates the last of the contenders again, with the sizes for which readings ask beside it, as long as these differ.
    fn other_sizes(
        &self,
        against: &Against,
        data: &Data,
        part: &Part,
        weights: &Weights<'_>,
        plain: &[Data],
        contenders: &mut Vec<Contender>,
    ) -> Result<(), AppError> {
        for _ in 1..ROUNDS {
            let Some(next) = contenders.last().and_then(Contender::at_other_sizes) else { break };
            let ids = next.effects.iter().map(|of| of.id).collect();
            let set = Set { ids, held: Vec::new(), fitted: Some(next) };
            let Tried::Weighed(other) = self.contender(against, data, part, set, weights, plain.first())?
            else {
                break;
            };
            if !join(plain, contenders, *other, part) {
                break;
            }
        }
        Ok(())
    }
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

    use super::*;

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
}
