//! Walls of soil without friction: runs of boundary sides along which the velocity across is given, in the order and
//! with the starts that certificates use (see `StreamJet` there).

use std::collections::BTreeMap;

use soilctl_certificate::{Boundary, Condition, LineUse};

use crate::problem::Problem;
use crate::vector::between;

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
    let is_stream_wall = |b: &Boundary| {
        b.condition.is_wall() && problem.owner(b.side()).is_some_and(|r| !problem.soils[r].has_friction())
    };
    let runs = problem.statement().runs(is_stream_wall);
    for (wall, run) in runs.iter().enumerate() {
        let mut start = 0.0;
        for side in &run.sides {
            let [p, q] = problem.ends(side.line);
            let condition = problem.condition(*side);
            let moves = matches!(condition, Some(Condition::Face { .. }));
            let here = WallSide {
                wall,
                line: side.line,
                forward: side.forward,
                direction: between(p, q),
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
