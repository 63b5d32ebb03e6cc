//! `soilctl table`: shows, builds, extends, unites and checks prediction tables.

mod answer;
mod bounds;
mod brackets;
mod build;
mod check;
mod check_brackets;
mod grid;
mod show;

use std::path::PathBuf;

pub(crate) use answer::TableAnswer;
use clap::Subcommand;

use super::Outcome;
use crate::error::CliError;
use crate::output::Output;
use soilctl_app::table_file as file;

#[derive(Debug, clap::Args)]
pub(crate) struct Args {
    #[command(subcommand)]
    action: Action,
}

#[derive(Debug, Subcommand)]
enum Action {
    /// Prints a table
    Show(Source),
    /// Fills a table, with proven bounds or from another model; fills what is missing in one that is there
    Build(build::Args),
    /// Unites the tables of bounds that `build --shard` made
    Merge(MergeArgs),
    /// Checks a table; exit code 1 if a coefficient does not grow with alpha, phi or delta
    Check(CheckArgs),
}

#[derive(Debug, clap::Args)]
struct MergeArgs {
    /// Files to unite, built by the same version with the same --max-gap and --max-elements
    #[arg(value_name = "FILE", required = true)]
    files: Vec<PathBuf>,

    /// File to write (.csv)
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
}

#[derive(Debug, clap::Args)]
struct CheckArgs {
    #[command(flatten)]
    source: Source,

    /// With a table of bounds: another table of lower or upper bounds, whose errors it proves; may be repeated
    #[arg(long, value_name = "FILE|NAME")]
    against: Vec<String>,
}

/// Where a table comes from.
#[derive(Debug, clap::Args)]
struct Source {
    /// A table file (.csv or .parquet, with its .json beside it) or a built-in table: appendix-c-coulomb,
    /// appendix-c-log-spiral, appendix-c-chen, appendix-c-caquot, appendix-c-num-ub, appendix-c-num-lb,
    /// plate-bounds
    #[arg(value_name = "FILE|NAME")]
    table: String,
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    let answer = match &args.action {
        Action::Show(source) => show::show(&source.table)?,
        Action::Build(build) => build::build(build, output)?,
        Action::Merge(merge) => brackets::merge(&merge.files, &merge.out)?,
        Action::Check(check) => check::check(&check.source.table, &check.against)?,
    };
    output.answer(&answer)?;
    Ok(answer.outcome())
}
