//! What a point would meet if it became a vertex.

use spade::Triangulation;

use super::triangulation::{EdgeId, FaceId};
use super::work::Work;
use crate::vector::{Point, between, cross, in_circle};

/// The surroundings of a point: what its vertex would be joined to.
pub(super) struct Around {
    /// Vertices of the triangles that would go.
    pub(super) nodes: Vec<usize>,
    /// Lines' and guides' edges that bound those triangles.
    pub(super) borders: Vec<EdgeId>,
}

/// Where a walk ends.
pub(super) enum Walk {
    /// In this face.
    Face(FaceId),
    /// At this constraint edge, which is in the way.
    Blocked(EdgeId),
    /// Nowhere: rounding led it round in circles.
    Lost,
}

impl Work<'_> {
    /// The triangles whose circumcircles contain `p`, as far as they can be reached from `face` without crossing lines
    /// or guides.
    pub(super) fn around(&self, face: FaceId, p: Point) -> Around {
        let mut faces = vec![face];
        let mut around = Around { nodes: Vec::with_capacity(12), borders: Vec::new() };
        let mut next = 0;
        while next < faces.len() {
            for edge in self.cdt.face(faces[next]).adjacent_edges() {
                let v = edge.from().index();
                if !around.nodes.contains(&v) {
                    around.nodes.push(v);
                }
                if edge.is_constraint_edge() {
                    around.borders.push(edge.as_undirected().fix());
                } else if let Some(neighbour) = edge.rev().face().as_inner()
                    && !faces.contains(&neighbour.fix())
                    && in_circle(self.corners(neighbour.fix()), p)
                {
                    faces.push(neighbour.fix());
                }
            }
            next += 1;
        }
        around
    }

    /// Walks straight from the middle of a face to `p`.
    pub(super) fn walk(&self, start: FaceId, p: Point) -> Walk {
        let t = self.corners(start);
        let origin = [0, 1].map(|d| (t[0][d] + t[1][d] + t[2][d]) / 3.0);
        let way = between(origin, p);
        let mut face = start;
        let mut entered = None;
        for _ in 0..10_000 {
            let ahead = self.cdt.face(face).adjacent_edges().into_iter().find(|e| {
                let [a, b] = [e.from(), e.to()].map(|v| self.nodes[v.index()].at);
                Some(e.as_undirected().fix()) != entered
                    && cross(between(a, b), between(a, p)) < 0.0
                    && cross(way, between(origin, a)) <= 0.0
                    && cross(way, between(origin, b)) >= 0.0
            });
            let Some(edge) = ahead else { return Walk::Face(face) };
            let crossed = edge.as_undirected().fix();
            if edge.is_constraint_edge() {
                return Walk::Blocked(crossed);
            }
            let Some(beyond) = edge.rev().face().as_inner() else { return Walk::Lost };
            face = beyond.fix();
            entered = Some(crossed);
        }
        Walk::Lost
    }
}
