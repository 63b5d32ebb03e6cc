//! Members on a mesh: their edges, from start to end.

use soilctl_certificate::{Grip, LineUse, Member, Place, Side};

use crate::mesh::Mesh;
use crate::problem::Problem;
use crate::topology::Topology;
use crate::vector::{Point, between, dot, length, midpoint};

/// Grip over a typical stress in the soil that is as good as none.
const NEGLIGIBLE: f64 = 1e-4;

/// A triangle edge on a member.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct MemberEdge {
    pub(crate) member: usize,
    /// The edge as the triangle on the member's left sees it, and as that on its right does: where a beam lines the soil there is one only.
    pub(crate) sides: [Option<Side>; 2],
    /// The line, and whether the member goes along it from its first point to its last.
    pub(crate) line: usize,
    pub(crate) is_forward: bool,
    /// The place of the line on the member's path, and the fractions of the line at the edge's start and end.
    pub(crate) piece: usize,
    pub(crate) fractions: [f64; 2],
    /// Start and end, as the member goes.
    pub(crate) ends: [Point; 2],
    /// How far along the member they are.
    pub(crate) place: [f64; 2],
    /// Whether they are the member's own ends.
    pub(crate) is_end: [bool; 2],
}

impl MemberEdge {
    /// Unit vector along the member.
    pub(crate) fn along(&self) -> Point {
        let d = between(self.ends[0], self.ends[1]);
        d.map(|x| x / length(d))
    }

    pub(crate) fn length(&self) -> f64 {
        length(between(self.ends[0], self.ends[1]))
    }

    /// The triangles' edges, the left one first.
    pub(crate) fn faces(&self) -> impl Iterator<Item = Side> + use<> {
        self.sides.into_iter().flatten()
    }

    /// The triangle edge that stands for it.
    pub(crate) fn first(&self) -> Side {
        self.faces().next().unwrap_or(Side { triangle: 0, corner: 0 })
    }

    /// What soil hands to a row of bars over the length of the edge, at its start and its end; nothing if the member is no such row.
    pub(crate) fn gripped(&self, member: &Member) -> Option<Gripped> {
        let Grip { resistance: [from, to], part: [first, last] } =
            *member.pullout.as_ref()?.get(self.piece)?;
        let at = self.fractions.map(|s| (from + (to - from) * s).max(0.0));
        let [start, end] = if self.is_forward {
            self.fractions
        } else {
            let [a, b] = self.fractions;
            [b, a]
        };
        // As the certificate has it.
        Some(if (from, to) == (0.0, 0.0) || end <= first || start >= last {
            Gripped { is_free: true, most: [0.0; 2] }
        } else {
            Gripped { is_free: start < first || end > last, most: at }
        })
    }

    /// Whether the force of a row of bars is to be one along the edge: the soil hands them nothing there, or so little that the program's accuracy
    /// could not tell.
    pub(crate) fn is_free(&self, problem: &Problem, mesh: &Mesh) -> bool {
        let Some(gripped) = self.gripped(&problem.members()[self.member]) else { return false };
        let region = mesh.triangles[self.first().triangle].region;
        let stress = problem.stress_scale(region, midpoint(self.ends[0], self.ends[1]), self.length());
        let [from, to] = gripped.most;
        gripped.is_free || from.min(to) < NEGLIGIBLE * stress
    }

    /// Both, if there is soil on both sides.
    pub(crate) fn both(&self) -> Option<[Side; 2]> {
        Some([self.sides[0]?, self.sides[1]?])
    }
}

/// The resistance to slip of a row of bars along an edge.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Gripped {
    /// Whether it is zero on some of the edge, so that stresses must not count on it.
    pub(crate) is_free: bool,
    /// The most that it may be at the start and at the end.
    pub(crate) most: [f64; 2],
}

/// All edges of all members, one member after the other.
pub(crate) fn member_edges(problem: &Problem, mesh: &Mesh, topology: &Topology) -> Vec<MemberEdge> {
    let mut edges = Vec::new();
    if problem.members().is_empty() {
        return edges;
    }
    for triangle in 0..mesh.triangles.len() {
        for corner in 0..3 {
            let side = Side { triangle, corner };
            let Some(on) = topology.line[triangle][corner] else { continue };
            let other = topology.across[triangle][corner].filter(|_| problem.condition(on).is_none());
            let (left, sides) = match problem.member_whose_left_is(on) {
                Some(_) => (on, [Some(side), other]),
                // That on the left stands for both.
                None if other.is_some() => continue,
                None => (on.reversed(), [None, Some(side)]),
            };
            let Some(member) = problem.member_whose_left_is(left) else { continue };
            let [start, end] = problem.member_ends(member);
            let corners = mesh.triangles[triangle].corners;
            let mut vertices = [1, 2].map(|i| &mesh.vertices[corners[(corner + i) % 3]]);
            if left != on {
                vertices.reverse();
            }
            let ends = vertices.map(|vertex| vertex.position);
            let fractions = vertices.map(|vertex| match vertex.place {
                Place::OnLine { s, .. } => s,
                Place::Corner { point } if problem.statement().lines[left.line].from == point => 0.0,
                Place::Corner { .. } | Place::Inside => 1.0,
            });
            let path = &problem.members()[member].path;
            let piece = path.iter().position(|side| *side == left).unwrap_or(0);
            let d = between(start, end);
            let place = ends.map(|p| dot(between(start, p), d) / length(d));
            let is_end = [ends[0] == start, ends[1] == end];
            let (line, is_forward) = (left.line, left.forward);
            edges.push(MemberEdge { member, sides, line, is_forward, piece, fractions, ends, place, is_end });
        }
    }
    edges.sort_by(|a, b| a.member.cmp(&b.member).then(a.place[0].total_cmp(&b.place[0])));
    edges
}

/// Whether it bears any force.
pub(crate) fn bears_force(member: &Member) -> bool {
    member.tension > 0.0 || member.compression > 0.0 || member.bending.is_some()
}

/// The beam that an end of a flexible member is attached to.
pub(crate) fn beam_at_end(problem: &Problem, member: usize, end: usize) -> Option<usize> {
    let (statement, m) = (problem.statement(), &problem.members()[member]);
    let point = problem.member_end_point(member, end);
    let touches = |side: &LineUse| statement.lines[side.line].touches(point);
    let is_loose = m.bending.is_some() || !m.attached[end];
    if is_loose {
        None
    } else {
        statement.members.iter().position(|m| m.bending.is_some() && m.path.iter().any(touches))
    }
}

/// Velocity of what an end of a member is attached to, along the member; nothing if it is attached to nothing, or to a beam.
pub(crate) fn velocity_at_end(problem: &Problem, member: usize, end: usize) -> Option<f64> {
    use soilctl_certificate::Condition::Face;
    let statement = problem.statement();
    let m = &statement.members[member];
    if !m.attached[end] || beam_at_end(problem, member, end).is_some() {
        return None;
    }
    let point = problem.member_end_point(member, end);
    let meets_structure = statement
        .boundaries
        .iter()
        .any(|b| matches!(b.condition, Face { .. }) && statement.lines[b.line].touches(point));
    let [a, b] = problem.member_ends(member);
    let d = between(a, b);
    Some(if meets_structure { dot(problem.velocity(), d) / length(d) } else { 0.0 })
}
