//! A run of the solver for a page, on a thread of its own.

use std::panic::AssertUnwindSafe;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::Instant;

use soilctl_app::limits::Budget;
use soilctl_app::solve::{self, Request};
use soilctl_app::{Interrupted, Proven, Watch};
use soilctl_limit_analysis::Description;

use crate::messages::{Spend, Told, Wrong};
use crate::shown::Shown;

/// Most runs of all pages at a time.
const MOST_RUNS: usize = 2;

/// A run that may be stopped. It is stopped when this is dropped.
pub(crate) struct Run {
    stop: Arc<AtomicBool>,
    told: Receiver<String>,
}

impl Run {
    /// Starts a run. `running` counts those of all pages.
    pub(crate) fn start(
        id: u64,
        description: Description,
        spend: Spend,
        running: &Arc<AtomicUsize>,
    ) -> Result<Self, Wrong> {
        if running.fetch_add(1, Ordering::SeqCst) >= MOST_RUNS {
            running.fetch_sub(1, Ordering::SeqCst);
            return Err(Wrong::words(format!(
                "{MOST_RUNS} problems are being solved already; stop one of them first"
            )));
        }
        let place = Place(Arc::clone(running));
        let stop = Arc::new(AtomicBool::new(false));
        let (tell, told) = channel();
        let watch = ForPage {
            id,
            begun: Instant::now(),
            stop: Arc::clone(&stop),
            tell,
            of: AtomicU64::new(0),
            done: AtomicU64::new(0),
        };
        let threads = std::thread::available_parallelism().map_or(1, |n| n.get().min(1024)) as u32;
        let budget =
            Budget { max_gap: spend.max_gap, max_seconds: spend.max_seconds, threads, ..Budget::default() };
        let request = Request { budget, ..Request::default() };
        let work = move || {
            let _place = place;
            let found =
                std::panic::catch_unwind(AssertUnwindSafe(|| solved(id, description, &request, &watch)));
            let words =
                "the solver broke off; this is a fault of the program. The problem is still on the page";
            let answer = found.unwrap_or_else(|_| Told::Failed { id, error: Wrong::words(words) }.text());
            // A page that has gone needs no answer.
            let _ = watch.tell.send(answer);
        };
        let thread = std::thread::Builder::new().name("solve".to_owned()).spawn(work);
        thread.map_err(|problem| Wrong::words(format!("there is no thread for a run: {problem}")))?;
        Ok(Self { stop, told })
    }

    /// Asks it to end with the best bounds so far.
    pub(crate) fn stop(&self) {
        self.stop.store(true, Ordering::Relaxed);
    }

    /// What there is to tell; whether the run has ended.
    pub(crate) fn poll(&self, tell: &mut dyn FnMut(String)) -> bool {
        loop {
            match self.told.try_recv() {
                Ok(message) => tell(message),
                Err(std::sync::mpsc::TryRecvError::Empty) => return false,
                Err(std::sync::mpsc::TryRecvError::Disconnected) => return true,
            }
        }
    }
}

impl Drop for Run {
    fn drop(&mut self) {
        self.stop();
    }
}

/// A place among those who run.
struct Place(Arc<AtomicUsize>);

impl Drop for Place {
    fn drop(&mut self) {
        self.0.fetch_sub(1, Ordering::SeqCst);
    }
}

fn solved(id: u64, description: Description, request: &Request, watch: &dyn Watch) -> String {
    match solve::of(description, request, watch) {
        Ok(found) => Told::Solved { id, answer: &found.answer, field: Shown::new(&found.fields) }.text(),
        Err(error) => Told::Failed { id, error: (&error).into() }.text(),
    }
}

/// Tells a page how far its run is.
struct ForPage {
    id: u64,
    begun: Instant,
    stop: Arc<AtomicBool>,
    tell: Sender<String>,
    of: AtomicU64,
    done: AtomicU64,
}

impl Watch for ForPage {
    fn stop(&self, _: Interrupted) -> Arc<AtomicBool> {
        Arc::clone(&self.stop)
    }

    fn begin(&self, steps: u64, _: &str) {
        self.of.store(steps, Ordering::Relaxed);
    }

    fn advance(&self, steps: u64) {
        let done = self.done.fetch_add(steps, Ordering::Relaxed) + steps;
        let cases = Told::Cases { id: self.id, done, of: self.of.load(Ordering::Relaxed) };
        let _ = self.tell.send(cases.text());
    }

    fn end(&self) {}

    fn note(&self, _: &str) {}

    fn proven(&self, proven: &Proven) {
        let seconds = self.begun.elapsed().as_secs_f64();
        let _ = self.tell.send(Told::Proven { id: self.id, seconds, proven: *proven }.text());
    }
}
