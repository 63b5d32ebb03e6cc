//! The mesh while it is being made: a triangulation, and for each vertex what it is and which size is wanted there.

use std::collections::BTreeMap;

use spade::handles::FixedDirectedEdgeHandle;
use spade::{PositionInTriangulation, Triangulation};

use super::MeshError;
use super::domain::Domain;
use super::flood::flood;
use super::triangulation::{Cdt, EdgeId, FRAME, FaceId, VertexId, to_spade, triangulate};
use super::wanted::{GROWTH, Wanted};
use crate::vector::{Point, distance};

/// Edges of fans, lower node first, which stay as they are; and whether a guide runs along them.
pub(super) type Held = BTreeMap<[usize; 2], bool>;

/// What a vertex is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Kind {
    /// Corner of the frame round everything.
    Frame,
    /// Corner of the outline, with its index.
    Corner(usize),
    /// On a line at a fraction of it.
    Line { line: usize, s: f64 },
    /// On a guide, inside a region.
    Guide(usize),
    /// Free to move inside a region.
    Free(usize),
}

/// A vertex.
#[derive(Debug, Clone, Copy)]
pub(super) struct Node {
    pub(super) at: Point,
    pub(super) kind: Kind,
    /// Wanted size here, graded.
    pub(super) size: f64,
}

/// The mesh in the making. Node numbers are spade's vertex numbers.
pub(super) struct Work<'a> {
    pub(super) domain: &'a Domain<'a>,
    pub(super) wanted: &'a Wanted<'a>,
    pub(super) nodes: Vec<Node>,
    pub(super) cdt: Cdt,
    /// Edges of fans.
    pub(super) held: Held,
    /// Triangles inside regions.
    pub(super) triangles: usize,
}

