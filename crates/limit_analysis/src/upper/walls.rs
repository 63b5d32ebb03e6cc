//! Walls of soil without friction: runs of boundary sides along which the velocity across is given, in the order and
//! with the starts that certificates use (see `StreamJet` there).

use std::collections::BTreeMap;

use soilctl_certificate::{Boundary, Condition, LineUse};

use crate::problem::Problem;

/// A side of a wall.
#[derive(Debug, Clone, Copy)]
pub(super) struct WallSide {
    pub(super) wall: usize,
    pub(super) line: usize,
    forward: bool,
    /// From the first point of the line to its last.
    pub(super) direction: [f64; 2],
    pub(super) velocity: [f64; 2],
    /// Whether the soil cannot slide along it either.
    pub(super) holds: bool,
    /// The stream function at its start less that at the start of the wall.
    start: f64,
}

impl WallSide {
    /// Change of the stream function along the line, from its first point to its last.
    pub(super) fn flow(&self) -> f64 {
        self.velocity[0] * self.direction[1] - self.velocity[1] * self.direction[0]
    }

    /// The stream function at a fraction of the line, less that at the start of the wall.
    pub(super) fn value(&self, s: f64) -> f64 {
        self.start + self.flow() * if self.forward { s } else { s - 1.0 }
    }
}

/// The sides of all walls, and how many walls there are.
pub(super) fn wall_sides(problem: &Problem) -> (BTreeMap<LineUse, WallSide>, usize) {
    let mut sides = BTreeMap::new();
    let runs = runs(problem);
    for (wall, run) in runs.iter().enumerate() {
        let mut start = 0.0;
        for side in run {
            let [p, q] = problem.ends(side.line);
            let condition =
                problem.condition(crate::mesh::LineUse { line: side.line, forward: side.forward });
            let moves = matches!(condition, Some(Condition::Face { .. }));
            let here = WallSide {
                wall,
                line: side.line,
                forward: side.forward,
                direction: [q[0] - p[0], q[1] - p[1]],
                velocity: if moves { problem.velocity() } else { [0.0; 2] },
                holds: matches!(condition, Some(Condition::Fixed | Condition::Far)),
                start,
            };
            start = here.value(if side.forward { 1.0 } else { 0.0 });
            sides.insert(*side, here);
        }
    }
    (sides, runs.len())
}

/// For each side of a line that a region has, the region and the side that follows in its loop.
fn following(problem: &Problem) -> BTreeMap<LineUse, (usize, LineUse)> {
    let mut following = BTreeMap::new();
    for (region, r) in problem.statement().regions.iter().enumerate() {
        for uses in &r.loops {
            for (i, side) in uses.iter().enumerate() {
                following.insert(*side, (region, uses[(i + 1) % uses.len()]));
            }
        }
    }
    following
}

fn is_wall(condition: Condition) -> bool {
    match condition {
        Condition::Fixed | Condition::Far | Condition::Smooth => true,
        Condition::Face { delta_deg, adhesion } => delta_deg == 0.0 && adhesion > 0.0,
        Condition::Free | Condition::Loaded { .. } => false,
    }
}

/// Runs of wall sides in the order of the least index of their sides among the boundaries; a closed one starts there.
fn runs(problem: &Problem) -> Vec<Vec<LineUse>> {
    let boundaries = &problem.statement().boundaries;
    let following = following(problem);
    let in_clay = |b: &&Boundary| {
        is_wall(b.condition)
            && following.get(&b.side()).is_some_and(|(r, _)| !problem.soils[*r].has_friction())
    };
    let index: BTreeMap<LineUse, usize> =
        boundaries.iter().filter(in_clay).enumerate().map(|(i, b)| (b.side(), i)).collect();
    let on_boundary: BTreeMap<LineUse, ()> = boundaries.iter().map(|b| (b.side(), ())).collect();
    // The wall side that is reached along the soil, across the interfaces that end between the two.
    let next = |side: LineUse| {
        let mut here = following.get(&side)?.1;
        for _ in 0..2 * problem.outline.lines.len() {
            if on_boundary.contains_key(&here) {
                return Some(here).filter(|h| index.contains_key(h));
            }
            here = following.get(&LineUse { line: here.line, forward: !here.forward })?.1;
        }
        None
    };
    let mut sides: Vec<(usize, LineUse)> = index.iter().map(|(side, i)| (*i, *side)).collect();
    sides.sort_unstable();
    let mut is_led_to = vec![false; sides.len()];
    for to in sides.iter().filter_map(|(_, side)| next(*side)) {
        is_led_to[index[&to]] = true;
    }
    let mut done = vec![false; sides.len()];
    let mut runs = Vec::new();
    // Runs with a start first; what is left is closed.
    for start in sides.iter().filter(|s| !is_led_to[s.0]).chain(&sides) {
        let (mut run, mut least) = (Vec::new(), usize::MAX);
        let mut here = Some(start.1);
        while let Some(side) = here.filter(|s| !done[index[s]]) {
            done[index[&side]] = true;
            least = least.min(index[&side]);
            run.push(side);
            here = next(side);
        }
        if !run.is_empty() {
            runs.push((least, run));
        }
    }
    runs.sort();
    runs.into_iter().map(|(_, run)| run).collect()
}
