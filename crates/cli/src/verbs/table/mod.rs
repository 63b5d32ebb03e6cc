//! `soilctl table`: shows, builds, extends, unites and checks prediction tables.

mod words;

use clap::Subcommand;
use soilctl_app::table::{build, check, merge, show};
use soilctl_app::{Answer as _, Outcome};

use crate::error::CliError;
use crate::output::Output;

#[derive(Debug, clap::Args)]
pub(crate) struct Args {
    #[command(subcommand)]
    action: Action,
}

#[derive(Debug, Subcommand)]
enum Action {
    /// Prints a table
    Show(show::Request),
    /// Fills a table, with proven bounds or from another model; fills what is missing in one that is there
    #[command(
        after_help = "Nodes at which the model has no answer (delta above phi among them) stay empty.\n\n\
    Bounds take hours: each case goes to FILE.partial.jsonl as soon as it is solved, and the same command goes on from \
    there, also after Ctrl-C (exit code 3) or a power cut. With --store a case goes there instead: any number of runs may share \
    one, on any machines that see the folder, and one with --out makes the table of it. On a finished file, a larger grid fills only what is missing. \
    Same options, same bytes: for any number of threads, interruptions or shards."
    )]
    Build(Box<build::Request>),
    /// Unites the tables of bounds that `build --shard` made
    Merge(merge::Request),
    /// Checks a table; exit code 1 if a coefficient does not grow with alpha, phi or delta
    Check(check::Request),
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    let answer = match &args.action {
        Action::Show(request) => show::run(request, output)?,
        Action::Build(request) => build::run(request, output)?,
        Action::Merge(request) => merge::run(request, output)?,
        Action::Check(request) => check::run(request, output)?,
    };
    output.answer(&answer)?;
    Ok(answer.outcome())
}
