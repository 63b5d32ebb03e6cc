//! Delaunay refinement: triangles too large or too thin get a vertex in their middle, the worst first.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use spade::Triangulation;

use super::MeshError;
use super::cavity::Walk;
use super::triangulation::{EdgeId, FRAME, FaceId, VertexId};
use super::work::{Kind, Node, Work};
use crate::vector::{Point, angle, between, circumcentre, distance, dot};

/// Largest circumradius, in wanted sizes. An equilateral triangle of the wanted size has 0.577.
const LARGE: f64 = 0.80;

/// Largest ratio of circumradius to shortest edge: 1 / (2 sin 26 degrees).
const THIN: f64 = 1.14;

/// A new vertex is this near to the shortest edge, in lengths of that edge, so that edges grow step by step.
const STEP: f64 = 1.4;

/// Least distance of a new vertex from others, in wanted sizes, for it to be placed off the circumcentre.
const CLEAR: f64 = 0.7;

/// A line's piece longer than this, in wanted sizes, is split for size.
const LONG: f64 = 1.25;

/// A line's piece shorter than this, in wanted sizes, is never split.
const SHORT: f64 = 0.02;

/// A triangle that wants refinement.
struct Task {
    urgency: f64,
    corners: [usize; 3],
}

impl Ord for Task {
    fn cmp(&self, other: &Self) -> Ordering {
        self.urgency.total_cmp(&other.urgency).then_with(|| self.corners.cmp(&other.corners))
    }
}

impl PartialOrd for Task {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Task {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Task {}

/// What refinement needs to know of a triangle.
struct Shape {
    /// Nodes, counter-clockwise, the shortest edge first.
    corners: [usize; 3],
    shortest: f64,
    radius: f64,
    centre: Point,
    /// Wanted size in the triangle.
    size: f64,
}

impl Work<'_> {
    /// Refines until every triangle is of the wanted size and not thin, or cannot be helped.
    pub(super) fn refine(&mut self) -> Result<(), MeshError> {
        let regions = self.regions()?;
        let mut heap = BinaryHeap::new();
        let inside = self.cdt.inner_faces().map(|f| f.fix()).filter(|f| regions[f.index()].is_some());
        for face in inside {
            heap.extend(self.task(face)?);
        }
        while let Some(task) = heap.pop() {
            let Some(face) = self.find(task.corners) else { continue };
            let new = self.treat(face, task.urgency > 1.0)?;
            for &vertex in &new {
                for node in self.grade(vertex) {
                    self.push_around(node, &mut heap)?;
                }
            }
            if !new.is_empty()
                && let Some(face) = self.find(task.corners)
            {
                heap.extend(self.task(face)?);
            }
        }
        Ok(())
    }

    fn push_around(&self, node: usize, heap: &mut BinaryHeap<Task>) -> Result<(), MeshError> {
        for edge in self.cdt.vertex(VertexId::from_index(node)).out_edges() {
            if let Some(face) = edge.face().as_inner()
                && let Some(task) = self.task(face.fix())?
                && self.region(face.fix()).is_some()
            {
                heap.push(task);
            }
        }
        Ok(())
    }

    /// The face with these corners, in this order, if it is still there.
    fn find(&self, [a, b, c]: [usize; 3]) -> Option<FaceId> {
        let edge = self.cdt.get_edge_from_neighbors(VertexId::from_index(a), VertexId::from_index(b))?;
        (edge.opposite_vertex()?.index() == c).then(|| edge.face().as_inner().map(|f| f.fix()))?
    }

    fn shape(&self, face: FaceId) -> Result<Shape, MeshError> {
        let v = self.cdt.face(face).vertices().map(|v| v.index());
        let at = v.map(|n| self.nodes[n].at);
        let length = [0, 1, 2].map(|i| distance(at[i], at[(i + 1) % 3]));
        let mut i = 0;
        for k in 1..3 {
            if length[k] < length[i] {
                i = k;
            }
        }
        let corners = [v[i], v[(i + 1) % 3], v[(i + 2) % 3]];
        let centre = circumcentre(corners.map(|n| self.nodes[n].at));
        let middle = [0, 1].map(|d| (at[0][d] + at[1][d] + at[2][d]) / 3.0);
        let graded = v.iter().map(|&n| self.nodes[n].size).sum::<f64>() / 3.0;
        let size = self.wanted.at(middle)?.min(graded);
        Ok(Shape { corners, shortest: length[i], radius: distance(centre, at[0]), centre, size })
    }

    /// Whether a face inside a region belongs to a fan: then all its edges are held.
    fn is_in_fan(&self, face: FaceId) -> bool {
        let face = self.cdt.face(face);
        // Most faces are not at a corner, and these tell it at once.
        face.vertices().iter().any(|v| matches!(self.nodes[v.index()].kind, Kind::Corner(_)))
            && face.adjacent_edges().into_iter().all(|e| {
                let [a, b] = [e.from().index(), e.to().index()];
                self.held.contains_key(&[a.min(b), a.max(b)])
            })
    }

