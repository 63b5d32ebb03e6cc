//! Runs of boundary sides that follow each other around the soil.

use soilctl_certificate::{Boundary, Condition, LineUse};

use crate::problem::Problem;

/// Sides in the order in which they are walked with the soil on the left.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Run {
    pub(crate) sides: Vec<LineUse>,
    /// Whether the last side leads to the first.
    pub(crate) closed: bool,
}

/// Runs of all boundary sides whose condition is wanted, in the order in which certificates count them: by the least
/// index of their sides among the boundaries. A run goes on beyond interfaces that end at the boundary.
pub(crate) fn runs(problem: &Problem, wanted: impl Fn(Condition) -> bool) -> Vec<Run> {
    let boundaries = &problem.statement().boundaries;
    let sides: Vec<LineUse> = boundaries.iter().filter(|b| wanted(b.condition)).map(Boundary::side).collect();
    let next: Vec<Option<usize>> = sides
        .iter()
        .map(|side| {
            let next = next_boundary(problem, *side)?;
            sides.iter().position(|s| *s == next)
        })
        .collect();
    let mut taken = vec![false; sides.len()];
    let mut runs: Vec<(usize, Run)> = Vec::new();
    let open = (0..sides.len()).filter(|i| !next.contains(&Some(*i)));
    // What no open run has taken is closed.
    for start in open.chain(0..sides.len()) {
        let (mut members, mut here) = (Vec::new(), Some(start));
        while let Some(i) = here.filter(|i| !taken[*i]) {
            taken[i] = true;
            members.push(i);
            here = next[i];
        }
        if let Some(least) = members.iter().min() {
            let closed = here == Some(start);
            runs.push((*least, Run { sides: members.iter().map(|i| sides[*i]).collect(), closed }));
        }
    }
    runs.sort_by_key(|(least, _)| *least);
    runs.into_iter().map(|(_, run)| run).collect()
}

/// The boundary side that is reached from the end of another one along the soil there.
fn next_boundary(problem: &Problem, side: LineUse) -> Option<LineUse> {
    let statement = problem.statement();
    let following = |side: LineUse| {
        statement.regions.iter().flat_map(|r| &r.loops).find_map(|uses| {
            let at = uses.iter().position(|u| *u == side)?;
            Some(uses[(at + 1) % uses.len()])
        })
    };
    let mut here = following(side)?;
    // Each interface can be crossed once in each sense.
    for _ in 0..2 * statement.lines.len() {
        if statement.boundaries.iter().any(|b| b.side() == here) {
            return Some(here);
        }
        here = following(LineUse { line: here.line, forward: !here.forward })?;
    }
    None
}
