//! The same commands on the simulated arm: what it reads without the effects, and with those that were found.

use std::path::Path;
use std::sync::atomic::Ordering;

use soilctl_campaign::{CampaignError, Plan};
use soilctl_diagnosis::{Course, Data, Diagnosis, FoundEffect, RecordedTraces};
use soilctl_effects::{EffectId, Loaded, ModelFile, SoilEntry};
use soilctl_jobs::fnv1a;
use soilctl_strokes::Campaign;

use super::Against;
use super::contenders::{Weights, hold};
use super::kept::{Kept, kept};
use super::learn::{Learning, Progress};
use super::logs::Resimulation;
use crate::machine::cores;
use crate::{AppError, Interrupted, Watch};

/// Noise of the campaign that is simulated again must not be that of the first one.
const OTHER_NOISE: u64 = 0x5eed;

/// The campaign on the simulated arm, without effects and with those that were found.
#[derive(Default)]
pub struct Simulated {
    /// Without the effects that were found.
    pub before: Option<Resimulated>,
    /// With them.
    pub after: Option<Resimulated>,
    /// What it was simulated with: what was found, and the soil that all signals ask for beside it.
    pub(super) twin: Option<ModelFile>,
}

/// A campaign that was simulated again.
pub struct Resimulated {
    /// What its logs gave.
    pub data: Data,
    /// Courses of the force, by stroke of `data`.
    courses: Vec<Option<Course>>,
}

impl Resimulated {
    /// Course and failure force in N of the stroke with a name; `None` if it was not made.
    #[must_use]
    pub fn stroke(&self, stroke_id: &str) -> Option<(&Course, f64)> {
        let place = self.data.rows.iter().position(|row| row.stroke_id.as_deref() == Some(stroke_id))?;
        Some((self.courses.get(place)?.as_ref()?, self.data.rows[place].force_n))
    }
}

/// What is simulated again, and where its files go.
pub(super) struct Again<'a> {
    pub(super) plan: Plan,
    pub(super) seed: u64,
    pub(super) out: &'a Path,
    /// Whether the campaign is also run with what was found.
    pub(super) shows_found: bool,
    pub(super) watch: &'a dyn Watch,
}

impl Again<'_> {
    /// Runs the campaign without effects, weighs explanations by what the simulated arm reads, and runs it with what is found. What is
    /// ended by the user before explanations are weighed leaves the diagnosis of the table as it was.
    pub(super) fn compare(
        &self,
        against: &Against,
        data: &mut Data,
        diagnosis: &mut Diagnosis,
        weights: &Weights<'_>,
    ) -> Result<(Simulated, Resimulation), AppError> {
        let stop = self.watch.stop(Interrupted::KeepsResults);
        let stopped = || stop.load(Ordering::Relaxed);
        let ended = |simulated| {
            let how = if stopped() { Resimulation::Stopped } else { Resimulation::NotPossible };
            Ok((simulated, how))
        };
        let (before, plain) = self.before(against, data, model_file(against, data, diagnosis))?;
        let Some(mut before) = before else { return ended(Simulated::default()) };
        let of_table = data.clone();
        if self.expect(&before, &plain, data)? == Progress::Stopped {
            *data = of_table;
            return ended(Simulated::default());
        }
        *diagnosis = (weights.diagnosis)(data)?;
        // The soil was that which the table asks for: with the one that all signals ask for, less may be missing.
        if diagnosis.has_found()
            && let soil = by_signals(against, data, diagnosis, &[], weights)?
            && let (Some(again), plain) = self.before(against, data, soil)?
        {
            let mut recalibrated = of_table;
            if self.expect(&again, &plain, &mut recalibrated)? == Progress::Done {
                *data = recalibrated;
                *diagnosis = (weights.diagnosis)(data)?;
                before = again;
            }
        }
        let beside_arm = self.contest(against, data, diagnosis, weights)?;
        let twin = twin(against, data, diagnosis, beside_arm, weights)?;
        let after = self.after(&twin, data, diagnosis)?;
        let how = if stopped() { Resimulation::Stopped } else { Resimulation::Compared };
        Ok((Simulated { before: Some(before), after, twin: Some(twin) }, how))
    }

    /// Simulates a model file without the effects that were found; the file of that, with the effects that are known and can be simulated.
    fn before(
        &self,
        against: &Against,
        data: &Data,
        mut plain: ModelFile,
    ) -> Result<(Option<Resimulated>, ModelFile), AppError> {
        // The soil as it was fitted beside what was found: without, it takes a part of an effect, and the simulated arm would show it, too.
        plain.effects.truncate(against.known().len());
        plain.empirical.truncate(data.known_terms().len());
        // An interface friction off its set-point is what is looked for: the fit of forces would take it for the soil's, and then every
        // signal of the simulated arm had it.
        plain.soil.delta_offset_deg.value = 0.0;
        let with =
            if plain.effects.is_empty() { "without effects" } else { "with the effects that are known" };
        self.watch.note(&format!(
            "the same {} strokes on the simulated arm, {with}; --no-resimulate reads the table alone",
            self.plan.strokes().strokes().len()
        ));
        let before = loop {
            match self.simulate(&plain, &data.campaign, None) {
                // What is known and cannot be simulated is left out there.
                Err(AppError::Campaign(ref problem @ CampaignError::Effect { effect, .. })) => {
                    self.watch.note(&problem.to_string());
                    plain.effects.retain(|known| known.id != effect);
                }
                Err(AppError::Campaign(ref problem @ CampaignError::Term { over, .. })) => {
                    self.watch.note(&problem.to_string());
                    plain.empirical.retain(|term| !term.over.contains(&over));
                }
                found => break found?,
            }
        };
        Ok((before, plain))
    }

    /// Puts what the simulated arm read into the data: what is to be expected of each signal, what the scene makes of the forces, and how
    /// signals respond to effects.
    fn expect(&self, before: &Resimulated, plain: &ModelFile, data: &mut Data) -> Result<Progress, AppError> {
        data.expect(&before.data, !plain.effects.is_empty(), plain.soil.delta_offset_deg.value);
        let model = Loaded::new(plain.clone(), "the simulated soil")?;
        expect_scene(data, &before.data, &model);
        let store = self.out.join("learnt");
        let candidates: Vec<EffectId> = EffectId::ALL
            .into_iter()
            .filter(|id| plain.effects.iter().all(|known| known.id != *id))
            .collect();
        let campaign = data.campaign.clone();
        Learning::new(&self.plan, plain, data, &campaign, &store, self.watch)?.all(data, &candidates)
    }

    /// Simulates with the effects or the term that were found; `None` without any, or if it was stopped.
    fn after(
        &self,
        twin: &ModelFile,
        data: &Data,
        diagnosis: &Diagnosis,
    ) -> Result<Option<Resimulated>, AppError> {
        if !diagnosis.has_found() || !self.shows_found {
            return Ok(None);
        }
        self.watch.note("the same commands on the simulated arm, with what was found");
        match self.simulate(twin, &data.campaign, None) {
            // An effect or a term that the simulated arm cannot show stays in the answer.
            Err(AppError::Campaign(
                problem @ (CampaignError::Effect { .. } | CampaignError::Term { .. }),
            )) => {
                self.watch.note(&problem.to_string());
                Ok(None)
            }
            after => after,
        }
    }

    /// Runs the plan of the log, or `only` some of its batches, with soil and effects of a model file, or reads what an earlier run left of it. `None` if it was stopped, or no stroke has a failure force.
    pub(super) fn simulate(
        &self,
        file: &ModelFile,
        campaign: &Campaign,
        only: Option<&[usize]>,
    ) -> Result<Option<Resimulated>, AppError> {
        // What was thought of the effects changes no stroke.
        let mut file = file.clone();
        "hand".clone_into(&mut file.status);
        (file.equivalence_set, file.held_out, file.data_hash) = (Vec::new(), None, String::new());
        file.effects.iter_mut().for_each(|effect| effect.log_bayes_factor = 0.0);
        let (seed, store) = (self.seed ^ OTHER_NOISE, self.out.join("resimulated"));
        let Some(Kept { strokes, traces }) =
            kept(&self.plan, &file, seed, only, &store, (cores(), self.watch))?
        else {
            return Ok(None);
        };
        let mut data = Data::new(strokes.name(), strokes.rows().collect(), campaign.clone())?;
        data.tare_taken_off();
        let courses = RecordedTraces::read(&traces, &strokes)?.add_to(&mut data).courses;
        Ok(Some(Resimulated { data, courses }))
    }
}

