//! A mesh that is proven to cover the regions exactly once, with what is on the other side of each triangle edge.

mod cover;
mod pairs;

use crate::CertificateError;
use crate::interval::{Interval, Vector};
use crate::mesh::{Mesh, Place, Side};
use crate::problem::{Piece, Problem, exists, finite};
use crate::statement::{Condition, LineUse};

/// Corner `k + i` of a triangle.
pub(crate) fn after(k: usize, i: usize) -> usize {
    (k + i) % 3
}

/// An edge on a side of a line, with the fractions of the line at which it starts and ends, in the triangle's sense.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct OnLine {
    pub(crate) side: LineUse,
    pub(crate) start: f64,
    pub(crate) end: f64,
}

/// What an edge of a triangle adjoins.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Beyond {
    /// The edge of another triangle, with the same vertices.
    Soil(Side),
    /// A boundary.
    Boundary(OnLine, Condition),
}

/// An edge on a member.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct OnMember {
    pub(crate) piece: Piece,
    /// Whether the triangle is on the member's left.
    pub(crate) is_left: bool,
    /// What orders the edges of a member from its start to its end: the place of the line on its path, and how far along that.
    pub(crate) place: (usize, f64),
    /// The fractions of the line between which the edge is, the lesser one first.
    pub(crate) part: [f64; 2],
}

/// An edge along a member: the triangle edges on its left and on its right, at least one, both in soil unless a beam lines the soil.
#[derive(Debug, Clone, Copy)]
pub(crate) struct MemberEdge {
    pub(crate) on: OnMember,
    pub(crate) sides: [Option<Side>; 2],
}

impl MemberEdge {
    pub(crate) fn member(&self) -> usize {
        self.on.piece.member
    }

    /// The edge that stands for both: that on the left, if there is soil.
    pub(crate) fn first(&self) -> Option<Side> {
        self.sides.into_iter().flatten().next()
    }

    /// Both, if there is soil on both sides.
    pub(crate) fn both(&self) -> Option<[Side; 2]> {
        Some([self.sides[0]?, self.sides[1]?])
    }
}

/// A mesh that fits its problem.
#[derive(Debug)]
pub(crate) struct Tiling<'a> {
    pub(crate) mesh: &'a Mesh,
    /// Enclosures of the exact positions of the vertices.
    positions: Vec<Vector>,
    /// For each triangle, what its edges adjoin.
    beyond: Vec<[Beyond; 3]>,
    /// For each triangle, the members on which its edges are.
    members: Vec<[Option<OnMember>; 3]>,
}

impl<'a> Tiling<'a> {
    /// Checks a mesh.
    pub(crate) fn new(problem: &Problem, mesh: &'a Mesh) -> Result<Self, CertificateError> {
        let positions = positions(problem, mesh)?;
        for (i, t) in mesh.triangles.iter().enumerate() {
            let place = || format!("triangle {i}");
            exists(place, "region", t.region, problem.statement.regions.len())?;
            for corner in t.corners {
                exists(place, "vertex", corner, positions.len())?;
            }
        }
        let mut tiling = Self { mesh, positions, beyond: Vec::new(), members: Vec::new() };
        for i in 0..mesh.triangles.len() {
            if !tiling.double_area(i).is_positive() {
                let place = format!("triangle {i}");
                let problem =
                    "its corners are not proven to be counter-clockwise with some area between them";
                return Err(CertificateError::BadMesh { place, problem });
            }
        }
        let across = pairs::across(mesh)?;
        (tiling.beyond, tiling.members) = cover::beyond(problem, mesh, &across)?;
        Ok(tiling)
    }

    /// Positions of the corners of a triangle.
    pub(crate) fn corners(&self, triangle: usize) -> [Vector; 3] {
        self.mesh.triangles[triangle].corners.map(|v| self.positions[v])
    }

    /// Twice the area of a triangle.
    pub(crate) fn double_area(&self, triangle: usize) -> Interval {
        let [p, q, r] = self.corners(triangle);
        (q - p).cross(r - p)
    }

