//! The command line, in this process.

use std::ffi::OsString;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use pyo3::prelude::*;
use soilctl_cli::Refused;

use crate::error::{Answer, Fail, file, input};
use crate::patient::patiently;

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

/// Exit code and JSON of a command line, the program's name first.
#[pyfunction]
pub(crate) fn answer_command(py: Python<'_>, args: Vec<OsString>) -> Answer<(u8, String)> {
    let stop = Arc::new(AtomicBool::new(false));
    let flag = Arc::clone(&stop);
    let done = patiently(
        py,
        move |_: &dyn Fn(())| soilctl_cli::answer(args, flag),
        || stop.store(true, Ordering::Relaxed),
        |()| Ok(()),
    )?;
    match (done.answer, done.raised) {
        (_, Some(raised)) => Err(Fail(raised)),
        (answer, None) => {
            let answered = answer?;
            Ok((answered.exit_code, answered.json))
        }
    }
}
