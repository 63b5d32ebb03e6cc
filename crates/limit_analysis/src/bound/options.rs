//! What a run may spend.

use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use soilctl_conic::Factorisation;

/// When to stop, and what may be spent.
#[derive(Debug, Clone)]
pub struct Options {
    /// Relative gap, `(U - L) / ((U + L) / 2)`, at which to stop.
    pub max_gap: f64,
    /// No mesh has more elements.
    pub max_elements: usize,
    /// Work in element steps: the elements of a mesh times the solver's steps on it, summed over all solves. No level is begun
    /// that is expected to take more than is left; one that is begun is finished. It is the same on every machine, which time
    /// is not.
    pub max_work: u64,
    /// Time in seconds, if the user wants to limit it. Where the run ends then depends on the machine; it says so by
    /// [`Ended::Time`](crate::Ended).
    pub max_seconds: Option<f64>,
    /// Memory in bytes that the run may use, by an estimate with a margin: no program is built that may need more.
    pub max_memory_bytes: u64,
    /// 1: one solve at a time; more: both bounds of a level at once. The results are the same.
    pub threads: usize,
    /// What factorises the systems of the solver's steps; by default that is [chosen](Factorisation) for each program by its
    /// size.
    pub factorisation: Option<Factorisation>,
    /// Replaces each cone by a pyramid of so many sides inside it (at least 3), which makes the programs linear: for
    /// comparison. Bounds are proven as always, but further apart.
    pub segments: Option<usize>,
    /// An existing folder for programs that end in numerical trouble, one file each, to reproduce it from.
    pub dump: Option<PathBuf>,
    /// Set to end the run early with the best bounds so far, and all others that have this one.
    pub stop: Arc<AtomicBool>,
    /// The same for this run alone.
    pub end: Arc<AtomicBool>,
}

impl Options {
    /// Whether the run is to end.
    #[must_use]
    pub fn is_stopped(&self) -> bool {
        self.stop.load(Ordering::Relaxed) || self.end.load(Ordering::Relaxed)
    }

    /// [`max_work`](Self::max_work) where nothing else is asked for: about what one core does in a minute.
    pub const MAX_WORK: u64 = 3_000_000;
}

impl Default for Options {
    fn default() -> Self {
        Self {
            max_gap: 0.01,
            max_elements: 20_000,
            max_work: Self::MAX_WORK,
            max_seconds: None,
            max_memory_bytes: u64::MAX,
            threads: 1,
            factorisation: None,
            segments: None,
            dump: None,
            stop: Arc::default(),
            end: Arc::default(),
        }
    }
}
