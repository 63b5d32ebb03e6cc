//! Why there are no bounds, in physical words. What is said to be so is proven; otherwise the words say what was tried.

use std::sync::atomic::Ordering;

use soilctl_limit_analysis::{
    Level, LimitError, Options, Problem, Status, WORK_TO_FALL, falls, seems_to_fall,
};

use crate::AppError;
use crate::text::number;

/// The levels of a run, and how their solves ended.
#[derive(Debug, Default)]
pub(super) struct Statuses {
    levels: Vec<Level>,
    /// Whether a proof was looked for that the ground falls, and the factor on all that acts which it proves not to be borne.
    asked: bool,
    falls_at: Option<f64>,
}

impl Statuses {
    /// Takes note of a level. Ends the run if both programs say that there is nothing to find, or if the ground is proven to fall
    /// whatever is asked of it: finer meshes will not change that.
    pub(super) fn see(&mut self, level: &Level, problem: &Problem, options: &Options) {
        self.levels.push(level.clone());
        if self.levels.len() <= 1 {
            return;
        }
        self.ask(problem, options);
        if self.locked() || self.falls_at.is_some() {
            options.end.store(true, Ordering::Relaxed);
        }
    }

    /// Looks for a proof that the ground falls, once, if it seems to.
    fn ask(&mut self, problem: &Problem, options: &Options) {
        if seems_to_fall(&self.levels) && !self.asked {
            self.asked = true;
            // A problem that cannot be asked this has its own error to tell.
            self.falls_at = falls(problem, options, WORK_TO_FALL).ok().flatten();
        }
    }

    /// No flow is possible. Where only steep flows are, coarse meshes have none either: the stresses must know no limit too.
    fn locked(&self) -> bool {
        self.levels.iter().all(|level| level.upper.status == Status::Infeasible) && self.bears_all()
    }

    /// Stresses bear any load.
    fn bears_all(&self) -> bool {
        let mut lower = self.levels.iter().filter_map(|level| level.lower).peekable();
        lower.peek().is_some() && lower.all(|solve| solve.status == Status::Unbounded)
    }

    /// A failed run in physical words, as far as they are known.
    pub(super) fn explain(&mut self, error: LimitError, problem: &Problem, options: &Options) -> AppError {
        let LimitError::NothingProven { proven, .. } = error else { return error.into() };
        self.ask(problem, options);
        let meshes = self.levels.len();
        if let Some(factor) = self.falls_at {
            return AppError::Request(format!(
                "there is no collapse load: the ground fails under its own weight and the dead loads, whatever else acts, which is \
                 proven: it bears at most {} times these; give it more strength, or flatter and better held ground",
                number(factor.max(0.0))
            ));
        }
        // Of ground that falls an upper bound on what it bears besides would say nothing.
        if proven.is_some() {
            return error.into();
        }
        if self.bears_all() {
            return AppError::Request(format!(
                "no collapse load was found: on {meshes} meshes nothing can move, and stresses bear any load; friction, fixed \
                 boundaries and held structures leave no way out for the ground; set them further away, or free some of the ground"
            ));
        }
        if seems_to_fall(&self.levels) {
            return AppError::Request(format!(
                "no bounds were found: on {meshes} meshes no stresses within the strength bear the weight and the dead loads, and \
                 that the ground falls under them is not proven either; allow more elements, work or time, or give it more strength"
            ));
        }
        error.into()
    }
}