    /// What is to be done about a face; urgencies above 1 are about size.
    fn task(&self, face: FaceId) -> Result<Option<Task>, MeshError> {
        if self.cdt.face(face).vertices().iter().any(|v| v.index() < FRAME) {
            return Ok(None);
        }
        if self.is_in_fan(face) {
            return Ok(None);
        }
        let shape = self.shape(face)?;
        let (large, thin) = (shape.radius / (LARGE * shape.size), shape.radius / (THIN * shape.shortest));
        let corners = shape.corners;
        if large > 1.0 {
            Ok(Some(Task { urgency: large, corners }))
        } else if thin > 1.0 && !self.is_inevitable(&shape) {
            Ok(Some(Task { urgency: 1.0 - 1.0 / (1.0 + thin), corners }))
        } else {
            Ok(None)
        }
    }

    /// Whether a triangle is thin because lines or guides meet at a small angle: two of its edges lie on them, or its
    /// shortest edge spans the gap between them.
    fn is_inevitable(&self, shape: &Shape) -> bool {
        let [a, b, c] = shape.corners.map(VertexId::from_index);
        if self.cdt.exists_constraint(a, c) && self.cdt.exists_constraint(b, c) {
            return true;
        }
        match (self.nodes[shape.corners[0]].kind, self.nodes[shape.corners[1]].kind) {
            (Kind::Line { line: a, .. }, Kind::Line { line: b, .. }) => self.domain.meet_sharply(a, b),
            _ => false,
        }
    }

    /// Adds a vertex in a triangle, or splits lines that are in the way. Returns the new vertices.
    fn treat(&mut self, face: FaceId, for_size: bool) -> Result<Vec<usize>, MeshError> {
        let shape = self.shape(face)?;
        let Some(region) = self.region(face) else { return Ok(Vec::new()) };
        for p in [self.off_centre(&shape), Some(shape.centre)].into_iter().flatten() {
            let is_centre = p == shape.centre;
            let target = match self.walk(face, p) {
                Walk::Face(target) => target,
                Walk::Blocked(edge) if is_centre => return self.split_all(&[edge], for_size),
                Walk::Blocked(_) | Walk::Lost => continue,
            };
            let around = self.around(target, p);
            let encroached: Vec<EdgeId> =
                around.borders.iter().copied().filter(|&e| self.encroaches(p, e)).collect();
            if !encroached.is_empty() {
                if is_centre {
                    return self.split_all(&encroached, for_size);
                }
                continue;
            }
            let size = self.size_near(p, &around.nodes)?;
            let nearest =
                around.nodes.iter().map(|&n| distance(p, self.nodes[n].at)).fold(f64::INFINITY, f64::min);
            if !is_centre && nearest < CLEAR * size.min(STEP * shape.shortest) {
                continue;
            }
            let node = Node { at: p, kind: Kind::Free(region), size };
            let new = self.insert(node, around.nodes[0])?;
            if new.is_some() {
                self.triangles += 2;
                self.wanted.allow(self.triangles)?;
            }
            return Ok(new.into_iter().collect());
        }
        Ok(Vec::new())
    }

    /// A place on the bisector of the shortest edge, where the new triangle on that edge has the wanted size; `None`
    /// if the circumcentre is hardly farther away.
    fn off_centre(&self, shape: &Shape) -> Option<Point> {
        let [a, b] = [0, 1].map(|i| self.nodes[shape.corners[i]].at);
        let side = (STEP * shape.shortest).min(shape.size).max(0.75 * shape.shortest);
        let height = (side * side - 0.25 * shape.shortest * shape.shortest).sqrt();
        let middle = [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])];
        let away = distance(middle, shape.centre);
        if shape.shortest > 1.5 * shape.size || height > 0.95 * away {
            return None;
        }
        let way = between(middle, shape.centre);
        Some([middle[0] + way[0] * height / away, middle[1] + way[1] * height / away])
    }

    /// Whether `p` sees an edge at more than a right angle.
    fn encroaches(&self, p: Point, edge: EdgeId) -> bool {
        let [a, b] = self.edge_ends(edge).map(|n| between(p, self.nodes[n].at));
        dot(a, b) < 0.0 && angle(a, b) > std::f64::consts::FRAC_PI_2
    }

    /// Splits those of the edges that may be split.
    fn split_all(&mut self, edges: &[EdgeId], for_size: bool) -> Result<Vec<usize>, MeshError> {
        // Splitting renumbers edges, so they are named by their ends.
        let ends: Vec<[usize; 2]> = edges.iter().map(|&e| self.edge_ends(e)).collect();
        let mut new = Vec::new();
        for [a, b] in ends {
            if self.held.contains_key(&[a.min(b), a.max(b)]) {
                continue;
            }
            let length = distance(self.nodes[a].at, self.nodes[b].at);
            let size = 0.5 * (self.nodes[a].size + self.nodes[b].size);
            let [u, v] = [a, b].map(VertexId::from_index);
            let edge = self.cdt.get_edge_from_neighbors(u, v).filter(|e| e.is_constraint_edge());
            let Some(edge) = edge.map(|e| e.as_undirected().fix()) else { continue };
            if length > if for_size { LONG } else { SHORT } * size {
                new.extend(self.split(edge)?);
            }
        }
        Ok(new)
    }
}
