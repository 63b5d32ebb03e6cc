//! Runs of boundary sides that follow each other around the soil.

use std::collections::BTreeMap;

use super::Problem;
use crate::statement::{Boundary, Condition, LineUse};

/// Sides in the order in which they are walked with the soil on the left.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Run {
    pub(crate) sides: Vec<LineUse>,
    /// Whether the last side leads to the first.
    pub(crate) closed: bool,
}

impl Problem<'_> {
    /// Runs of all boundary sides whose condition is `wanted`.
    pub(crate) fn runs(&self, wanted: impl Fn(Condition) -> bool) -> Vec<Run> {
        self.runs_of(|b| wanted(b.condition))
    }

    /// Runs of all boundary sides that are `wanted`, in the order of the least index of their sides in the statement's
    /// boundaries. Where an interface between two soils ends at the boundary, the run goes on beyond it.
    pub(crate) fn runs_of(&self, wanted: impl Fn(&Boundary) -> bool) -> Vec<Run> {
        let sides: Vec<LineUse> =
            self.statement.boundaries.iter().filter(|b| wanted(b)).map(Boundary::side).collect();
        let following: BTreeMap<LineUse, LineUse> =
            sides.iter().filter_map(|side| Some((*side, self.next_boundary(*side)?))).collect();
        let next = |side: &LineUse| following.get(side).copied().filter(|n| sides.contains(n));
        let led_to: Vec<LineUse> = sides.iter().filter_map(next).collect();
        let index = |side: &LineUse| sides.iter().position(|s| s == side).unwrap_or(usize::MAX);
        let mut done = vec![false; sides.len()];
        let mut runs: Vec<(usize, Run)> = Vec::new();
        // First those with an end, then what is left: closed ones, from their least index on.
        let open = sides.iter().filter(|s| !led_to.contains(s));
        for start in open.chain(&sides) {
            let mut run = Run { sides: Vec::new(), closed: false };
            let mut here = Some(*start);
            while let Some(side) = here.filter(|s| !done[index(s)]) {
                done[index(&side)] = true;
                run.sides.push(side);
                here = next(&side);
            }
            run.closed = here == Some(*start);
            if let Some(least) = run.sides.iter().map(index).min() {
                runs.push((least, run));
            }
        }
        runs.sort_by_key(|(least, _)| *least);
        runs.into_iter().map(|(_, run)| run).collect()
    }

    /// The boundary side that is reached from the end of another one along the soil there.
    fn next_boundary(&self, side: LineUse) -> Option<LineUse> {
        let mut here = self.next_in_loop(side)?;
        // Each interface is crossed at most once in each sense.
        for _ in 0..2 * self.statement.lines.len() {
            if self.condition(here).is_some() {
                return Some(here);
            }
            here = self.next_in_loop(LineUse { line: here.line, forward: !here.forward })?;
        }
        None
    }

    fn next_in_loop(&self, side: LineUse) -> Option<LineUse> {
        let region = self.statement.regions.get(self.owner(side)?)?;
        region.loops.iter().find_map(|uses| {
            let at = uses.iter().position(|u| *u == side)?;
            Some(uses[(at + 1) % uses.len()])
        })
    }
}
