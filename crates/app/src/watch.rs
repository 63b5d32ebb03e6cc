//! How a use case speaks with whoever runs it while it works.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use serde::Serialize;

/// What is left of work that is stopped before its end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Interrupted {
    /// Results so far are kept or answered, so stopping is a request to end soon.
    KeepsResults,
    /// Nothing is left, so the process may as well end at once.
    LeavesNothing,
}

/// What is proven of a collapse load while it is still being bounded.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Proven {
    /// Triangles of the mesh that was solved last.
    pub elements: usize,
    /// The greatest lower bound so far, in the units of the answer; null if there is none.
    pub lower: Option<f64>,
    /// The least upper bound so far, likewise.
    pub upper: Option<f64>,
    /// The factor that strength is divided by on the way to a factor of safety; null for other quantities.
    pub trial: Option<f64>,
}

/// Whoever runs a use case: sees how far it is, reads its notes, and may stop it. Any thread may call it.
pub trait Watch: Sync {
    /// A flag that is set when the work is to end.
    fn stop(&self, interrupted: Interrupted) -> Arc<AtomicBool>;

    /// Work of so many steps begins, which are called `name` ("strokes", "logs"); 0 if nobody knows how many.
    fn begin(&self, steps: u64, name: &str);

    /// So many more steps are done.
    fn advance(&self, steps: u64);

    /// What the work is at, in a few words; shown where there is a place for it.
    fn say(&self, _text: &str) {}

    /// More is proven, or a finer mesh was solved.
    fn proven(&self, _proven: &Proven) {}

    /// The work that was begun has ended.
    fn end(&self);

    /// A sentence for the user beside the answer.
    fn note(&self, text: &str);
}

/// Whoever watches a run of many problems, as one of them sees them: it does not tell how far it is.
pub(crate) struct OneOfMany<'a> {
    pub(crate) watch: &'a dyn Watch,
    /// What its notes begin with, of problems that run side by side; these say nothing of what they are at.
    pub(crate) name: Option<&'a str>,
}

impl Watch for OneOfMany<'_> {
    fn stop(&self, interrupted: Interrupted) -> Arc<AtomicBool> {
        self.watch.stop(interrupted)
    }

    fn begin(&self, _: u64, _: &str) {}

    fn advance(&self, _: u64) {}

    fn say(&self, text: &str) {
        if self.name.is_none() {
            self.watch.say(text);
        }
    }

    fn end(&self) {}

    fn note(&self, text: &str) {
        match self.name {
            Some(name) => self.watch.note(&format!("{name}: {text}")),
            None => self.watch.note(text),
        }
    }
}

/// Whoever watches a piece of work that is made of many, all of which are counted: nothing is heard of it, and it can be stopped.
pub(crate) struct Silent<'a>(pub(crate) &'a dyn Watch);

impl Watch for Silent<'_> {
    fn stop(&self, interrupted: Interrupted) -> Arc<AtomicBool> {
        self.0.stop(interrupted)
    }

    fn begin(&self, _: u64, _: &str) {}

    fn advance(&self, _: u64) {}

    fn end(&self) {}

    fn note(&self, _: &str) {}
}

/// Nobody watches: notes are dropped, and nothing is ever stopped.
#[derive(Debug, Clone, Copy, Default)]
pub struct Unwatched;

impl Watch for Unwatched {
    fn stop(&self, _: Interrupted) -> Arc<AtomicBool> {
        Arc::default()
    }

    fn begin(&self, _: u64, _: &str) {}

    fn advance(&self, _: u64) {}

    fn end(&self) {}

    fn note(&self, _: &str) {}
}
