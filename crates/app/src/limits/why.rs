//! Why there are no bounds, in physical words. What is said to be so is proven; otherwise the words say what was tried.

use std::sync::atomic::Ordering;

use soilctl_limit_analysis::{Level, LimitError, Options, Problem, Status, falls};

use crate::AppError;
use crate::text::number;

/// Element steps for a proof that the ground falls, where it seems to; some seconds.
const WORK: u64 = 300_000;

/// How the solves of a run ended.
#[derive(Debug, Default)]
pub(super) struct Statuses {
    upper: Vec<Status>,
    lower: Vec<Status>,
    /// Whether a proof was looked for that the ground falls, and the factor on all that acts which it proves not to be borne.
    asked: bool,
    falls_at: Option<f64>,
}

impl Statuses {
    /// Takes note of a level. Ends the run if both programs say that there is nothing to find, or if the ground is proven to fall
    /// whatever is asked of it: finer meshes will not change that.
    pub(super) fn see(&mut self, level: &Level, problem: &Problem, options: &Options) {
        self.upper.push(level.upper.status);
        self.lower.extend(level.lower.map(|s| s.status));
        if self.upper.len() <= 1 {
            return;
        }
        self.ask(problem, options);
        if self.locked() || self.falls_at.is_some() {
            options.stop.store(true, Ordering::Relaxed);
        }
    }

    /// Looks for a proof that the ground falls, once, if it seems to.
    fn ask(&mut self, problem: &Problem, options: &Options) {
        if self.seems_to_fall() && !self.asked {
            self.asked = true;
            // A problem that cannot be asked this has its own error to tell.
            self.falls_at = falls(problem, options, WORK).ok().flatten();
        }
    }

    fn all(statuses: &[Status], wanted: Status) -> bool {
        !statuses.is_empty() && statuses.iter().all(|s| *s == wanted)
    }

    /// No flow is possible. Where only steep flows are, coarse meshes have none either: the stresses must know no limit too.
    fn locked(&self) -> bool {
        Self::all(&self.upper, Status::Infeasible) && Self::all(&self.lower, Status::Unbounded)
    }

    /// No stress field is in equilibrium within the strength, or the flow gains without end.
    fn seems_to_fall(&self) -> bool {
        Self::all(&self.lower, Status::Infeasible) || Self::all(&self.upper, Status::Unbounded)
    }

    /// A failed run in physical words, as far as they are known.
    pub(super) fn explain(&mut self, error: LimitError, problem: &Problem, options: &Options) -> AppError {
        if !matches!(error, LimitError::NothingProven { proven: None, .. }) {
            return error.into();
        }
        self.ask(problem, options);
        let meshes = self.upper.len();
        if let Some(factor) = self.falls_at {
            return AppError::Request(format!(
                "there is no collapse load: the ground fails under its own weight and the dead loads, whatever else acts, which is \
                 proven: it bears at most {} times these; give it more strength, or flatter and better held ground",
                number(factor.max(0.0))
            ));
        }
        if Self::all(&self.lower, Status::Unbounded) {
            return AppError::Request(format!(
                "no collapse load was found: on {meshes} meshes nothing can move, and stresses bear any load; friction, fixed \
                 boundaries and held structures leave no way out for the ground; set them further away, or free some of the ground"
            ));
        }
        if self.seems_to_fall() {
            return AppError::Request(format!(
                "no bounds were found: on {meshes} meshes no stresses within the strength bear the weight and the dead loads, and \
                 that the ground falls under them is not proven either; allow more elements, work or time, or give it more strength"
            ));
        }
        error.into()
    }
}
