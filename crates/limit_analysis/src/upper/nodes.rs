//! Control points of quadratic velocities and vertex copies of stream functions: which triangles share them.

use std::collections::{BTreeMap, BTreeSet};

use soilctl_certificate::{Condition, Side};

use super::meshed::{Edge, MeshedProblem};
use super::toes::SlipEdge;
use crate::members::member_edges;

/// What the flow on a triangle is made of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Element {
    /// Control points: corners, then those of the edges opposite to them.
    Quadratic([usize; 6]),
    /// Vertex copies.
    Stream([usize; 3]),
    /// Isochoric soil around which all is held: at rest.
    Rest,
}

/// The elements of a mesh, with the number of control points and the vertex of each copy.
pub(super) struct Elements {
    pub(super) of: Vec<Element>,
    pub(super) control_points: usize,
    pub(super) copies: Vec<usize>,
    /// Copies on one side of a member that depend on others on the other side, with these and the line.
    pub(super) kinks: BTreeMap<usize, (usize, usize)>,
    /// Copies at toes of walls, with those from which they slip and the vertices towards which they do, one after the other.
    pub(super) slips: Vec<Slipping>,
}

/// A vertex copy that slips.
#[derive(Debug, Clone, Copy)]
pub(super) struct Slipping {
    pub(super) own: usize,
    pub(super) copy: usize,
    pub(super) towards: usize,
}

impl Elements {
    pub(super) fn new(meshed: &MeshedProblem, still: &[bool]) -> Self {
        let rest = enclosed(meshed, still);
        let is_cut = |s: Side| !matches!(meshed.edge(s), Edge::Glued);
        let (mut corners, vertex_of) = meshed.topology.split(meshed.mesh, is_cut);
        weld_at_walls(meshed, &mut corners);
        // Soil with friction and soil without do not share any.
        let mut is_isochoric = vec![false; vertex_of.len()];
        let mut rests = vec![false; vertex_of.len()];
        for (triangle, copies) in corners.iter().enumerate() {
            for copy in copies {
                is_isochoric[*copy] = meshed.is_isochoric(triangle);
                rests[*copy] = rest[triangle];
            }
        }
        let (mut control_points, mut copies) = (0, Vec::new());
        let mut index = Vec::with_capacity(vertex_of.len());
        for (copy, vertex) in vertex_of.into_iter().enumerate() {
            if rests[copy] {
                index.push(usize::MAX);
            } else if is_isochoric[copy] {
                index.push(copies.len());
                copies.push(vertex);
            } else {
                index.push(control_points);
                control_points += 1;
            }
        }
        for all in &mut corners {
            *all = all.map(|c| index[c]);
        }
        weld_sharp_bends(meshed, &mut corners, control_points);
        let mut elements: Vec<Element> = corners
            .iter()
            .enumerate()
            .map(|(triangle, &c)| {
                if rest[triangle] {
                    Element::Rest
                } else if meshed.is_isochoric(triangle) {
                    Element::Stream(c)
                } else {
                    Element::Quadratic([c[0], c[1], c[2], usize::MAX, usize::MAX, usize::MAX])
                }
            })
            .collect();
        for triangle in 0..elements.len() {
            for corner in 0..3 {
                let side = Side { triangle, corner };
                let Element::Quadratic(nodes) = &mut elements[triangle] else { continue };
                if nodes[3 + corner] != usize::MAX {
                    continue;
                }
                nodes[3 + corner] = control_points;
                if let Some(other) = meshed.topology.across[triangle][corner].filter(|_| !is_cut(side))
                    && let Element::Quadratic(nodes) = &mut elements[other.triangle]
                {
                    nodes[3 + other.corner] = control_points;
                }
                control_points += 1;
            }
        }
        let kinks = kinks(meshed, &elements);
        let slips = slips(meshed, &elements);
        Self { of: elements, control_points, copies, kinks, slips }
    }
}

