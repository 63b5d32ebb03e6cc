//! Work that takes long and reports on its way: in a thread of its own, while this one looks after Ctrl-C.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::Duration;

use pyo3::prelude::*;

use crate::error::{Answer, Fail, kinds};

/// Between two looks at Ctrl-C.
const INTERVAL: Duration = Duration::from_millis(50);

/// What came of the work, and the exception that ended it early.
pub(crate) struct Ended<T> {
    pub(crate) answer: T,
    pub(crate) raised: Option<PyErr>,
}

enum Message<T, R> {
    Report(R),
    Answer(T),
}

/// [`run_interruptible`] for work that reports nothing and gives an answer of no use if it is stopped.
pub(crate) fn stoppable<T: Send, E: Send + Into<Fail>>(
    py: Python<'_>,
    work: impl FnOnce(&AtomicBool) -> Result<T, E> + Send,
) -> Answer<T> {
    let stop = AtomicBool::new(false);
    let end = || stop.store(true, Ordering::Relaxed);
    let done = run_interruptible(py, |_: &dyn Fn(())| work(&stop), end, |()| Ok(()), || Ok(()))?;
    match done.raised {
        Some(raised) => Err(Fail(raised)),
        None => done.answer.map_err(Into::into),
    }
}

/// Runs `work`, and hands what it reports to `on_report`; every now and then it calls `on_look`. If one of them raises, or at Ctrl-C,
/// `stop` is called, which must make the work end soon with what it has.
pub(crate) fn run_interruptible<T: Send, R: Send>(
    py: Python<'_>,
    work: impl FnOnce(&dyn Fn(R)) -> T + Send,
    stop: impl Fn(),
    mut on_report: impl FnMut(R) -> PyResult<()>,
    mut on_look: impl FnMut() -> PyResult<()>,
) -> Answer<Ended<T>> {
    let (send, receive) = channel::<Message<T, R>>();
    std::thread::scope(|scope| {
        let worker = scope.spawn(move || {
            // Nobody listens any more only if the other side panicked.
            let report = |report: R| drop(send.send(Message::Report(report)));
            let answer = work(&report);
            drop(send.send(Message::Answer(answer)));
        });
        let mut raised = None;
        // A receiver may move between threads but not be shared, which is all that waiting needs.
        let receive = std::sync::Mutex::new(receive);
        loop {
            let message = py.detach(|| match receive.lock() {
                Ok(receive) => receive.recv_timeout(INTERVAL),
                Err(_) => Err(RecvTimeoutError::Disconnected),
            });
            let result = match message {
                Ok(Message::Answer(answer)) => return Ok(Ended { answer, raised }),
                Ok(Message::Report(report)) if raised.is_none() => on_report(report),
                Ok(Message::Report(_)) => Ok(()),
                Err(RecvTimeoutError::Timeout) if raised.is_none() => {
                    py.check_signals().and_then(|()| on_look())
                }
                Err(RecvTimeoutError::Timeout) => py.check_signals(),
                Err(RecvTimeoutError::Disconnected) => {
                    // It panicked, which must not end the interpreter; joining keeps the panic from going on.
                    drop(worker.join());
                    let problem = "the computation ended without an answer; please report this";
                    return Err(Fail(kinds::SimulationError::new_err(problem)));
                }
            };
            if let Err(problem) = result
                && raised.is_none()
            {
                stop();
                raised = Some(problem);
            }
        }
    })
}
