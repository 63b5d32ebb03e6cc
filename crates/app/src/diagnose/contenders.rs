//! Effects that could explain a campaign, each simulated whole, and ranked by all readings.
//!
//! Responses that are learnt from single strokes are those of an arm without effects. An effect that keeps a plate from sinking changes what all others
//! do, and what responses leave over was taken for a second effect. So those that come into question are simulated in the whole campaign.

use soilctl_campaign::CampaignError;
use soilctl_diagnosis::{Data, Diagnosis, Explanation};
use soilctl_effects::{EffectId, Loaded};

use super::Against;
use super::resimulated::{Again, model_file};
use crate::AppError;

/// ln evidence that an effect must add to all readings of the simulated arm: as in the search.
const ADDS: f64 = 3.6;
/// An effect is as likely as the best if its ln evidence lies behind by less than this, or by less than this part of what the best adds: a twin
/// is not the arm. Empirical.
const AS_LIKELY: (f64, f64) = (5.0, 0.1);
/// Most effects that are simulated alone, and the part of the best one's ln Bayes factor that one must have alone to be tried.
const MOST: usize = 5;
const LEAST_SHARE: f64 = 0.2;

/// How data are weighed: the diagnosis, and ln of the probability of all readings with what is known and nothing else.
pub(super) struct Weights<'a> {
    pub(super) diagnosis: &'a dyn Fn(&Data) -> Result<Diagnosis, AppError>,
    pub(super) log_evidence: &'a dyn Fn(&Data) -> Result<f64, AppError>,
}

/// A set of effects with what it explains.
struct Contender {
    ids: Vec<EffectId>,
    log_evidence: f64,
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
        let plain = (weights.log_evidence)(data)?;
        let mut singles = Vec::new();
        for id in in_question(diagnosis) {
            match self.contender(against, data, &[id], weights)? {
                Some(contender) => singles.push(contender),
                None if found == [id] => return Ok(()),
                None => {}
            }
        }
        singles.sort_by(|a, b| b.log_evidence.total_cmp(&a.log_evidence));
        let Some(first) = singles.first() else { return Ok(()) };
        let mut best = Contender { ids: first.ids.clone(), log_evidence: first.log_evidence };
        for id in found.iter().filter(|id| !first.ids.contains(id)) {
            let pair = [first.ids.as_slice(), &[*id]].concat();
            if let Some(more) = self.contender(against, data, &pair, weights)?
                && more.log_evidence > best.log_evidence + ADDS
            {
                best = more;
            }
        }
        if found.len() > 2
            && let Some(all) = self.contender(against, data, &found, weights)?
            && all.log_evidence > best.log_evidence + ADDS
        {
            best = all;
        }
        let added = best.log_evidence - plain;
        let behind = AS_LIKELY.0.max(AS_LIKELY.1 * added);
        let close = |of: &&Contender| of.log_evidence > best.log_evidence - behind && of.ids != best.ids;
        let as_likely: Vec<EffectId> = match best.ids.len() {
            1 => singles.iter().filter(close).flat_map(|of| of.ids.clone()).collect(),
            _ => Vec::new(),
        };
        let names = |ids: &[EffectId]| ids.iter().map(|id| id.name()).collect::<Vec<_>>().join(", ");
        for of in singles.iter().chain(Some(&best).filter(|best| best.ids.len() > 1)) {
            self.watch.note(&format!(
                "the simulated arm with {}: ln evidence of all readings {:+.1}",
                names(&of.ids),
                of.log_evidence - plain
            ));
        }
        data.decide(&best.ids, &as_likely);
        *diagnosis = (weights.diagnosis)(data)?;
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
        let model_n: Result<Vec<f64>, _> = simulated.data.rows.iter().map(|row| model.force_n(row)).collect();
        if let Ok(model_n) = model_n {
            beside.expect_scene(&simulated.data, &model_n);
        }
        let log_evidence = (weights.log_evidence)(&beside)?;
        Ok(Some(Contender { ids: ids.to_vec(), log_evidence }))
    }
}

/// Effects that may be what is missing: what was found, what is not told apart from it, and the likeliest alone.
fn in_question(diagnosis: &Diagnosis) -> Vec<EffectId> {
    let found = diagnosis.effects.iter().map(|found| found.id);
    let equivalent = diagnosis.equivalence_set.iter().filter_map(|of| match of {
        Explanation::Effect(id) => Some(*id),
        Explanation::Unknown(_) => None,
    });
    let most = diagnosis.alone.first().map_or(0.0, |(_, log_bayes)| *log_bayes);
    let likely = |(_, log_bayes): &&(EffectId, f64)| *log_bayes > LEAST_SHARE * most.max(0.0);
    let alone = diagnosis.alone.iter().filter(likely).map(|(id, _)| *id);
    let mut ids = Vec::new();
    for id in found.chain(equivalent).chain(alone) {
        if !ids.contains(&id) && ids.len() < MOST {
            ids.push(id);
        }
    }
    ids
}