/// Takes what the scene makes of the forces of the simulated arm whose soil and effects are those of `model`. Where the force model has no answer
/// there is nothing to compare with.
pub(super) fn expect_scene(data: &mut Data, simulated: &Data, model: &Loaded) {
    let model_n: Result<Vec<f64>, _> = simulated.rows.iter().map(|row| model.force_n(row)).collect();
    if let Ok(model_n) = model_n {
        data.expect_scene(simulated, &model_n);
    }
}

/// The model file of what was found, with the soil that all signals ask for beside it. That of a diagnosis has the soil with which its formulas come nearest
/// to the forces, and these do not know the controller. `sizes` are those of effects that are known; strokes tell the others.
fn by_signals(
    against: &Against,
    data: &Data,
    diagnosis: &Diagnosis,
    sizes: &[FoundEffect],
    weights: &Weights<'_>,
) -> Result<ModelFile, AppError> {
    let mut of = data.clone();
    of.decide(&diagnosis.effects.iter().map(|found| found.id).collect::<Vec<_>>(), &[]);
    hold(&mut of, sizes);
    Ok((weights.fitted)(&of, &[])?.model_file(data, &against.model, against.known()))
}

/// The model file for the simulated arm: that of a diagnosis, with the soil that signals ask for. `beside_arm` is the soil that a contest told beside the arm with what
/// was found; without one it is fitted beside the sizes of the diagnosis. A term without a name is one of the formulas, and its soil is theirs, too.
fn twin(
    against: &Against,
    data: &Data,
    diagnosis: &Diagnosis,
    beside_arm: Option<SoilEntry>,
    weights: &Weights<'_>,
) -> Result<ModelFile, AppError> {
    let file = model_file(against, data, diagnosis);
    if !diagnosis.terms.is_empty() {
        return Ok(file);
    }
    let soil = match beside_arm {
        Some(soil) => soil,
        None => by_signals(against, data, diagnosis, &diagnosis.effects, weights)?.soil,
    };
    Ok(ModelFile { soil, ..file })
}

/// The model file of a diagnosis before it is written: of no stroke table.
pub(super) fn model_file(against: &Against, data: &Data, diagnosis: &Diagnosis) -> ModelFile {
    diagnosis.model_file(data, &against.model, against.known(), fnv1a(&[]))
}