    /// What an edge adjoins.
    pub(crate) fn beyond(&self, side: Side) -> Beyond {
        self.beyond[side.triangle][side.corner]
    }

    /// The member on which an edge is.
    pub(crate) fn member(&self, side: Side) -> Option<OnMember> {
        self.members[side.triangle][side.corner]
    }

    /// All edges along members, in the order of the members, from start to end.
    pub(crate) fn along_members(&self) -> Vec<MemberEdge> {
        let edge = |side: Side| {
            let on = self.member(side)?;
            match self.beyond(side) {
                Beyond::Soil(other) => {
                    on.is_left.then_some(MemberEdge { on, sides: [Some(side), Some(other)] })
                }
                Beyond::Boundary(..) if on.is_left => Some(MemberEdge { on, sides: [Some(side), None] }),
                Beyond::Boundary(..) => Some(MemberEdge { on, sides: [None, Some(side)] }),
            }
        };
        let mut edges: Vec<_> = self.sides().filter_map(edge).collect();
        edges.sort_by(|MemberEdge { on: a, .. }, MemberEdge { on: b, .. }| {
            let key = |on: &OnMember| (on.piece.member, on.place.0);
            key(a).cmp(&key(b)).then(a.place.1.total_cmp(&b.place.1))
        });
        edges
    }

    /// Start and end of an edge along a member, as the member goes.
    pub(crate) fn ends_on_member(&self, edge: &MemberEdge) -> [Vector; 2] {
        let ends = |side: Side| [1, 2].map(|i| self.corners(side.triangle)[after(side.corner, i)]);
        match edge.sides {
            [Some(left), _] => ends(left),
            [None, right] => {
                let [end, start] = right.map_or([Vector::ZERO; 2], ends);
                [start, end]
            }
        }
    }

    /// All edges of all triangles.
    pub(crate) fn sides(&self) -> impl Iterator<Item = Side> + use<> {
        (0..self.beyond.len()).flat_map(|triangle| (0..3).map(move |corner| Side { triangle, corner }))
    }

    /// Region of a triangle.
    pub(crate) fn region(&self, triangle: usize) -> usize {
        self.mesh.triangles[triangle].region
    }

    /// Position of a vertex.
    pub(crate) fn position(&self, vertex: usize) -> Vector {
        self.positions[vertex]
    }
}

/// The fraction of a line at which a vertex is; nothing if the vertex is not declared to be on the line.
pub(crate) fn fraction(problem: &Problem, place: Place, line: usize) -> Option<f64> {
    let ends = problem.statement.lines.get(line)?;
    match place {
        Place::Corner { point } if point == ends.from => Some(0.0),
        Place::Corner { point } if point == ends.to => Some(1.0),
        Place::OnLine { line: on, s } if on == line => Some(s),
        _ => None,
    }
}

fn positions(problem: &Problem, mesh: &Mesh) -> Result<Vec<Vector>, CertificateError> {
    let statement = problem.statement;
    let position = |(i, vertex): (usize, &crate::Vertex)| {
        let place = || format!("vertex {i}");
        match vertex.place {
            Place::Corner { point } => {
                exists(place, "point", point, statement.points.len())?;
                Ok(Vector::point(statement.points[point]))
            }
            Place::OnLine { line, s } => {
                exists(place, "line", line, statement.lines.len())?;
                if s > 0.0 && s < 1.0 {
                    Ok(problem.on_line(line, s))
                } else {
                    let (quantity, allowed) = ("fraction of the line", "above 0 and below 1");
                    Err(CertificateError::OutOfRange {
                        quantity,
                        place: place(),
                        value: s,
                        unit: "",
                        allowed,
                    })
                }
            }
            Place::Inside => {
                for x in vertex.position {
                    finite("coordinate", place, x, "length")?;
                }
                Ok(Vector::point(vertex.position))
            }
        }
    };
    mesh.vertices.iter().enumerate().map(position).collect()
}
