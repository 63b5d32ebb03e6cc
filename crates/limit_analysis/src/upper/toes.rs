//! Toes of walls in soil without friction: where a wall moves and the ground beside it does not, velocities of the soil differ from triangle to
//! triangle around, and soil slips along the edges between them.

use std::collections::BTreeSet;

use soilctl_certificate::{Condition, Place, Side};

use crate::mesh::Mesh;
use crate::problem::Problem;
use crate::topology::Topology;
use crate::vector::between;

/// An edge that ends at a toe.
#[derive(Debug, Clone, Copy)]
pub(super) struct SlipEdge {
    /// The triangles on both sides: first that which is nearer to the ground at rest.
    pub(super) sides: [Side; 2],
    /// Vertex at the other end.
    pub(super) towards: usize,
    /// The corners at the toe of both triangles.
    pub(super) corners: [usize; 2],
}

/// All edges along which soil slips at toes: those around each toe one after the other, from the ground at rest on.
#[derive(Debug, Default)]
pub(crate) struct Toes {
    pub(super) edges: Vec<SlipEdge>,
    of: BTreeSet<Side>,
}

impl Toes {
    pub(crate) fn new(problem: &Problem, mesh: &Mesh, topology: &Topology) -> Self {
        let mut edges: Vec<SlipEdge> = Vec::new();
        for (triangle, t) in mesh.triangles.iter().enumerate() {
            for corner in 0..3 {
                let is_corner = matches!(mesh.vertices[t.corners[corner]].place, Place::Corner { .. });
                if is_corner && let Some(fan) = Fan::starting_at(problem, mesh, topology, triangle, corner) {
                    edges.extend(fan.slip_edges(problem, mesh));
                }
            }
        }
        // An edge to another place where something is known of the flow is none, nor are two that meet.
        let ends: Vec<usize> = edges.iter().map(|edge| edge.towards).collect();
        let is_apart = |edge: &SlipEdge| {
            mesh.vertices[edge.towards].place == Place::Inside
                && ends.iter().filter(|end| **end == edge.towards).count() == 1
        };
        edges.retain(is_apart);
        let of = edges.iter().flat_map(|edge| edge.sides).collect();
        Self { edges, of }
    }

    /// Whether soil may slip along an edge.
    pub(super) fn slips(&self, side: Side) -> bool {
        self.of.contains(&side)
    }
}

/// The triangles around a vertex on the rim of soil without friction, counter-clockwise, each with its corner there.
struct Fan {
    triangles: Vec<(usize, usize)>,
    /// What holds on its first and its last edge.
    rim: [(Side, Condition); 2],
}

impl Fan {
    /// That which starts at the edge after this corner, if that is on the rim and the other end of the fan too.
    fn starting_at(
        problem: &Problem,
        mesh: &Mesh,
        topology: &Topology,
        triangle: usize,
        corner: usize,
    ) -> Option<Self> {
        let on_rim = |side: Side| {
            let line = topology.line[side.triangle][side.corner]?;
            Some((side, problem.condition(line)?))
        };
        let vertex = mesh.triangles[triangle].corners[corner];
        let first = on_rim(Side { triangle, corner: (corner + 2) % 3 })?;
        let mut triangles = Vec::new();
        let (mut t, mut c) = (triangle, corner);
        loop {
            if !problem.soils[mesh.triangles[t].region].is_isochoric {
                return None;
            }
            triangles.push((t, c));
            let last = Side { triangle: t, corner: (c + 1) % 3 };
            if let Some(last) = on_rim(last) {
                return Some(Self { triangles, rim: [first, last] });
            }
            let member = topology.line[t][last.corner].is_some_and(|l| problem.member_on(l.line).is_some());
            let next = topology.across[t][last.corner].filter(|_| !member)?;
            t = next.triangle;
            c = mesh.triangles[t].corners.iter().position(|v| *v == vertex)?;
            if triangles.len() > mesh.triangles.len() {
                return None;
            }
        }
    }

    /// The edges between its triangles, if it is at a toe, from the ground at rest to the wall.
    fn slip_edges(&self, problem: &Problem, mesh: &Mesh) -> Vec<SlipEdge> {
        let [first, last] = self.rim;
        let is_from_first = meet_at_toe(problem, mesh, first, last);
        if !is_from_first && !meet_at_toe(problem, mesh, last, first) {
            return Vec::new();
        }
        let edge = |pair: &[(usize, usize)]| {
            let [(before, at), (after, there)] = [pair[0], pair[1]];
            let sides = [
                Side { triangle: before, corner: (at + 1) % 3 },
                Side { triangle: after, corner: (there + 2) % 3 },
            ];
            let towards = mesh.triangles[after].corners[(there + 1) % 3];
            SlipEdge { sides, towards, corners: [at, there] }
        };
        let mut edges: Vec<SlipEdge> = self.triangles.windows(2).map(edge).collect();
        if !is_from_first {
            edges.reverse();
            for edge in &mut edges {
                edge.sides.reverse();
                edge.corners.reverse();
            }
        }
        edges
    }
}

/// Whether ground that does not move meets a wall there that goes into the soil, or pulls at it, in a way that soil of one velocity cannot follow.
fn meet_at_toe(
    problem: &Problem,
    mesh: &Mesh,
    (ground, at_rest): (Side, Condition),
    (wall, moves): (Side, Condition),
) -> bool {
    let Condition::Face { .. } = moves else { return false };
    let along = |side: Side| {
        let v = mesh.corners(side.triangle);
        between(v[(side.corner + 1) % 3], v[(side.corner + 2) % 3])
    };
    // Into the soil, which is on the left.
    let ([x, y], [vx, vy]) = (along(wall), problem.velocity());
    let inwards = x * vy - y * vx;
    if !(inwards > 0.0 || (inwards < 0.0 && moves.is_wall())) {
        return false;
    }
    let [gx, gy] = along(ground);
    match at_rest {
        Condition::Fixed | Condition::Far => true,
        Condition::Smooth => gx * y - gy * x == 0.0,
        Condition::Free
        | Condition::Loaded { .. }
        | Condition::Lined { .. }
        | Condition::Submerged
        | Condition::Face { .. } => false,
    }
}
