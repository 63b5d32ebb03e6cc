//! Long work that counts its steps for a function of Python.

use std::cell::Cell;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use pyo3::prelude::*;

use crate::error::{Answer, Fail};
use crate::interruptible::run_interruptible;

/// Runs `work`, which ends soon after its flag is set, as it is at Ctrl-C. From time to time and at the end `progress` is called
/// with what `counted` gives, the steps done and of all steps.
pub(crate) fn with_progress<T: Send, E: Send + Into<Fail>>(
    py: Python<'_>,
    progress: Option<&Bound<'_, PyAny>>,
    counted: impl Fn() -> (u64, u64),
    work: impl FnOnce(Arc<AtomicBool>) -> Result<T, E> + Send,
) -> Answer<T> {
    let stop = Arc::new(AtomicBool::new(false));
    let reported = Cell::new((0, 0));
    let report = || {
        let now = counted();
        match progress {
            // Nothing is said twice.
            Some(progress) if reported.replace(now) != now => progress.call1(now).map(|_| ()),
            _ => Ok(()),
        }
    };
    let flag = Arc::clone(&stop);
    let ended = run_interruptible(
        py,
        move |_: &dyn Fn(())| work(flag),
        || stop.store(true, Ordering::Relaxed),
        |()| Ok(()),
        &report,
    )?;
    match ended.raised {
        Some(raised) => Err(Fail(raised)),
        None => {
            let answer = ended.answer.map_err(Into::into)?;
            report()?;
            Ok(answer)
        }
    }
}
