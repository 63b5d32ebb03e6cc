//! Runs: boundary sides that follow each other around the soil.

use crate::statement::{Boundary, LineUse, Statement};

/// Sides in the order in which they are walked with the soil on the left.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Run {
    /// The sides, at least one.
    pub sides: Vec<LineUse>,
    /// Whether the last side leads to the first.
    pub closed: bool,
}

impl Statement {
    /// The region on the left of a side; none if no loop has it.
    #[must_use]
    pub fn owner(&self, side: LineUse) -> Option<usize> {
        self.regions.iter().position(|r| r.loops.iter().any(|l| l.contains(&side)))
    }

    /// Runs of all boundary sides that are `wanted`, in the order in which fields count them: by the least index of their
    /// sides in [`boundaries`](Self::boundaries). Where an interface between two soils ends at the boundary, the run goes
    /// on beyond it. A closed run starts with its side of the least index.
    pub fn runs(&self, wanted: impl Fn(&Boundary) -> bool) -> Vec<Run> {
        let sides: Vec<LineUse> = self.boundaries.iter().filter(|b| wanted(b)).map(Boundary::side).collect();
        let following = |side: &LineUse| {
            let next = self.next_boundary(*side)?;
            sides.iter().position(|s| *s == next)
        };
        let next: Vec<Option<usize>> = sides.iter().map(following).collect();
        let mut taken = vec![false; sides.len()];
        let mut runs: Vec<(usize, Run)> = Vec::new();
        // First those with an end, then what is left: closed ones, from their least index on.
        let open = (0..sides.len()).filter(|i| !next.contains(&Some(*i)));
        for start in open.chain(0..sides.len()) {
            let (mut members, mut here) = (Vec::new(), Some(start));
            while let Some(i) = here.filter(|i| !taken[*i]) {
                taken[i] = true;
                members.push(i);
                here = next[i];
            }
            if let Some(least) = members.iter().min() {
                let sides = members.iter().map(|i| sides[*i]).collect();
                runs.push((*least, Run { sides, closed: here == Some(start) }));
            }
        }
        runs.sort_by_key(|(least, _)| *least);
        runs.into_iter().map(|(_, run)| run).collect()
    }

    /// The boundary side that is reached from the end of another one along the soil there.
    fn next_boundary(&self, side: LineUse) -> Option<LineUse> {
        let mut here = self.next_in_loop(side)?;
        // Each interface is crossed at most once in each sense.
        for _ in 0..2 * self.lines.len() {
            if self.boundaries.iter().any(|b| b.side() == here) {
                return Some(here);
            }
            here = self.next_in_loop(here.reversed())?;
        }
        None
    }

    fn next_in_loop(&self, side: LineUse) -> Option<LineUse> {
        self.regions.iter().flat_map(|r| &r.loops).find_map(|uses| {
            let at = uses.iter().position(|u| *u == side)?;
            Some(uses[(at + 1) % uses.len()])
        })
    }
}
