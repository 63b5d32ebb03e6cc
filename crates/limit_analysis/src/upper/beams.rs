//! How beams move across themselves: straight between places where they may bend.
//!
//! A flow bends a beam at few places. If it could at every vertex, the least errors of the solver in short edges would turn it again and
//! again, and each turn costs the moment.

use std::collections::BTreeMap;

use soilctl_conic::{Form, Program};

use super::meshed::MeshedProblem;
use crate::members::{MemberEdge, beam_at_end, member_edges};
use crate::problem::Problem;
use crate::vector::{between, dot, length};

/// Places between the ends at which a beam may bend, at most.
const BENDS: f64 = 24.0;

/// The velocity of one beam across itself, to its left.
#[derive(Debug, Clone)]
pub(super) struct BeamMotion {
    /// Where it may bend, from its start to its end, and its velocity there.
    bends: Vec<(f64, Form)>,
    /// In soil without friction, the stream function at the start.
    constant: Form,
}

impl BeamMotion {
    fn new(places: &[f64], program: &mut Program) -> Self {
        let bends = places.iter().map(|place| (*place, Form::unknown(program.unknown(), 1.0))).collect();
        Self { bends, constant: Form::default() }
    }

    /// Hangs the stream function on an unknown constant.
    pub(super) fn float(&mut self, unit: f64, program: &mut Program) {
        self.constant = Form::unknown(program.unknown(), unit);
    }

    /// The velocity at a place.
    pub(super) fn across(&self, place: f64) -> Form {
        let next =
            self.bends.iter().position(|(end, _)| place <= *end).unwrap_or(self.bends.len() - 1).max(1);
        let [(from, a), (to, b)] = [&self.bends[next - 1], &self.bends[next]];
        let s = (place - from) / (to - from);
        if s == 0.0 {
            return a.clone();
        }
        if s == 1.0 { b.clone() } else { Form::default().plus(1.0 - s, a).plus(s, b) }
    }

    /// The stream function at a place: its slope along the beam is the velocity with its sign changed.
    pub(super) fn stream(&self, place: f64) -> Form {
        let mut value = self.constant.clone();
        for pair in self.bends.windows(2) {
            let [(from, a), (to, b)] = [&pair[0], &pair[1]];
            let s = ((place - from) / (to - from)).clamp(0.0, 1.0);
            value = value.plus(-(to - from) * (s - 0.5 * s * s), a).plus(-(to - from) * 0.5 * s * s, b);
        }
        value
    }
}

/// All beams that move like this: not those that are clamped where the soil has no friction, which the walls there hold.
pub(super) fn motions(meshed: &MeshedProblem, program: &mut Program) -> BTreeMap<usize, BeamMotion> {
    let problem = meshed.problem;
    let edges = member_edges(problem, meshed.mesh, meshed.topology);
    let of = |beam: usize| edges.iter().filter(move |edge| edge.member == beam);
    let is_held = |beam: usize| {
        let is_isochoric = |edge: &MemberEdge| edge.faces().any(|side| meshed.is_isochoric(side.triangle));
        problem.members()[beam].attached.contains(&true) && of(beam).any(is_isochoric)
    };
    let beams = (0..problem.members().len()).filter(|m| problem.bends(*m) && !is_held(*m));
    beams.map(|beam| (beam, BeamMotion::new(&places(problem, beam, of(beam)), program))).collect()
}

/// Where a beam may bend: at some of its vertices, and where others are attached.
fn places<'a>(problem: &Problem, beam: usize, edges: impl Iterator<Item = &'a MemberEdge>) -> Vec<f64> {
    let [start, end] = problem.member_ends(beam);
    let d = between(start, end);
    let whole = length(d);
    let ties = (0..problem.members().len()).flat_map(|member| [0, 1].map(|end| (member, end)));
    let at_ties: Vec<f64> = ties
        .filter(|(member, end)| beam_at_end(problem, *member, *end) == Some(beam))
        .map(|(member, end)| dot(between(start, problem.member_ends(member)[end]), d) / whole)
        .collect();
    let is_tied = |place: f64| at_ties.iter().any(|tie| (tie - place).abs() < 1e-9 * whole);
    let (mut places, mut last) = (Vec::new(), 0.0);
    for [from, to] in edges.map(|edge| edge.place) {
        if places.is_empty() {
            places.push(from);
        }
        let before = *places.last().unwrap_or(&from);
        if to - before >= whole / BENDS || is_tied(to) {
            places.push(to);
        }
        last = to;
    }
    if *places.last().unwrap_or(&last) < last {
        places.push(last);
    }
    places
}
