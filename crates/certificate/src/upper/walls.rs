//! Walls: runs of boundary sides of soil without friction along which the velocity across is given.
//!
//! With `v = (s_y, -s_x)`, the stream function changes by `v x t` for each unit along `t`: by what flows out across a side
//! that is walked with the soil on the left. So along a wall it is known but for a constant. All fixed, far and smooth
//! sides are at rest, faces have the velocity of the structure: between the ends of a side the change is `V x (to -
//! from)`, exactly linear.

use std::collections::BTreeMap;

use super::check::is_frictionless;
use crate::CertificateError;
use crate::fields::{Flow, UpperField};
use crate::interval::{Interval, Vector};
use crate::mesh::Place;
use crate::problem::Problem;
use crate::runs::Run;
use crate::statement::{Boundary, Condition, LineUse};
use crate::tiling::{Beyond, Tiling, after, fraction};

/// A side of a wall.
#[derive(Debug, Clone, Copy)]
pub(super) struct WallSide {
    pub(super) wall: usize,
    pub(super) side: LineUse,
    /// Its velocity, of which the part across is that of the soil.
    pub(super) velocity: Vector,
    /// The stream function at its start less that at the start of the wall.
    start: Interval,
    /// Position among the sides of the wall, and that of the side that it leads to.
    at: usize,
    next: Option<usize>,
}

impl WallSide {
    /// `velocity x (to - from)` of its line.
    pub(super) fn flow(&self, problem: &Problem) -> Interval {
        self.velocity.cross(problem.direction(self.side.line))
    }

    /// Whether a side is the next one of the same wall, and a place where they meet.
    pub(super) fn leads_to(&self, problem: &Problem, next: &Self, place: Place) -> bool {
        let [end, start] = [self.ends(problem)[1], next.ends(problem)[0]];
        self.wall == next.wall
            && self.next == Some(next.at)
            && end == start
            && place == Place::Corner { point: end }
    }

    /// Point at which it starts, point at which it ends.
    fn ends(&self, problem: &Problem) -> [usize; 2] {
        problem.statement.lines[self.side.line].walked(self.side.forward)
    }

    /// The stream function at a fraction of the line, less that at the start of the wall.
    pub(super) fn value(&self, problem: &Problem, s: f64) -> Interval {
        let s = Interval::point(s);
        let way = if self.side.forward { s } else { s - Interval::ONE };
        self.start + self.flow(problem) * way
    }
}

/// All walls, and which of their sides the vertex copies of a field are on.
pub(super) struct Walls {
    /// For each vertex copy, the sides on which it is the end of an edge.
    at: Vec<[Option<WallSide>; 2]>,
}

/// Whether the velocity across a boundary is given along the soil without friction there.
fn is_wall(problem: &Problem, boundary: &Boundary) -> bool {
    boundary.condition.is_wall()
        && problem.owner(boundary.side()).is_some_and(|r| is_frictionless(problem.statement, r))
}

impl Walls {
    pub(super) fn new(
        problem: &Problem,
        tiling: &Tiling,
        field: &UpperField,
    ) -> Result<Self, CertificateError> {
        let runs = problem.statement.runs(|b| is_wall(problem, b));
        // Statements may have walls that belong to soil at rest.
        let streams = field.flows.iter().any(|f| matches!(f, Flow::Stream { .. }));
        if streams && field.walls.len() != runs.len() {
            let (found, needed) = (field.walls.len(), runs.len());
            return Err(CertificateError::Length { list: "walls", found, needed, each: "wall" });
        }
        let mut sides = BTreeMap::new();
        for (wall, run) in runs.iter().enumerate() {
            for side in follow(problem, wall, run, streams)? {
                sides.insert(side.side, side);
            }
        }
        let mut walls = Self { at: vec![[None; 2]; field.stream.len()] };
        for edge in tiling.sides() {
            let Flow::Stream { corners, .. } = field.flows[edge.triangle] else { continue };
            let Beyond::Boundary(on, _) = tiling.beyond(edge) else { continue };
            let Some(side) = sides.get(&on.side) else { continue };
            for copy in [1, 2].map(|i| corners[after(edge.corner, i)]) {
                let place = field.mesh.vertices[field.stream[copy].vertex].place;
                if !walls.note(problem, copy, place, side) {
                    let problem = "it is at two places of walls that do not follow each other there";
                    return Err(CertificateError::BadField { place: format!("vertex copy {copy}"), problem });
                }
            }
        }
        Ok(walls)
    }

    /// Notes that a vertex copy is on a side. It may be on two if it is where one leads to the other.
    fn note(&mut self, problem: &Problem, copy: usize, place: Place, side: &WallSide) -> bool {
        match &mut self.at[copy] {
            [Some(a), _] if a.side == side.side => true,
            [_, Some(b)] if b.side == side.side => true,
            [slot @ None, _] => {
                *slot = Some(*side);
                true
            }
            [Some(a), slot @ None]
                if a.leads_to(problem, side, place) || side.leads_to(problem, a, place) =>
            {
                *slot = Some(*side);
                true
            }
            _ => false,
        }
    }

    /// Sides on which a vertex copy is the end of an edge.
    pub(super) fn at(&self, copy: usize) -> [Option<WallSide>; 2] {
        self.at[copy]
    }
}

/// The sides of a run, one after the other. Checks that nothing is carried around a closed one, if there is any flow.
fn follow(
    problem: &Problem,
    wall: usize,
    run: &Run,
    streams: bool,
) -> Result<Vec<WallSide>, CertificateError> {
    let count = run.sides.len();
    let mut sides = Vec::with_capacity(count);
    let mut start = Interval::ZERO;
    // How often each point is the end of a part of the wall that carries something, less how often the start; and the same
    // for all of it that moves. If either is zero everywhere, what is carried adds up to nothing.
    let mut ends: [BTreeMap<usize, i32>; 2] = [BTreeMap::new(), BTreeMap::new()];
    for (at, side) in run.sides.iter().enumerate() {
        let moves = matches!(problem.condition(*side), Some(Condition::Face { .. }));
        let velocity =
            if moves { Vector::point(problem.statement.objective.velocity()) } else { Vector::ZERO };
        let next = if at + 1 < count { Some(at + 1) } else { run.closed.then_some(0) };
        let here = WallSide { wall, side: *side, velocity, start, at, next };
        let [from, to] = here.ends(problem);
        let counts = [!here.flow(problem).is_zero(), moves];
        for (ends, _) in ends.iter_mut().zip(counts).filter(|(_, counts)| *counts) {
            *ends.entry(from).or_default() -= 1;
            *ends.entry(to).or_default() += 1;
        }
        start = here.value(problem, if side.forward { 1.0 } else { 0.0 });
        sides.push(here);
    }
    let carries = ends.iter().all(|ends| ends.values().any(|count| *count != 0));
    if streams && run.closed && carries {
        let what = "a closed wall around soil without friction of which only a part moves";
        return Err(CertificateError::NotCovered { place: format!("wall {wall}"), what });
    }
    Ok(sides)
}

/// The fraction of a side's line at which a vertex is.
pub(super) fn way(problem: &Problem, place: Place, side: &WallSide) -> Option<f64> {
    fraction(problem, place, side.side.line)
}
