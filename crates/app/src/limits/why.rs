//! Why there are no bounds, in physical words.

use std::sync::atomic::Ordering;

use soilctl_limit_analysis::{Level, LimitError, Options, Status};

use crate::AppError;

/// How the solves of a run ended.
#[derive(Debug, Default)]
pub(super) struct Statuses {
    upper: Vec<Status>,
    lower: Vec<Status>,
}

impl Statuses {
    /// Takes note of a level. Ends the run if both programs say that there is nothing to find: finer meshes will not
    /// change that.
    pub(super) fn see(&mut self, level: &Level, options: &Options) {
        self.upper.push(level.upper.status);
        self.lower.extend(level.lower.map(|s| s.status));
        if self.upper.len() > 1 && (self.locked() || self.falls()) {
            options.stop.store(true, Ordering::Relaxed);
        }
    }

    fn all(statuses: &[Status], wanted: Status) -> bool {
        !statuses.is_empty() && statuses.iter().all(|s| *s == wanted)
    }

    /// No flow is possible. Where only steep flows are, coarse meshes have none either: the stresses must know no limit too.
    fn locked(&self) -> bool {
        Self::all(&self.upper, Status::Infeasible) && Self::all(&self.lower, Status::Unbounded)
    }

    /// No stress field is in equilibrium within the strength.
    fn falls(&self) -> bool {
        Self::all(&self.lower, Status::Infeasible)
    }

    /// A failed run in physical words, as far as they are known.
    pub(super) fn explain(&self, problem: LimitError) -> AppError {
        if !matches!(problem, LimitError::NothingProven { .. }) {
            return problem.into();
        }
        if Self::all(&self.lower, Status::Unbounded) {
            return AppError::Request(
                "there is no collapse load: nothing can move, so the soil bears any load; friction, fixed boundaries and \
                 held structures leave no way out for it; set them further away, or free some of the ground"
                    .into(),
            );
        }
        if self.falls() || Self::all(&self.upper, Status::Unbounded) {
            return AppError::Request(
                "there is no collapse load: the soil already fails under its own weight and the dead loads, whatever else \
                 acts; give it more strength, or flatter and better held ground"
                    .into(),
            );
        }
        problem.into()
    }
}
