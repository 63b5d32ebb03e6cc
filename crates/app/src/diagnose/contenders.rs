//! Effects that could explain a campaign, each simulated whole, and ranked by all readings.
//!
//! Responses that are learnt from single strokes are those of an arm without effects. An effect that keeps a plate from sinking changes what all others
//! do, and what responses leave over was taken for a second effect. So those that come into question are simulated in the whole campaign.

use std::collections::BTreeSet;

use soilctl_campaign::CampaignError;
use soilctl_diagnosis::{Data, Diagnosis, Explanation, Status, THRESHOLD, TURN_ALIKE};
use soilctl_effects::{Channel, EffectId, Loaded};

use super::Against;
use super::resimulated::{Again, expect_scene, model_file};
use crate::AppError;

/// An effect is as likely as the best if its ln evidence lies behind by less than this, or by less than this part of what the best adds: a twin
/// is not the arm. Empirical.
const AS_LIKELY: (f64, f64) = (5.0, 0.1);
/// Most effects that are simulated alone, and the part of the best one's ln Bayes factor that one must have alone to be tried.
const MOST: usize = 5;
const LEAST_SHARE: f64 = 0.2;

/// ln evidence of data, of these columns of theirs.
type LogEvidence<'a> = &'a dyn Fn(&Data, &BTreeSet<Channel>) -> Result<f64, AppError>;

/// How data are weighed: the diagnosis, and ln of the probability of forces and columns with what is known and nothing else.
pub(super) struct Weights<'a> {
    pub(super) diagnosis: &'a dyn Fn(&Data) -> Result<Diagnosis, AppError>,
    pub(super) log_evidence: LogEvidence<'a>,
}

/// A set of effects, and the readings beside the simulated arm that has them.
struct Contender {
    ids: Vec<EffectId>,
    beside: Data,
    /// ln evidence of what all contenders expect, over that of the arm without effects.
    adds: f64,
}

impl Contender {
    fn names(&self) -> String {
        self.ids.iter().map(|id| id.name()).collect::<Vec<_>>().join(", ")
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
        self.watch.note(&format!(
            "{} effects come into question: the {} strokes once more on the simulated arm with each of them, and with what was found beside the best",
            in_question.len(),
            self.plan.strokes().strokes().len()
        ));
        let mut contenders = Vec::new();
        // What the simulated arm has no say about stays as likely as it was found to be.
        let mut untried = Vec::new();
        for id in in_question {
            match self.contender(against, data, &[id], weights)? {
                Some(contender) => contenders.push(contender),
                None if found.contains(&id) => return Ok(()),
                None => untried.push(id),
            }
        }
        untried.retain(|id| TURN_ALIKE.contains(id) || in_set(diagnosis).any(|of| of == *id));
        rank(data, &mut contenders, weights)?;
        let Some(first) = contenders.first().map(|first| first.ids.clone()) else { return Ok(()) };
        let mut sets: Vec<Vec<EffectId>> = found
            .iter()
            .filter(|id| !first.contains(id))
            .map(|id| [first.as_slice(), &[*id]].concat())
            .collect();
        if found.len() > 2 {
            sets.push(found);
        }
        for ids in sets {
            contenders.extend(self.contender(against, data, &ids, weights)?);
        }
        rank(data, &mut contenders, weights)?;
        for of in &contenders {
            self.watch.note(&format!(
                "the simulated arm with {}: ln evidence of all readings {:+.1}",
                of.names(),
                of.adds
            ));
        }
        // Each further effect has to earn its place.
        let score = |of: &&Contender| of.adds - THRESHOLD * of.ids.len() as f64;
        let Some(best) = contenders.iter().max_by(|a, b| score(a).total_cmp(&score(b))) else {
            return Ok(());
        };
        let behind = AS_LIKELY.0.max(AS_LIKELY.1 * best.adds);
        let close = |of: &&Contender| of.ids.len() == 1 && of.ids != best.ids && of.adds > best.adds - behind;
        let as_likely: Vec<EffectId> = match best.ids.len() {
            1 => contenders.iter().filter(close).flat_map(|of| of.ids.clone()).chain(untried).collect(),
            _ => untried,
        };
        let is_borne_out = score(&best) > 0.0;
        data.decide(&best.ids, &as_likely);
        *diagnosis = (weights.diagnosis)(data)?;
        if !is_borne_out && diagnosis.status == Status::Named {
            diagnosis.status = Status::Provisional;
            self.watch.note("the simulated arm without effects explains the readings as well: what responses ask for is provisional");
        }
        Ok(())
    }

    /// The campaign with a set of effects, as it is fitted with them alone, on the simulated arm; `None` if strokes speak against one of them, the arm
    /// cannot show it, or the work is stopped.
    fn contender(
        &self,
        against: &Against,
        data: &Data,
        ids: &[EffectId],
        weights: &Weights<'_>,
    ) -> Result<Option<Contender>, AppError> {
        let mut alone = data.clone();
        alone.decide(ids, &[]);
        let fitted = (weights.diagnosis)(&alone)?;
        if fitted.effects.len() != ids.len() {
            return Ok(None);
        }
        let file = model_file(against, data, &fitted);
        let simulated = match self.simulate(&file, &data.campaign) {
            Err(AppError::Campaign(CampaignError::Effect { .. })) => return Ok(None),
            found => found?,
        };
        let Some(simulated) = simulated else { return Ok(None) };
        let offset_deg = file.soil.delta_offset_deg.value;
        let model = Loaded::new(file, "the simulated soil")?;
        let mut beside = data.clone();
        beside.know(&model);
        beside.expect(&simulated.data, true, offset_deg);
        expect_scene(&mut beside, &simulated.data, &model);
        Ok(Some(Contender { ids: ids.to_vec(), beside, adds: 0.0 }))
    }
}

/// Weighs the readings of which all contenders, and the arm without effects, say what to expect; most evidence first.
fn rank(plain: &Data, contenders: &mut [Contender], weights: &Weights<'_>) -> Result<(), AppError> {
    let mut columns = plain.expected_columns();
    for of in contenders.iter() {
        let expected = of.beside.expected_columns();
        columns.retain(|column| expected.contains(column));
    }
    let without = (weights.log_evidence)(plain, &columns)?;
    for of in contenders.iter_mut() {
        of.adds = (weights.log_evidence)(&of.beside, &columns)? - without;
    }
    contenders.sort_by(|a, b| b.adds.total_cmp(&a.adds));
    Ok(())
}

/// Effects that are not told apart from what was found.
fn in_set(diagnosis: &Diagnosis) -> impl Iterator<Item = EffectId> + '_ {
    diagnosis.equivalence_set.iter().filter_map(|of| match of {
        Explanation::Effect(id) => Some(*id),
        Explanation::Unknown(_) => None,
    })
}

/// Effects that may be what is missing: what was found, what is not told apart from it, and the likeliest alone. Of two that turn the slip alike, each
/// brings the other.
fn in_question(diagnosis: &Diagnosis) -> Vec<EffectId> {
    let found = diagnosis.effects.iter().map(|found| found.id);
    let most = diagnosis.alone.first().map_or(0.0, |(_, log_bayes)| *log_bayes);
    let likely = |(_, log_bayes): &&(EffectId, f64)| *log_bayes > LEAST_SHARE * most.max(0.0);
    let alone = diagnosis.alone.iter().filter(likely).map(|(id, _)| *id);
    let mut ids = Vec::new();
    for id in found.chain(in_set(diagnosis)).chain(alone) {
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
