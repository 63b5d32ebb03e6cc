//! A whole campaign: batches side by side, a log each.

mod batch;
mod script;

use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize};

pub use batch::logged_truth;
use soilctl_effects::{Active, ModelFile};
use soilctl_jobs::each;
use soilctl_plant::Simulation;
use soilctl_session::{Content, SessionSetup};

use crate::effects::{self, PlantEffects};
use crate::journal::{BatchReport, Journal};
use crate::{CampaignError, Plan, describe, seed};

/// How a campaign is run.
#[derive(Debug, Clone, Copy)]
pub struct Options<'a> {
    /// Folder for logs, `campaign.json` and `simulation.json`; made if it is not there.
    pub out: &'a Path,
    /// Seed of noise and scatter.
    pub seed: u64,
    /// Threads, at least 1; results do not depend on it.
    pub threads: usize,
    /// Which topics the logs have.
    pub content: Content,
    /// Batches that are run, by number; all if `None`. Each is as it is in the whole campaign.
    pub only: Option<&'a [usize]>,
}

impl Options<'_> {
    /// Whether a batch is run.
    #[must_use]
    pub fn runs(&self, batch: usize) -> bool {
        self.only.is_none_or(|only| only.contains(&batch))
    }
}

/// What goes on, for whoever wants to see it. Notices of different batches come in any order.
#[derive(Debug, Clone, Copy)]
#[non_exhaustive]
pub enum Notice<'a> {
    /// A batch begins.
    Began {
        /// Its number.
        batch: usize,
    },
    /// A stroke has ended.
    Stroke {
        /// The batch.
        batch: usize,
        /// Number of the stroke in the plan, from 0.
        stroke: usize,
    },
    /// A batch is done and its log is in the folder.
    Finished {
        /// Its number.
        batch: usize,
        /// What it came to.
        report: &'a BatchReport,
    },
}

/// What a campaign came to.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Report {
    /// Finished batches in order.
    pub batches: Vec<BatchReport>,
    /// Batches that were there already.
    pub resumed: usize,
    /// Whether all batches that were asked for are finished.
    pub complete: bool,
}

