//! `soilctl diagnose`: where model and measurement disagree, which effect is missing, and the gap after it is added.

mod self_test;
mod words;

use soilctl_app::diagnose::{self, Request};
use soilctl_app::{Answer as _, Outcome};

use super::pages::FigureFiles;
use crate::error::CliError;
use crate::output::Output;

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Writes patch.json (the model file), predictions.csv, gap.csv, next_experiment.csv and report.html into --out.",
    // Hidden campaigns are in no folder; the name that stands for theirs is never used.
    mut_arg("dir", |dir| dir.required(false).required_unless_present("self_test").conflicts_with("self_test")
        .default_value_if("self_test", "true", "hidden campaigns")),
    mut_arg("model_file", |file| file.conflicts_with("self_test")),
    mut_arg("traces", |traces| traces.conflicts_with("self_test")),
    mut_arg("logs", |logs| logs.conflicts_with("self_test")),
    mut_arg("no_resimulate", |none| none.conflicts_with("self_test")),
    mut_arg("out", |out| out.conflicts_with("self_test"))
)]
pub(crate) struct Args {
    #[command(flatten)]
    request: Request,

    #[command(flatten)]
    figures: FigureFiles,

    /// Diagnose hidden campaigns instead, and count how often it is right
    #[arg(long)]
    self_test: bool,

    /// Rounds of the self-test; one round is about 80 campaigns
    #[arg(long, value_name = "N", default_value_t = diagnose::self_test::Request::default().rounds,
          requires = "self_test")]
    rounds: u64,

    /// Seed of the self-test
    #[arg(long, value_name = "N", default_value_t = diagnose::self_test::Request::default().seed,
          requires = "self_test")]
    seed: u64,
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    if args.self_test {
        let Args { request, rounds, seed, .. } = args;
        let test =
            diagnose::self_test::Request { model: request.model.clone(), rounds: *rounds, seed: *seed };
        let answer = diagnose::self_test::run(&test, output)?;
        output.answer(&answer)?;
        return Ok(answer.outcome());
    }
    let mut found = diagnose::run(&args.request, output)?;
    soilctl_pages::diagnose::write(&mut found, args.figures.figures.as_deref(), output.command())?;
    output.answer(&found.answer)?;
    Ok(found.answer.outcome())
}
