//! `soilctl table`: shows, builds and checks prediction tables.

mod answer;
mod build;
mod check;
mod file;
mod grid;
mod show;

pub(crate) use answer::TableAnswer;
use clap::Subcommand;
pub(crate) use file::read_table;

use super::Outcome;
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
    Show(Source),
    /// Fills a table from a model
    Build(build::Args),
    /// Checks a table; exit code 1 if a coefficient does not grow with alpha, phi or delta
    Check(Source),
}

/// Where a table comes from.
#[derive(Debug, clap::Args)]
struct Source {
    /// A table file (.csv or .parquet, with its .json beside it) or a built-in table: appendix-c-coulomb,
    /// appendix-c-log-spiral, appendix-c-chen, appendix-c-caquot, appendix-c-num-ub, appendix-c-num-lb
    #[arg(value_name = "FILE|NAME")]
    table: String,
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    let answer = match &args.action {
        Action::Show(source) => show::show(&source.table)?,
        Action::Build(build) => build::build(build, output)?,
        Action::Check(source) => check::check(&source.table)?,
    };
    output.answer(&answer)?;
    Ok(answer.outcome())
}
