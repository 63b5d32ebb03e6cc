//! `soilctl`: from the force at which a plate fails soil to the soil's friction angle and density.

mod args;
mod error;
mod finite;
mod output;
mod text;
mod verbs;

use std::process::ExitCode;

use clap::Parser;

use crate::args::Cli;
use crate::output::Output;
use crate::verbs::Outcome;

/// Exit codes, here and nowhere else: 0 done; 1 done, and the answer is negative; 2 wrong usage or bad input;
/// 3 done in part.
fn main() -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(usage) => {
            // Help and version are an answer (0), anything else is wrong usage (2); a closed pipe changes neither.
            let _ = usage.print();
            return ExitCode::from(if usage.use_stderr() { 2 } else { 0 });
        }
    };
    let mut output = Output::new(cli.format, cli.quiet);
    match cli.verb.run(&mut output) {
        Ok(Outcome::Done) => ExitCode::SUCCESS,
        Ok(Outcome::Negative) => ExitCode::from(1),
        Ok(Outcome::Partial) => ExitCode::from(3),
        Err(error) if error.is_broken_pipe() => ExitCode::SUCCESS,
        Err(error) => {
            output.error(&error);
            ExitCode::from(2)
        }
    }
}
