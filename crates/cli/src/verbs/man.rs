//! `soilctl man DIR`: the man pages, one for each verb.

use std::path::PathBuf;

use soilctl_app::Outcome;

use crate::error::CliError;

#[derive(Debug, clap::Args)]
pub(crate) struct Args {
    /// Folder to write to; made if it is not there
    dir: PathBuf,
}

pub(crate) fn run(args: &Args, whole: clap::Command) -> Result<Outcome, CliError> {
    std::fs::create_dir_all(&args.dir)
        .and_then(|()| clap_mangen::generate_to(whole, &args.dir))
        .map_err(|problem| CliError::File { path: args.dir.display().to_string(), problem })?;
    Ok(Outcome::Done)
}
