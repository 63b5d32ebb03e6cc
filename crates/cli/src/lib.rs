//! `soilctl`: from the force at which a plate fails soil to the soil's friction angle and density.
//!
//! The program and the command that the Python package installs are both [`run`]; [`answer`] gives other programs the
//! same answers without a process of their own.

mod args;
mod bag_args;
mod command;
mod error;
mod output;
mod progress;
mod verbs;

use std::ffi::OsString;
use std::io::Write;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use clap::{CommandFactory, Parser};

use crate::args::Cli;
use crate::output::Output;
pub use crate::progress::Progress;

/// Runs the command line `args`, the program's name first; answers go to standard output, all else to standard error.
///
/// Exit codes, here and nowhere else: 0 done; 1 done, and the answer is negative; 2 wrong usage or bad input; 3 done
/// in part.
pub fn run(args: impl IntoIterator<Item = OsString>) -> u8 {
    let code = exit_code(args);
    // A host program that is not written in Rust does not do it; a closed pipe changes no exit code.
    let _ = std::io::stdout().flush();
    code
}

/// What is said to somebody who types the name alone.
const FIRST_STEPS: &str = "error: a verb is missing. Three that need no file:

  soilctl predict --model chen --alpha 80 --phi 40 --delta 25 --density 1600 --depth 0.025 --width 0.127
  soilctl bound --alpha 90 --phi 30 --delta 15 --max-gap 0.05
  soilctl demo --quick --open

The first is the force on a plate in sand, the second between which coefficients it must lie, proven, and the third a campaign from
the simulated soil to what its forces tell of it, on a page. `soilctl workbench --open` is a page to draw a problem on and to solve it.
`soilctl --help` lists all verbs, `soilctl help VERB` tells of one.
";

fn exit_code(args: impl IntoIterator<Item = OsString>) -> u8 {
    let args: Vec<OsString> = args.into_iter().collect();
    if args.len() <= 1 {
        // A closed pipe changes no exit code.
        let _ = std::io::stderr().write_all(FIRST_STEPS.as_bytes());
        return 2;
    }
    let cli = match Cli::try_parse_from(&args) {
        Ok(cli) => cli,
        Err(usage) => {
            // Help and version are an answer (0), anything else is wrong usage (2); a closed pipe changes neither.
            let _ = usage.print();
            return if usage.use_stderr() { 2 } else { 0 };
        }
    };
    let mut output = Output::new(cli.format, cli.quiet).of_command(command::line(&args));
    match cli.verb.run(Cli::command, &mut output) {
        Ok(outcome) => outcome.exit_code(),
        Err(error) if error.is_broken_pipe() => 0,
        Err(error) => {
            output.error(&error.in_options(&Cli::command()));
            2
        }
    }
}

/// What a command line answered.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Answered {
    /// The exit code that [`run`] would have given: 0, 1 or 3.
    pub exit_code: u8,
    /// The answer, as `--format json` prints it; empty for verbs that print no JSON.
    pub json: String,
}

/// Why a command line has no answer, with the message that [`run`] would have printed.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum Refused {
    /// Wrong usage, bad input, or no answer exists.
    #[error("{0}")]
    Input(String),
    /// A file that cannot be read or written.
    #[error("{0}")]
    File(String),
}

/// The JSON answer to the command line `args`, the program's name first; nothing is printed.
///
/// Setting `stop` ends long work with what there is, as Ctrl-C does in the program. How far it is stands in `progress`.
///
/// # Errors
/// [`Refused`] where [`run`] would have given exit code 2.
pub fn answer(
    args: impl IntoIterator<Item = OsString>,
    stop: Arc<AtomicBool>,
    progress: Arc<Progress>,
) -> Result<Answered, Refused> {
    let args: Vec<OsString> = args.into_iter().collect();
    let cli = Cli::try_parse_from(&args).map_err(|usage| Refused::Input(usage.render().to_string()))?;
    if !cli.verb.is_one_answer() {
        return Err(Refused::Input(
            "this verb talks to its user or its shell, or runs until it is ended; use the command soilctl"
                .into(),
        ));
    }
    let mut output = Output::kept(stop, progress).of_command(command::line(&args));
    let outcome =
        cli.verb.run(Cli::command, &mut output).map_err(|error| error.in_options(&Cli::command())).map_err(
            |error| match error.is_of_a_file() {
                true => Refused::File(error.to_string()),
                false => Refused::Input(error.to_string()),
            },
        )?;
    let json = String::from_utf8_lossy(&output.into_kept()).into_owned();
    Ok(Answered { exit_code: outcome.exit_code(), json })
}