impl Work<'_> {
    /// Triangulates anew, after vertices have moved.
    pub(super) fn rebuild(&mut self) -> Result<(), MeshError> {
        let edges = self.cdt.undirected_edges().filter(|e| e.is_constraint_edge());
        let constraints: Vec<_> = edges.map(|e| e.vertices().map(|v| v.index())).collect();
        let points: Vec<Point> = self.nodes.iter().map(|n| n.at).collect();
        self.cdt = triangulate(&points, &constraints)?;
        self.count()
    }

    /// Region of every face, by flood fill.
    pub(super) fn regions(&self) -> Result<Vec<Option<usize>>, MeshError> {
        flood(&self.cdt, |e| self.claim(e)).map_err(|conflict| {
            // Not expected: the lines are those that were checked.
            let [x, y] = self.nodes[self.cdt.directed_edge(conflict.edges[0]).from().index()].at;
            MeshError::Numerical { x, y, reason: "a line is not closed".into() }
        })
    }

    pub(super) fn count(&mut self) -> Result<(), MeshError> {
        self.triangles = self.regions()?.iter().flatten().count();
        self.wanted.allow(self.triangles)
    }

    /// The line on which the edge between two nodes lies, if it does, and whether the edge runs along it forwards.
    pub(super) fn line_between(&self, a: usize, b: usize) -> Option<(usize, bool)> {
        let ends = |line: usize| self.domain.statement.lines[line];
        match (self.nodes[a].kind, self.nodes[b].kind) {
            (Kind::Corner(a), Kind::Corner(b)) => self.domain.line_between(a, b),
            (Kind::Line { line, s }, Kind::Line { line: other, s: t }) => {
                (line == other).then_some((line, s < t))
            }
            (Kind::Corner(c), Kind::Line { line, .. }) => {
                ends(line).touches(c).then(|| (line, c == ends(line).from))
            }
            (Kind::Line { line, .. }, Kind::Corner(c)) => {
                ends(line).touches(c).then(|| (line, c == ends(line).to))
            }
            _ => None,
        }
    }

    /// What is claimed on the left of an edge by a line that the edge lies on.
    pub(super) fn claim(&self, edge: FixedDirectedEdgeHandle) -> Option<Option<usize>> {
        let edge = self.cdt.directed_edge(edge);
        if !edge.is_constraint_edge() {
            return None;
        }
        let (line, forward) = self.line_between(edge.from().index(), edge.to().index())?;
        Some(self.domain.left_of(line, forward))
    }

    /// Region of a face. Most faces have a vertex inside a region, which tells it; otherwise the search spreads until
    /// it comes to one or to a line.
    pub(super) fn region(&self, face: FaceId) -> Option<usize> {
        let mut patch = vec![face];
        let mut next = 0;
        while next < patch.len() {
            let face = self.cdt.face(patch[next]);
            for vertex in face.vertices() {
                match self.nodes[vertex.index()].kind {
                    Kind::Guide(region) | Kind::Free(region) => return Some(region),
                    Kind::Frame => return None,
                    Kind::Corner(_) | Kind::Line { .. } => {}
                }
            }
            for edge in face.adjacent_edges() {
                if let Some(claim) = self.claim(edge.fix()) {
                    return claim;
                }
                if let Some(neighbour) = edge.rev().face().as_inner()
                    && !patch.contains(&neighbour.fix())
                {
                    patch.push(neighbour.fix());
                }
            }
            next += 1;
        }
        None
    }

    /// The face at a point, looked for from a vertex that is near.
    pub(super) fn face_at(&self, p: Point, near: usize) -> Option<FaceId> {
        match self.cdt.locate_with_hint(to_spade(p), VertexId::from_index(near)) {
            PositionInTriangulation::OnFace(face) => Some(face),
            PositionInTriangulation::OnEdge(edge) => {
                self.cdt.directed_edge(edge).face().as_inner().map(|f| f.fix())
            }
            PositionInTriangulation::OnVertex(v) => {
                let edge = self.cdt.vertex(v).out_edge()?;
                edge.face().as_inner().map(|f| f.fix())
            }
            PositionInTriangulation::OutsideOfConvexHull(_) | PositionInTriangulation::NoTriangulation => {
                None
            }
        }
    }

    /// Corner positions of a face.
    pub(super) fn corners(&self, face: FaceId) -> [Point; 3] {
        self.cdt.face(face).vertices().map(|v| self.nodes[v.index()].at)
    }

    /// Nodes at the ends of an edge.
    pub(super) fn edge_ends(&self, edge: EdgeId) -> [usize; 2] {
        self.cdt.undirected_edge(edge).vertices().map(|v| v.index())
    }

    /// Graded wanted size at a point near the given nodes.
    pub(super) fn size_near(&self, p: Point, nodes: &[usize]) -> Result<f64, MeshError> {
        let graded = |&n: &usize| self.nodes[n].size + GROWTH * distance(p, self.nodes[n].at);
        Ok(nodes.iter().map(graded).fold(self.wanted.at(p)?, f64::min))
    }

    /// Adds a vertex; `None` if there is one already.
    pub(super) fn insert(&mut self, node: Node, near: usize) -> Result<Option<usize>, MeshError> {
        let index = self.nodes.len();
        let vertex = self
            .cdt
            .insert_with_hint(to_spade(node.at), VertexId::from_index(near))
            .map_err(|e| MeshError::insertion(node.at, e))?;
        if vertex.index() != index {
            return Ok(None);
        }
        self.nodes.push(node);
        Ok(Some(index))
    }

    /// Lowers the sizes around a node to what its own size lets them grow to; nodes that changed are returned.
    pub(super) fn grade(&mut self, from: usize) -> Vec<usize> {
        let mut changed = vec![from];
        let mut next = 0;
        while next < changed.len() {
            let a = changed[next];
            let Node { at, size, .. } = self.nodes[a];
            for edge in self.cdt.vertex(VertexId::from_index(a)).out_edges() {
                let b = edge.to().index();
                let most = size + GROWTH * distance(at, self.nodes[b].at);
                // A little slack, or sizes would creep down for ever.
                if b >= FRAME && self.nodes[b].size > 1.001 * most {
                    self.nodes[b].size = most;
                    changed.push(b);
                }
            }
            next += 1;
        }
        changed
    }

    pub(super) fn grade_all(&mut self) {
        let mut order: Vec<usize> = (FRAME..self.nodes.len()).collect();
        order.sort_by(|&a, &b| self.nodes[a].size.total_cmp(&self.nodes[b].size).then(a.cmp(&b)));
        for node in order {
            self.grade(node);
        }
    }
}
