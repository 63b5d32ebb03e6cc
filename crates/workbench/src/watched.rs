//! Tells a page how far its run is.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use soilctl_app::limits::Budget;
use soilctl_app::solve::Request;
use soilctl_app::{Interrupted, Proven, Watch};
use web_time::Instant;

use crate::messages::{Spend, Told};

/// Whom a run tells how far it is, from any thread.
pub(crate) type Tell = Box<dyn Fn(String) + Send + Sync>;

/// A run, as the page that asked for it watches it.
pub(crate) struct Watched {
    id: u64,
    begun: Instant,
    stop: Arc<AtomicBool>,
    tell: Tell,
    of: AtomicU64,
    done: AtomicU64,
}

impl Watched {
    pub(crate) fn new(id: u64, stop: Arc<AtomicBool>, tell: Tell) -> Self {
        Self { id, begun: Instant::now(), stop, tell, of: AtomicU64::new(0), done: AtomicU64::new(0) }
    }
}

/// What a run is asked for. The bounds are the same for any number of threads.
pub(crate) fn request(spend: Spend, threads: u32) -> Request {
    let budget =
        Budget { max_gap: spend.max_gap, max_seconds: spend.max_seconds, threads, ..Budget::default() };
    Request { budget, ..Request::default() }
}

impl Watch for Watched {
    fn stop(&self, _: Interrupted) -> Arc<AtomicBool> {
        Arc::clone(&self.stop)
    }

    fn begin(&self, steps: u64, _: &str) {
        self.of.store(steps, Ordering::Relaxed);
    }

    fn advance(&self, steps: u64) {
        let done = self.done.fetch_add(steps, Ordering::Relaxed) + steps;
        (self.tell)(Told::Cases { id: self.id, done, of: self.of.load(Ordering::Relaxed) }.text());
    }

    fn end(&self) {}

    fn note(&self, _: &str) {}

    fn proven(&self, proven: &Proven) {
        let seconds = self.begun.elapsed().as_secs_f64();
        (self.tell)(Told::Proven { id: self.id, seconds, proven: *proven }.text());
    }
}
