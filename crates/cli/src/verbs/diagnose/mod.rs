//! `soilctl diagnose`: where model and measurement disagree, which effect is missing, and the gap after it is added.

mod answer;
mod figures;
mod files;
mod page;
mod self_test;

use std::path::{Path, PathBuf};

pub(crate) use answer::DiagnosisAnswer;
pub(crate) use self_test::SelfTestAnswer;
use soilctl_diagnosis::{Data, Diagnosis, Surface, diagnose};
use soilctl_earth_pressure::model;
use soilctl_strokes::{Campaign, ReadOptions, StrokeTable};

use super::Outcome;
use super::pages::{self, FigureFiles};
use crate::error::CliError;
use crate::output::Output;

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Writes patch.json (the model file), predictions.csv, next_experiment.csv and report.html into --out."
)]
pub(crate) struct Args {
    /// Folder with strokes.csv and, beside it, campaign.json
    #[arg(value_name = "DIR", required_unless_present = "self_test", conflicts_with = "self_test")]
    dir: Option<PathBuf>,

    /// Force model without effects: table (the bracket of bounds), chen, log-spiral, caquot, coulomb, ...
    #[arg(long, value_name = "NAME", default_value = "table")]
    model: String,

    /// Folder to write to [default: DIR/diagnosis]
    #[arg(long, value_name = "DIR2", conflicts_with = "self_test")]
    out: Option<PathBuf>,

    #[command(flatten)]
    figures: FigureFiles,

    /// Diagnose hidden campaigns instead, and count how often it is right
    #[arg(long)]
    self_test: bool,

    /// Rounds of the self-test; one round is about 80 campaigns
    #[arg(long, value_name = "N", default_value_t = 1, requires = "self_test")]
    rounds: u64,

    /// Seed of the self-test
    #[arg(long, value_name = "N", default_value_t = 1, requires = "self_test")]
    seed: u64,
}

/// Everything that answer, files and page are made of.
struct Work {
    title: String,
    model: String,
    data: Data,
    diagnosis: Diagnosis,
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    let Some(dir) = &args.dir else { return self_test::run(args, output) };
    let strokes = dir.join("strokes.csv");
    let spinner = output.spinner("weighing explanations");
    let work = work(args, dir, &strokes)?;
    spinner.finish_and_clear();
    let out = args.out.clone().unwrap_or_else(|| dir.join("diagnosis"));
    std::fs::create_dir_all(&out)
        .map_err(|problem| CliError::File { path: out.display().to_string(), problem })?;
    let written = files::write(&work, &strokes, &out)?;
    let answer = DiagnosisAnswer::new(&work, &written);
    pages::write(&mut page::render(&work, &answer)?, Some(&written.report), &args.figures, output)?;
    output.answer(&answer)?;
    Ok(Outcome::Done)
}

fn work(args: &Args, dir: &Path, strokes: &Path) -> Result<Work, CliError> {
    let table = StrokeTable::read(strokes, ReadOptions { allow_zero_sd: false })?;
    let campaign = Campaign::read_beside(strokes)?.unwrap_or_default();
    let data = Data::new(table.name(), table.rows().collect(), campaign)?;
    let ends = (data.levels_deg[0], data.levels_deg[data.levels_deg.len() - 1]);
    let surface = Surface::new(model(&args.model)?, ends)?;
    let diagnosis = diagnose(&data, &surface)?;
    let title = dir.file_name().map_or_else(|| "campaign".into(), |name| name.to_string_lossy().into_owned());
    Ok(Work { title, model: args.model.clone(), data, diagnosis })
}