/// Vertex copies of triangles of soil without friction at both ends of the edges of members, on the left and on the right.
fn across_members(
    meshed: &MeshedProblem,
    corners: impl Fn(usize) -> Option<[usize; 3]>,
) -> Vec<([usize; 2], usize)> {
    let mut pairs = Vec::new();
    for e in member_edges(meshed.problem, meshed.mesh, meshed.topology) {
        let Some([side, other]) = e.both() else { continue };
        let (Some(left), Some(right)) = (corners(side.triangle), corners(other.triangle)) else { continue };
        for (i, j) in [(1, 2), (2, 1)] {
            pairs.push(([left[(side.corner + i) % 3], right[(other.corner + j) % 3]], e.line));
        }
    }
    pairs
}

/// Joins both sides of bars and sheets where they are attached to beams or meet walls of soil without friction, which say how it moves.
fn weld_at_walls(meshed: &MeshedProblem, corners: &mut [[usize; 3]]) {
    if meshed.problem.members().is_empty() {
        return;
    }
    let count = corners.iter().flatten().max().map_or(0, |most| most + 1);
    let mut on_wall = vec![false; count];
    for (triangle, copies) in corners.iter().enumerate().filter(|c| meshed.is_isochoric(c.0)) {
        for corner in 0..3 {
            if matches!(meshed.edge(Side { triangle, corner }), Edge::Boundary(c) if c.is_wall()) {
                [1, 2].into_iter().for_each(|i| on_wall[copies[(corner + i) % 3]] = true);
            }
        }
    }
    let copies = |triangle: usize| meshed.is_isochoric(triangle).then(|| corners[triangle]);
    let problem = meshed.problem;
    let mut on_beam = vec![false; count];
    for edge in member_edges(problem, meshed.mesh, meshed.topology) {
        for side in edge.faces().filter(|_| problem.bends(edge.member)) {
            [1, 2].into_iter().for_each(|i| on_beam[corners[side.triangle][(side.corner + i) % 3]] = true);
        }
    }
    let is_at_beam = |line: usize, copy: usize| {
        on_beam[copy] && problem.member_on(line).is_some_and(|member| !problem.bends(member))
    };
    let mut join: Vec<usize> = (0..count).collect();
    for ([left, right], line) in across_members(meshed, copies) {
        if on_wall[left] || on_wall[right] || is_at_beam(line, left) {
            let (from, to) = (join[left].max(join[right]), join[left].min(join[right]));
            join.iter_mut().filter(|j| **j == from).for_each(|j| *j = to);
        }
    }
    corners.iter_mut().for_each(|copies| *copies = copies.map(|c| join[c]));
}

/// Which vertex copies depend on others across members.
fn kinks(meshed: &MeshedProblem, elements: &[Element]) -> BTreeMap<usize, (usize, usize)> {
    let copies = |triangle: usize| match elements[triangle] {
        Element::Stream(copies) => Some(copies),
        Element::Quadratic(_) | Element::Rest => None,
    };
    let mut kinks: BTreeMap<usize, (usize, usize)> = BTreeMap::new();
    let mut firsts: BTreeSet<usize> = BTreeSet::new();
    for ([left, right], line) in across_members(meshed, copies) {
        let pair =
            if kinks.contains_key(&left) || firsts.contains(&right) { [right, left] } else { [left, right] };
        let [first, own] = pair;
        if first != own && !kinks.contains_key(&own) && !kinks.contains_key(&first) {
            firsts.insert(first);
            kinks.insert(own, (first, line));
        }
    }
    kinks
}

/// Which vertex copies slip from others at toes.
fn slips(meshed: &MeshedProblem, elements: &[Element]) -> Vec<Slipping> {
    let of = |edge: &SlipEdge| {
        let [Element::Stream(before), Element::Stream(after)] =
            edge.sides.map(|side| elements[side.triangle])
        else {
            return None;
        };
        let (copy, own) = (before[edge.corners[0]], after[edge.corners[1]]);
        (copy != own).then_some(Slipping { own, copy, towards: edge.towards })
    };
    meshed.toes.edges.iter().filter_map(of).collect()
}

