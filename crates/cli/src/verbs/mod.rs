//! The verbs, one file each. A new verb is a module, a line in [`Verb`], a line in [`Verb::run`] and, if it answers in
//! JSON, a line in `schemas.rs`.

mod completions;
mod predict;
mod schemas;
mod table;

use clap::Subcommand;

use crate::error::CliError;
use crate::output::Output;

/// What there is to do.
#[derive(Debug, Subcommand)]
pub(crate) enum Verb {
    /// Force and coefficients of a plate from a named model
    Predict(predict::Args),
    /// Shows, builds and checks prediction tables
    Table(table::Args),
    /// Prints a completion script for a shell
    Completions(completions::Args),
    #[command(hide = true)]
    /// Writes the JSON schemas of all answers
    Schemas(schemas::Args),
}

/// How a verb that gave an answer ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Outcome {
    /// Done.
    Done,
    /// Done, and the answer is negative.
    Negative,
}

impl Verb {
    pub(crate) fn run(self, output: &mut Output) -> Result<Outcome, CliError> {
        match self {
            Self::Predict(args) => predict::run(&args, output),
            Self::Table(args) => table::run(&args, output),
            Self::Completions(args) => completions::run(&args, output),
            Self::Schemas(args) => schemas::run(&args),
        }
    }
}
