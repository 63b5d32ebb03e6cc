//! `soilctl diagnose`: where model and measurement disagree, which effect is missing, and the gap after it is added.

mod answer;
mod figures;
mod files;
mod page;
mod recorded;
mod resimulated;
mod self_test;
mod traces;

use std::path::{Path, PathBuf};

pub(crate) use answer::DiagnosisAnswer;
pub(crate) use self_test::SelfTestAnswer;
use soilctl_campaign::CampaignError;
use soilctl_diagnosis::{Data, Diagnosis, Surface, diagnose};
use soilctl_earth_pressure::model;
use soilctl_effects::{EffectEntry, Loaded, ModelFile};
use soilctl_strokes::{Campaign, ReadOptions, StrokeTable};

use self::recorded::Recorded;
use self::resimulated::{Resimulated, first_log, resimulate};
use super::Outcome;
use super::pages::{self, FigureFiles};
use crate::error::CliError;
use crate::output::Output;

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Writes patch.json (the model file), predictions.csv, gap.csv, next_experiment.csv and report.html into --out."
)]
pub(crate) struct Args {
    /// Folder with strokes.csv and, beside it, campaign.json and traces.csv
    #[arg(value_name = "DIR", required_unless_present = "self_test", conflicts_with = "self_test")]
    dir: Option<PathBuf>,

    /// Force model without effects: table (the bracket of bounds), chen, log-spiral, caquot, coulomb, ...
    #[arg(long, value_name = "NAME", default_value = "table")]
    model: String,

    /// A model file instead, such as the patch of an earlier diagnosis: its force model, and its effects as known ones
    #[arg(long, value_name = "PATCH", conflicts_with_all = ["model", "self_test"])]
    model_file: Option<PathBuf>,

    /// Traces of the strokes [default: DIR/traces.csv, if it is there]
    #[arg(long, value_name = "FILE", conflicts_with = "self_test")]
    traces: Option<PathBuf>,

    /// Run the campaign again on the simulated arm, without and with what is found, and compare the traces; LOGS is the folder
    /// of its logs [default: DIR]
    #[arg(long, value_name = "LOGS", num_args = 0..=1, conflicts_with = "self_test")]
    resimulate: Option<Option<PathBuf>>,

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

/// What a campaign is held against.
struct Against {
    /// Id of the force model.
    model: String,
    /// The model file that it comes from, with its path.
    file: Option<(String, ModelFile)>,
}

impl Against {
    fn read(args: &Args, data: &mut Data) -> Result<Self, CliError> {
        let Some(path) = &args.model_file else { return Ok(Self { model: args.model.clone(), file: None }) };
        let known = Loaded::read(path)?;
        data.know(&known);
        let file = known.file().clone();
        Ok(Self { model: file.model.clone(), file: Some((path.display().to_string(), file)) })
    }

    /// Effects of the model file.
    fn known(&self) -> &[EffectEntry] {
        self.file.as_ref().map_or(&[], |(_, file)| &file.effects)
    }

    /// In words.
    fn described(&self) -> String {
        let ids: Vec<&str> = self.known().iter().map(|known| known.id.name()).collect();
        if ids.is_empty() { self.model.clone() } else { format!("{} with {}", self.model, ids.join(", ")) }
    }
}

/// Everything that answer, files and page are made of.
struct Work {
    title: String,
    against: Against,
    data: Data,
    diagnosis: Diagnosis,
    recorded: Option<Recorded>,
    simulated: Simulated,
}

/// The campaign on the simulated arm, without effects and with those that were found.
#[derive(Default)]
struct Simulated {
    before: Option<Resimulated>,
    after: Option<Resimulated>,
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    let Some(dir) = &args.dir else { return self_test::run(args, output) };
    let strokes = dir.join("strokes.csv");
    let out = args.out.clone().unwrap_or_else(|| dir.join("diagnosis"));
    let work = work(args, dir, &strokes, &out, output)?;
    std::fs::create_dir_all(&out)
        .map_err(|problem| CliError::File { path: out.display().to_string(), problem })?;
    let written = files::write(&work, &strokes, &out)?;
    let answer = DiagnosisAnswer::new(&work, &written);
    pages::write(&mut page::render(&work, &answer)?, Some(&written.report), &args.figures, output)?;
    output.answer(&answer)?;
    Ok(Outcome::Done)
}

fn work(args: &Args, dir: &Path, strokes: &Path, out: &Path, output: &Output) -> Result<Work, CliError> {
    let table = StrokeTable::read(strokes, ReadOptions { allow_zero_sd: false })?;
    let campaign = Campaign::read_beside(strokes)?.unwrap_or_default();
    let mut data = Data::new(table.name(), table.rows().collect(), campaign)?;
    // `process` takes the tare off; of a table of somebody else nobody knows.
    if table.unknown_columns().any(|column| column.name() == "failure_time_s") {
        data.tare_taken_off();
    }
    let recorded = Recorded::read(args.traces.as_deref(), dir, &table)?;
    let recorded = recorded.map(|recorded| recorded.added(&mut data));
    let against = Against::read(args, &mut data)?;
    let ends = (data.levels_deg[0], data.levels_deg[data.levels_deg.len() - 1]);
    let surface = Surface::new(model(&against.model)?, ends)?;
    let weigh = |data: &Data| -> Result<Diagnosis, CliError> {
        let spinner = output.spinner("weighing explanations");
        let found = diagnose(data, &surface)?;
        spinner.finish_and_clear();
        Ok(found)
    };
    let mut diagnosis = weigh(&data)?;
    let mut simulated = Simulated::default();
    if let Some(logs) = &args.resimulate {
        let log = first_log(logs.as_deref().unwrap_or(dir))?;
        let file = files::model_file(&against, &data, &diagnosis, &[]);
        let mut plain = files::without_effects(&file, against.known().len(), &diagnosis.comparison);
        let with =
            if plain.effects.is_empty() { "without effects" } else { "with the effects that are known" };
        output.note(&format!("the same commands on the simulated arm, {with}"));
        simulated.before = loop {
            match resimulate(&log, &plain, &data.campaign, out, output) {
                // What is known and cannot be simulated is left out there.
                Err(CliError::Campaign(ref problem @ CampaignError::Effect { effect, .. })) => {
                    output.note(&problem.to_string());
                    plain.effects.retain(|known| known.id != effect);
                }
                simulated => break simulated?,
            }
        };
        if let Some(before) = &simulated.before {
            data.expect(&before.data, !plain.effects.is_empty());
            diagnosis = weigh(&data)?;
        }
        if !diagnosis.effects.is_empty() && simulated.before.is_some() {
            let file = files::model_file(&against, &data, &diagnosis, &[]);
            output.note("the same commands on the simulated arm, with the effects");
            match resimulate(&log, &file, &data.campaign, out, output) {
                Ok(after) => simulated.after = after,
                // An effect that the simulated arm cannot show stays named.
                Err(CliError::Campaign(problem @ CampaignError::Effect { .. })) => {
                    output.note(&problem.to_string());
                }
                Err(problem) => return Err(problem),
            }
        }
    }
    let title = dir.file_name().map_or_else(|| "campaign".into(), |name| name.to_string_lossy().into_owned());
    Ok(Work { title, against, data, diagnosis, recorded, simulated })
}