/// Triangles of soil without friction around which all is held: it could not make way for what must open there.
fn enclosed(meshed: &MeshedProblem, still: &[bool]) -> Vec<bool> {
    let count = meshed.mesh.triangles.len();
    let is_still = |triangle: usize| still.get(triangle).copied().unwrap_or(false);
    let (mut done, mut rest) = (vec![false; count], vec![false; count]);
    for first in (0..count).filter(|t| meshed.is_isochoric(*t)) {
        if done[first] {
            continue;
        }
        done[first] = true;
        let (mut part, mut open, mut is_held, mut touches_dilatant) = (Vec::new(), vec![first], true, false);
        while let Some(triangle) = open.pop() {
            part.push(triangle);
            for corner in 0..3 {
                match meshed.edge(Side { triangle, corner }) {
                    Edge::Boundary(c) => {
                        is_held &= matches!(c, Condition::Fixed | Condition::Far | Condition::Smooth);
                    }
                    Edge::Jump { other, .. } => {
                        touches_dilatant = true;
                        is_held &= is_still(other.triangle);
                    }
                    Edge::Member { other } if !meshed.is_isochoric(other.triangle) => {
                        touches_dilatant = true;
                        is_held &= is_still(other.triangle);
                    }
                    Edge::Glued | Edge::Slip { .. } | Edge::Member { .. } => {
                        for next in meshed.topology.across[triangle][corner].iter().map(|o| o.triangle) {
                            if !done[next] {
                                done[next] = true;
                                open.push(next);
                            }
                        }
                    }
                }
            }
        }
        if is_held && touches_dilatant {
            part.into_iter().for_each(|t| rest[t] = true);
        }
    }
    rest
}

/// Joins both sides of a guide at its sharp bends: a wedge of soil between two jumps can leave its notch only if the
/// notch is wider than twice the friction angle.
fn weld_sharp_bends(meshed: &MeshedProblem, corners: &mut [[usize; 3]], count: usize) {
    let mut angle = vec![0.0; count];
    let mut notch = vec![0.0; count];
    let mut jumps = vec![Vec::new(); count];
    let mut other_rim = vec![false; count];
    for (triangle, copies) in corners.iter().enumerate().filter(|c| !meshed.is_isochoric(c.0)) {
        for (k, &copy) in copies.iter().enumerate() {
            angle[copy] += meshed.mesh.angle(triangle, k);
            notch[copy] = 2.0 * meshed.soil(triangle).flow_tan().atan() + 0.1;
            for edge in [(k + 1) % 3, (k + 2) % 3] {
                match meshed.edge(Side { triangle, corner: edge }) {
                    Edge::Jump { other, .. } | Edge::Member { other }
                        if !meshed.is_isochoric(other.triangle) =>
                    {
                        // Corner k lies at the other end of the neighbour's sense of the edge.
                        let at = if edge == (k + 2) % 3 { other.corner + 2 } else { other.corner + 1 } % 3;
                        jumps[copy].push(corners[other.triangle][at]);
                    }
                    Edge::Jump { .. } | Edge::Member { .. } | Edge::Boundary(_) => other_rim[copy] = true,
                    Edge::Glued | Edge::Slip { .. } => {}
                }
            }
        }
    }
    let mut join: Vec<usize> = (0..count).collect();
    for copy in 0..count {
        if !other_rim[copy] && jumps[copy].len() == 2 && angle[copy] < notch[copy] {
            let with = jumps[copy][0];
            let (from, to) = (join[copy].max(join[with]), join[copy].min(join[with]));
            join.iter_mut().for_each(|j| {
                if *j == from {
                    *j = to;
                }
            });
        }
    }
    for (triangle, copies) in corners.iter_mut().enumerate() {
        if !meshed.is_isochoric(triangle) {
            *copies = copies.map(|c| join[c]);
        }
    }
}
