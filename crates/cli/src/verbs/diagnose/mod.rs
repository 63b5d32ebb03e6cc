//! `soilctl diagnose`: where model and measurement disagree, which effect is missing, and the gap after it is added.

mod self_test;
mod self_test_logs;
mod words;

use std::path::PathBuf;

use clap::builder::ArgPredicate;
use soilctl_app::diagnose::{self, Request};
use soilctl_app::{Answer as _, Outcome};

use super::pages::FigureFiles;
use crate::error::CliError;
use crate::output::Output;

#[derive(Debug, clap::Args)]
#[command(
    group = clap::ArgGroup::new("hidden_campaigns").args(["self_test", "self_test_logs"]),
    after_help = "Writes patch.json (the model file), predictions.csv, gap.csv, next_experiment.csv and report.html into --out; with logs of soilctl twin.json, the model file for the simulated arm, too.",
    // Hidden campaigns are in no folder; the name that stands for theirs is never used.
    mut_arg("dir", |dir| dir.required(false).required_unless_present("hidden_campaigns").conflicts_with("hidden_campaigns")
        .default_value_ifs([
            ("self_test", ArgPredicate::Equals("true".into()), Some("hidden campaigns")),
            ("self_test_logs", ArgPredicate::IsPresent, Some("hidden campaigns")),
        ])),
    mut_arg("model_file", |file| file.conflicts_with("hidden_campaigns")),
    mut_arg("traces", |traces| traces.conflicts_with("hidden_campaigns")),
    mut_arg("logs", |logs| logs.conflicts_with("hidden_campaigns")),
    mut_arg("no_resimulate", |none| none.conflicts_with("hidden_campaigns")),
    mut_arg("out", |out| out.conflicts_with("hidden_campaigns"))
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

    /// Diagnose hidden campaigns in logs of simulated arms that the twin does not know, and count how often it is right: they are made
    /// in this folder, and a run that was ended goes on there
    #[arg(long, value_name = "FOLDER")]
    self_test_logs: Option<PathBuf>,

    /// Hidden campaigns with logs; every third hides nothing, the others an effect in turn
    #[arg(long, value_name = "N", default_value_t = diagnose::self_test_logs::Request::default().campaigns,
          requires = "self_test_logs", value_parser = clap::value_parser!(u64).range(1..=10_000))]
    campaigns: u64,

    /// Strokes of a campaign with logs
    #[arg(long, value_name = "N", value_enum, default_value_t = diagnose::self_test_logs::Design::default(), requires = "self_test_logs")]
    strokes: diagnose::self_test_logs::Design,

    /// Hide this effect in all campaigns with logs, or `none`, or `outside`: in turn six kinds that no effect is, which takes 24 strokes or 48
    #[arg(long, value_name = "EFFECT", requires = "self_test_logs")]
    hidden: Option<String>,

    /// Preset of the sand of all campaigns with logs, instead of four in turn
    #[arg(long, value_name = "PRESET", requires = "self_test_logs")]
    soil: Option<String>,

    /// Where the answer of a campaign with logs leaves several effects open, run the plan that it proposes on the same arm, too
    #[arg(long, requires = "self_test_logs")]
    follow_up: bool,

    /// Seed of hidden campaigns
    #[arg(long, value_name = "N", default_value_t = diagnose::self_test::Request::default().seed,
          requires = "hidden_campaigns")]
    seed: u64,
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    if let Some(folder) = &args.self_test_logs {
        let test = diagnose::self_test_logs::Request {
            folder: folder.clone(),
            model: args.request.model.clone(),
            campaigns: args.campaigns,
            strokes: args.strokes,
            hidden: args.hidden.clone(),
            soil: args.soil.clone(),
            follow_up: args.follow_up,
            seed: args.seed,
        };
        let answer = diagnose::self_test_logs::run(&test, output)?;
        output.answer(&answer)?;
        return Ok(answer.outcome());
    }
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
