//! Both bounds of a level.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use super::memory::both_fit;
use super::relative_gap;
use super::run::Run;
use super::solves::{SolvedLower, SolvedUpper};
use crate::error::LimitError;
use crate::mesh::Mesh;
use crate::topology::Topology;

/// A lower bound takes about as long as an upper one on a mesh of so many times the elements.
const LOWER_COST: f64 = 1.8;

/// The two programs of a level.
const LOWER: usize = 0;
const UPPER: usize = 1;

impl Run<'_> {
    /// The upper bound of a level, and the lower one on a mesh of its own; one of them is left out if the other is enough.
    ///
    /// The cheaper one goes first, and the other counts only if that alone does not bring the gap asked for. With two threads
    /// it is given up then, so the answer is that of one; so it is where both do not fit into the memory at once.
    pub(super) fn solve_both(
        &self,
        number: usize,
        lower_mesh: Option<&(Mesh, Topology)>,
    ) -> Result<(Option<SolvedUpper>, Option<SolvedLower>), LimitError> {
        let elements = self.meshes[number].0.triangles.len();
        let lower_elements = lower_mesh.map_or(0, |(m, _)| m.triangles.len());
        let lower_first = lower_mesh.is_some() && LOWER_COST * (lower_elements as f64) < elements as f64;
        // How many threads there are must not change which meshes fit into the memory.
        let at_once =
            self.options.threads > 1 && both_fit(self.options.max_memory_bytes, [elements, lower_elements]);
        let needless: [Arc<AtomicBool>; 2] = Default::default();
        let is_needed = |side: usize| !needless[side].load(Ordering::Relaxed);
        let solve_upper = || {
            let upper = is_needed(UPPER).then(|| self.solve_upper(number, &needless[UPPER])).transpose();
            let proven = upper.as_ref().ok().and_then(|u| u.as_ref()?.1.proven);
            let enough = !lower_first && proven.is_some_and(|value| self.is_enough([None, Some(value)]));
            needless[LOWER].store(enough, Ordering::Relaxed);
            upper
        };
        let solve_lower = || {
            let mesh = lower_mesh.filter(|_| is_needed(LOWER));
            let lower = mesh.map(|m| self.solve_lower(m, &needless[LOWER])).transpose();
            let proven = lower.as_ref().ok().and_then(|l| l.as_ref()?.0.proven);
            let enough = lower_first && proven.is_some_and(|value| self.is_enough([Some(value), None]));
            needless[UPPER].store(enough, Ordering::Relaxed);
            lower
        };
        let (upper, lower) = if at_once {
            std::thread::scope(|scope| {
                let lower = scope.spawn(solve_lower);
                let upper = solve_upper();
                let lower = lower.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic));
                (upper, lower)
            })
        } else if lower_first {
            let lower = solve_lower();
            (solve_upper(), lower)
        } else {
            (solve_upper(), solve_lower())
        };
        Ok((if is_needed(UPPER) { upper? } else { None }, if is_needed(LOWER) { lower? } else { None }))
    }

    /// Whether bounds of these values, or the best so far, end the run.
    fn is_enough(&self, [lower, upper]: [Option<f64>; 2]) -> bool {
        let lower = lower.or(self.lower.as_ref().map(|b| b.value));
        let upper = upper.or(self.upper.as_ref().map(|b| b.value));
        lower.zip(upper).is_some_and(|(l, u)| relative_gap(l, u) <= self.options.max_gap)
    }
}
