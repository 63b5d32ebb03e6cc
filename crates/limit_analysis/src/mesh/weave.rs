//! Weaves guides into the triangulation of the lines.

use spade::Triangulation;
use spade::handles::FixedDirectedEdgeHandle;

use super::MeshError;
use super::guide::{NEAR, Trail};
use super::triangulation::{EdgeId, FRAME, FaceId, VertexId};
use super::work::{Kind, Node, Work};
use crate::vector::{Point, angle, between, distance, distance_to_segment, twice_area};

/// A guide's edge must be at least this angle (25 degrees) from lines and other guides at its ends.
const APART: f64 = 25.0 * std::f64::consts::PI / 180.0;

/// A vertex next to a guide's edge must be away from it by this fraction of its length.
const ASIDE: f64 = 0.25;

/// A guide's vertex must be away from lines and other guides by this fraction of the wanted size.
const BESIDE: f64 = 0.45;

/// What becomes of a point of a guide.
enum Station {
    /// It is this vertex.
    Vertex(usize),
    /// It is too close to a line or another guide, but not to a vertex.
    Close,
    /// It is not in a region.
    Outside,
}

impl Work<'_> {
    /// Makes edges along a trail, station by station. Where that would make slivers there is a gap.
    pub(super) fn weave(&mut self, trail: &Trail) -> Result<(), MeshError> {
        let mut last: Option<usize> = None;
        let mut hint = FRAME;
        let mut skipped = false;
        for p in trail.stations(self.wanted)? {
            let here = match self.station(p, hint)? {
                Station::Vertex(here) => here,
                // On the way to a line the last station before it may be too close; beside a line all are.
                Station::Close if !skipped => {
                    skipped = true;
                    continue;
                }
                Station::Close | Station::Outside => {
                    last = None;
                    continue;
                }
            };
            if let Some(last) = last
                && last != here
            {
                self.connect(last, here);
            }
            last = Some(here);
            hint = here;
            skipped = false;
        }
        Ok(())
    }

    /// The vertex for a station: one that is near, or a new one.
    fn station(&mut self, p: Point, hint: usize) -> Result<Station, MeshError> {
        let Some(face) = self.face_at(p, hint) else { return Ok(Station::Outside) };
        let around = self.around(face, p);
        let by_distance = |&a: &usize, &b: &usize| {
            distance(self.nodes[a].at, p).total_cmp(&distance(self.nodes[b].at, p)).then(a.cmp(&b))
        };
        let real = around.nodes.iter().copied().filter(|&n| n >= FRAME);
        let Some(nearest) = real.min_by(by_distance) else { return Ok(Station::Outside) };
        let size = self.size_near(p, &around.nodes)?;
        if distance(self.nodes[nearest].at, p) < NEAR * size {
            return Ok(Station::Vertex(nearest));
        }
        let Some(region) = self.region(face) else { return Ok(Station::Outside) };
        let is_close = |&edge: &EdgeId| {
            let [a, b] = self.edge_ends(edge).map(|n| self.nodes[n].at);
            distance_to_segment(p, [a, b]) < BESIDE * size
        };
        if around.borders.iter().any(is_close) {
            return Ok(Station::Close);
        }
        let Some(index) = self.insert(Node { at: p, kind: Kind::Guide(region), size }, nearest)? else {
            return Ok(Station::Close);
        };
        self.triangles += 2;
        self.wanted.allow(self.triangles)?;
        self.grade(index);
        Ok(Station::Vertex(index))
    }

    /// Makes an edge between two vertices if that spoils nothing.
    fn connect(&mut self, a: usize, b: usize) {
        let [u, v] = [a, b].map(VertexId::from_index);
        if self.cdt.exists_constraint(u, v)
            || !self.is_apart(a, b)
            || !self.is_apart(b, a)
            || !self.cdt.can_add_constraint(u, v)
        {
            return;
        }
        for edge in self.cdt.try_add_constraint(u, v) {
            if !self.is_sound(edge) {
                self.cdt.remove_constraint_edge(edge.as_undirected());
            }
        }
    }

    /// Whether an edge from `a` to `b` keeps clear of the constraints that `a` has already.
    fn is_apart(&self, a: usize, b: usize) -> bool {
        let along = between(self.nodes[a].at, self.nodes[b].at);
        self.cdt
            .vertex(VertexId::from_index(a))
            .out_edges()
            .filter(|e| e.is_constraint_edge())
            .all(|e| angle(along, between(self.nodes[a].at, self.nodes[e.to().index()].at)) > APART)
    }

    /// Whether a new edge is inside a region and no vertex is too close to it.
    fn is_sound(&self, edge: FixedDirectedEdgeHandle) -> bool {
        let edge = self.cdt.directed_edge(edge);
        let length = distance(self.nodes[edge.from().index()].at, self.nodes[edge.to().index()].at);
        [edge, edge.rev()].into_iter().all(|e| {
            let Some(face) = e.face().as_inner() else { return false };
            let face: FaceId = face.fix();
            twice_area(self.corners(face)) > ASIDE * length * length && self.region(face).is_some()
        })
    }
}
