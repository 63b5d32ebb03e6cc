//! The command line, in this process.

use std::ffi::OsString;
use std::sync::Arc;

use pyo3::prelude::*;
use soilctl_cli::{Progress, Refused};

use crate::error::{Answer, Fail, file, input};
use crate::progress::with_progress;

impl From<Refused> for Fail {
    fn from(problem: Refused) -> Self {
        match problem {
            Refused::Input(message) => input(message.trim_start_matches("error: ").trim_end()),
            Refused::File(message) => file(message),
        }
    }
}

/// Runs a command line, the program's name first, as the program `soilctl` does. The exit code.
#[pyfunction]
pub(crate) fn run_command(py: Python<'_>, args: Vec<OsString>) -> u8 {
    py.detach(|| soilctl_cli::run(args))
}

/// Exit code and JSON of a command line, the program's name first; `progress` is called with the steps done and of all steps,
/// from time to time and at the end.
#[pyfunction]
#[pyo3(signature = (args, progress = None))]
pub(crate) fn answer_command(
    py: Python<'_>,
    args: Vec<OsString>,
    progress: Option<&Bound<'_, PyAny>>,
) -> Answer<(u8, String)> {
    let counted = Arc::new(Progress::default());
    let counting = Arc::clone(&counted);
    let answered =
        with_progress(py, progress, || counted.get(), move |stop| soilctl_cli::answer(args, stop, counting))?;
    Ok((answered.exit_code, answered.json))
}
