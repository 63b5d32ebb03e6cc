use std::io::ErrorKind;
use std::path::Path;
use std::process::{Command, Stdio};

use crate::error::CliError;

/// Opens a recording in a viewer that lives on; its name, or `None` if no viewer was named and none is installed.
pub(super) fn open(named: Option<&Path>, recording: &Path) -> Result<Option<String>, CliError> {
    let program = named.unwrap_or_else(|| Path::new("rerun"));
    let mut command = Command::new(program);
    command.arg(recording).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    // Ctrl-C in the terminal is for what runs there.
    #[cfg(unix)]
    std::os::unix::process::CommandExt::process_group(&mut command, 0);
    match command.spawn() {
        Ok(_) => Ok(Some(program.display().to_string())),
        Err(problem) if named.is_none() && problem.kind() == ErrorKind::NotFound => Ok(None),
        Err(problem) => Err(CliError::Usage(format!(
            "the viewer {} cannot be started: {problem}; the recording is written, give the path of Rerun's program with \
             --viewer, or --no-open",
            program.display()
        ))),
    }
}
