//! The command line, in this process.

use std::cell::Cell;
use std::ffi::OsString;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use pyo3::prelude::*;
use soilctl_cli::{Progress, Refused};

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

/// Exit code and JSON of a command line, the program's name first; `progress` is called with the steps done and of all steps,
/// from time to time and at the end.
#[pyfunction]
#[pyo3(signature = (args, progress = None))]
pub(crate) fn answer_command(
    py: Python<'_>,
    args: Vec<OsString>,
    progress: Option<&Bound<'_, PyAny>>,
) -> Answer<(u8, String)> {
    let stop = Arc::new(AtomicBool::new(false));
    let counted = Arc::new(Progress::default());
    let (flag, far) = (Arc::clone(&stop), Arc::clone(&counted));
    let told = Cell::new((0, 0));
    let tell = || {
        let now = counted.get();
        match progress {
            // Nothing is said twice.
            Some(progress) if told.replace(now) != now => progress.call1(now).map(|_| ()),
            _ => Ok(()),
        }
    };
    let done = patiently(
        py,
        move |_: &dyn Fn(())| soilctl_cli::answer(args, flag, far),
        || stop.store(true, Ordering::Relaxed),
        |()| Ok(()),
        &tell,
    )?;
    match (done.answer, done.raised) {
        (_, Some(raised)) => Err(Fail(raised)),
        (answer, None) => {
            let answered = answer?;
            tell()?;
            Ok((answered.exit_code, answered.json))
        }
    }
}
