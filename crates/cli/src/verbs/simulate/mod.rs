//! `soilctl simulate FILE`: a whole campaign on the simulated arm, a log a batch.

mod answer;
mod progress;

use std::path::PathBuf;

use soilctl_campaign::{Options, Plan, simulate};
use soilctl_effects::ModelFile;

use super::Outcome;
use crate::error::CliError;
use crate::output::Output;
pub(crate) use answer::SimulateAnswer;
use progress::Progress;

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Writes into DIR: batch_000.mcap and so on, one log for each preparation of the soil; campaign.json; and \
    simulation.json, which says what is done. The same plan and seed give the same bytes for any number of threads. \
    Ctrl-C keeps the batches that are finished; the same command goes on with the others. Exit code 3: not all strokes were \
    made. Plans for tables 6.2 and 6.3 of the thesis are in data/plans; docs/campaigns.md describes the format."
)]
pub(crate) struct Args {
    /// A campaign plan (.toml)
    file: PathBuf,

    /// Folder for the logs; made if it is not there
    #[arg(long, value_name = "DIR")]
    out: PathBuf,

    /// Seed of noise and scatter [default: that of the plan]
    #[arg(long, value_name = "N")]
    seed: Option<u64>,

    /// Batches that run at a time; results are the same for any number [default: all cores]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1024))]
    threads: Option<u32>,

    /// Model file whose soil, force model and effects replace those of the plan
    #[arg(long, value_name = "PATCH")]
    model_file: Option<PathBuf>,
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    let plan = Plan::read(&args.file)?;
    let model_file = match &args.model_file {
        Some(path) => Some((ModelFile::read(path)?, path.display().to_string())),
        None => None,
    };
    let cores = || std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    let options = Options {
        out: &args.out,
        seed: args.seed.unwrap_or(plan.file().seed),
        threads: args.threads.map_or_else(cores, |threads| threads as usize),
    };
    let model_file = model_file.as_ref().map(|(file, name)| (file, name.as_str()));
    let answer = campaign(&plan, model_file, &options, output)?;
    output.answer(&answer)?;
    Ok(if answer.is_whole() { Outcome::Done } else { Outcome::Partial })
}

/// Runs a campaign, or what is left of one, and shows how far it is.
pub(crate) fn campaign(
    plan: &Plan,
    model_file: Option<(&ModelFile, &str)>,
    options: &Options<'_>,
    output: &Output,
) -> Result<SimulateAnswer, CliError> {
    // What is finished stays.
    let stop = output.interrupt();
    let progress = Progress::new(output, plan);
    let report = simulate(plan, model_file, options, &stop, &|notice| progress.show(&notice))?;
    progress.end();
    Ok(SimulateAnswer::new(plan, options, report))
}
