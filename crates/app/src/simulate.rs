//! A whole campaign on the simulated arm and soil, a log a batch.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_campaign::{BatchReport, Content, Notice, Options, Plan, simulate};
use soilctl_effects::ModelFile;

use crate::machine::cores;
use crate::{AppError, Interrupted, Outcome, Watch};

/// Runs a campaign on the simulated arm and soil, a log for each batch.
#[derive(Debug, Clone, Default, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
pub struct Request {
    /// A campaign plan (.toml)
    pub file: PathBuf,

    /// Folder for the logs; made if it is not there
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,

    /// Seed of noise and scatter [default: that of the plan]
    #[arg(long, value_name = "N")]
    pub seed: Option<u64>,

    /// Batches that run at a time; results are the same for any number [default: all cores]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1024))]
    #[schemars(range(min = 1, max = 1024))]
    pub threads: Option<u32>,

    /// Model file whose soil, force model and effects replace those of the plan
    #[arg(long, value_name = "PATCH")]
    pub model_file: Option<PathBuf>,
}

/// What a simulated campaign came to.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Answer {
    /// The folder with the logs.
    pub out: String,
    /// Seed of noise and scatter.
    pub seed: u64,
    /// Whether all batches of the plan are finished.
    pub complete: bool,
    /// Strokes of the plan.
    pub strokes: usize,
    /// Strokes that were made to their end.
    pub strokes_done: usize,
    /// Batches that were finished by an earlier run.
    pub resumed_batches: usize,
    /// Finished batches in order.
    pub batches: Vec<BatchReport>,
}

impl crate::Answer for Answer {
    const SCHEMA: &'static str = "soilctl.simulate/1";

    fn outcome(&self) -> Outcome {
        if self.complete && self.strokes_done == self.strokes { Outcome::Done } else { Outcome::Partial }
    }
}

/// Runs the campaign of a plan file, or what is left of it.
///
/// # Errors
/// [`AppError`] if plan or model file make no sense, or a log cannot be written.
pub fn run(request: &Request, watch: &dyn Watch) -> Result<Answer, AppError> {
    crate::request::check(request)?;
    let plan = Plan::read(&request.file)?;
    let model_file = match &request.model_file {
        Some(path) => Some((ModelFile::read(path)?, path.display().to_string())),
        None => None,
    };
    let options = Options {
        out: &request.out,
        seed: request.seed.unwrap_or(plan.file().seed),
        threads: request.threads.map_or_else(cores, |threads| threads as usize),
        content: Content::Whole,
        only: None,
    };
    let model_file = model_file.as_ref().map(|(file, name)| (file, name.as_str()));
    campaign(&plan, model_file, &options, watch)
}

/// Runs a campaign, or what is left of one. Batches that are finished stay, whatever ends the run.
///
/// # Errors
/// As [`run`].
pub fn campaign(
    plan: &Plan,
    model_file: Option<(&ModelFile, &str)>,
    options: &Options<'_>,
    watch: &dyn Watch,
) -> Result<Answer, AppError> {
    let stop = watch.stop(Interrupted::KeepsResults);
    let run = (0..plan.batches()).filter(|batch| options.runs(*batch));
    let strokes = run.map(|batch| plan.strokes_of(batch).len()).sum::<usize>();
    watch.begin(strokes as u64, "strokes");
    let report = simulate(plan, model_file, options, &stop, &|notice| match notice {
        Notice::Stroke { .. } => watch.advance(1),
        Notice::Finished { batch, report } => watch.note(&format!(
            "batch {} of {}: {} of {} strokes, {}",
            batch + 1,
            plan.batches(),
            report.strokes_done,
            report.strokes,
            report.log
        )),
        _ => {}
    });
    watch.end();
    let report = report?;
    Ok(Answer {
        out: options.out.display().to_string(),
        seed: options.seed,
        complete: report.complete,
        strokes,
        strokes_done: report.batches.iter().map(|batch| batch.strokes_done).sum(),
        resumed_batches: report.resumed,
        batches: report.batches,
    })
}