/// Runs a campaign on the simulated arm, or what is left of one. Each batch has noise, scatter and a log of its own and
/// knows nothing of the others, so that the same plan and seed give the same bytes for any number of threads and however
/// often the run was interrupted. A log appears under its name when it is whole.
///
/// `model_file` and its name: soil and effects that replace those of the plan. When `stop` becomes true, batches that
/// are not finished are given up; a later call makes them. A failure sets it.
///
/// # Errors
/// [`CampaignError::Jobs`] if the folder holds something else, [`CampaignError::Effect`] for an effect that the
/// plant cannot show, [`CampaignError::File`] or [`CampaignError::Session`] if it cannot be written, and
/// [`CampaignError::Plant`] if a simulated arm leaves all bounds. Batches that were finished stay.
pub fn simulate(
    plan: &Plan,
    model_file: Option<(&ModelFile, &str)>,
    options: &Options<'_>,
    stop: &AtomicBool,
    notice: &(dyn Fn(Notice<'_>) + Sync),
) -> Result<Report, CampaignError> {
    let changed = model_file.map(|(file, name)| plan.with_model_file(file, name)).transpose()?;
    let (model_text, effects) = match model_file {
        Some((file, name)) => (text(file, name)?, effects::shown(file, name)?),
        None => Default::default(),
    };
    let job = Job {
        plan: changed.as_ref().unwrap_or(plan),
        model_file: model_file.map(|(file, _)| file),
        effects,
        model_text,
        out: options.out,
        seed: options.seed,
        content: options.content,
    };
    std::fs::create_dir_all(options.out).map_err(|error| CampaignError::file(options.out, &error))?;
    let mut journal = Journal::new(options.seed, &job.fingerprint()?, &job.model_text);
    journal.resume(options.out)?;
    journal.store(options.out)?;
    batch::remove_parts(options.out, plan.batches());
    describe::campaign(job.plan).write_beside(&options.out.join("strokes.csv"))?;
    let resumed = journal.finished.len();
    let is_finished =
        |journal: &Journal, batch: usize| journal.finished.iter().any(|report| report.batch == batch);
    let wanted: Vec<usize> = (0..plan.batches()).filter(|batch| options.runs(*batch)).collect();
    let todo: Vec<usize> = wanted.iter().copied().filter(|batch| !is_finished(&journal, *batch)).collect();
    each(
        &todo,
        options.threads,
        stop,
        |batch| batch::run(&job, *batch, stop, notice),
        |_, report| journal.add(report, job.out),
    )?;
    let complete = wanted.iter().all(|batch| is_finished(&journal, *batch));
    Ok(Report { resumed, complete, batches: journal.finished })
}

/// What all batches have in common.
struct Job<'a> {
    plan: &'a Plan,
    model_file: Option<&'a ModelFile>,
    effects: Vec<Active>,
    model_text: String,
    out: &'a Path,
    seed: u64,
    content: Content,
}

impl Job<'_> {
    /// Everything that decides what a campaign gives, beside its seed.
    fn fingerprint(&self) -> Result<String, CampaignError> {
        let setup = self.plan.setup(self.seed)?;
        let plant = self.plan.plant().config();
        Ok(format!("{}{}{}{plant:?}", setup.plan, setup.arm, setup.controller))
    }

    /// Arm, soil and record of a batch, and where its effects look up which stroke is being made.
    fn prepare(&self, batch: usize) -> Result<(Simulation, SessionSetup, Arc<AtomicUsize>), CampaignError> {
        let mut setup = self.plan.setup(self.seed)?;
        setup.content = self.content;
        let stroke = Arc::new(AtomicUsize::new(self.plan.strokes_of(batch).start));
        let mut simulation = self.plan.simulation(&setup, self.seed, batch)?;
        if let Some(file) = self.model_file {
            setup.notes.insert("model_file".to_owned(), self.model_text.clone());
            let effects = PlantEffects::new(&self.effects, file, self.plan, batch, Arc::clone(&stroke))?;
            simulation.plant_mut().set_effects(Box::new(effects));
        }
        if let Some(ground) = simulation.plant().ground() {
            let reading = seed::density_reading(self.seed, batch) * ground.density_kg_m3();
            batch::notes(&mut setup, batch, reading);
        }
        Ok((simulation, setup, stroke))
    }
}

fn text(file: &ModelFile, name: &str) -> Result<String, CampaignError> {
    serde_json::to_string(file)
        .map_err(|error| CampaignError::Plan { file: name.to_owned(), problem: error.to_string() })
}

impl Plan {
    /// The plan with the soil, the force model and the drives of a model file. The interface friction is the mean set-point
    /// of the strokes and the file's offset.
    pub(crate) fn with_model_file(&self, file: &ModelFile, name: &str) -> Result<Self, CampaignError> {
        let effects = effects::shown(file, name)?;
        let mut plan = self.clone();
        let strokes = self.strokes().strokes();
        #[allow(clippy::cast_precision_loss, reason = "at most 1024 strokes")]
        let set_deg = strokes.iter().map(|stroke| stroke.delta_rad.to_degrees()).sum::<f64>()
            / strokes.len().max(1) as f64;
        let found = &file.soil;
        plan.change(name, &file.model, |soil, plant| {
            soil.phi_deg = found.phi_deg.value;
            // What the file knows of stress is an effect.
            soil.friction_law = None;
            soil.delta_deg = (set_deg + found.delta_offset_deg.value).clamp(0.0, soil.phi_deg);
            soil.density_kg_m3 = found.density_kg_m3.value;
            soil.gravity_m_s2 = found.gravity_m_s2;
            effects::change_drives(&effects, self, plant);
        })?;
        Ok(plan)
    }
}
