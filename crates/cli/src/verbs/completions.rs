//! `soilctl completions SHELL`.

use clap_complete::Shell;
use soilctl_app::Outcome;

use crate::error::CliError;
use crate::output::Output;

#[derive(Debug, clap::Args)]
pub(crate) struct Args {
    /// The shell
    shell: Shell,
}

pub(crate) fn run(args: &Args, mut whole: clap::Command, output: &mut Output) -> Result<Outcome, CliError> {
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut whole, "soilctl", &mut script);
    output.raw(&script)?;
    Ok(Outcome::Done)
}
