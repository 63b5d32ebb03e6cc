use soilctl_certificate::{Place, Statement, Triangle, Vertex};
use spade::Triangulation;

use super::MeshError;
use super::triangulation::FRAME;
use super::work::{Kind, Work};
use crate::vector::{Point, along, angle, between};

/// A triangulation of all regions of a statement, with where its lines and guides run. It is conforming; slits and
/// interfaces are edges like others, with the same vertices on both sides.
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh {
    /// Vertices, each used by a triangle. Positions on a line are computed by just `from + s (to - from)`.
    pub vertices: Vec<Vertex>,
    /// Triangles.
    pub triangles: Vec<Triangle>,
    /// For each line of the statement, its vertices from the first point to the last.
    pub lines: Vec<Vec<usize>>,
    /// Edges that follow guides, lower vertex first, in ascending order. Edges on lines are not among them.
    pub guide_edges: Vec<[usize; 2]>,
}

impl Mesh {
    /// A mesh whose vertices know by their places which lines they are on.
    pub(crate) fn new(
        statement: &Statement,
        vertices: Vec<Vertex>,
        triangles: Vec<Triangle>,
        guide_edges: Vec<[usize; 2]>,
    ) -> Self {
        let mut corner = vec![None; statement.points.len()];
        let mut inner: Vec<Vec<(f64, usize)>> = vec![Vec::new(); statement.lines.len()];
        for (i, v) in vertices.iter().enumerate() {
            match v.place {
                Place::Corner { point } => corner[point] = Some(i),
                Place::OnLine { line, s } => inner[line].push((s, i)),
                Place::Inside => {}
            }
        }
        let lines = statement.lines.iter().zip(inner).map(|(line, mut inner)| {
            inner.sort_by(|a, b| a.0.total_cmp(&b.0));
            let inner = inner.into_iter().map(|(_, v)| v);
            corner[line.from].into_iter().chain(inner).chain(corner[line.to]).collect()
        });
        Self { lines: lines.collect(), vertices, triangles, guide_edges }
    }

    /// Positions of a triangle's corners.
    pub(crate) fn corners(&self, triangle: usize) -> [Point; 3] {
        self.triangles[triangle].corners.map(|v| self.vertices[v].position)
    }

    /// The angle at a triangle's corner in radians.
    pub(crate) fn angle(&self, triangle: usize, corner: usize) -> f64 {
        let v = self.corners(triangle);
        angle(between(v[corner], v[(corner + 1) % 3]), between(v[corner], v[(corner + 2) % 3]))
    }

    /// The mesh as certificates store it.
    pub(crate) fn saved(&self) -> soilctl_certificate::Mesh {
        soilctl_certificate::Mesh { vertices: self.vertices.clone(), triangles: self.triangles.clone() }
    }
}

/// A new vertex at a fraction of the edge between two, on the line that holds the edge if one does.
pub(crate) fn vertex_on_edge(
    statement: &Statement,
    line: Option<usize>,
    [p, q]: [Vertex; 2],
    s: f64,
) -> Vertex {
    let Some(line) = line else {
        return Vertex { position: along(p.position, q.position, s), place: Place::Inside };
    };
    let ends = statement.lines[line];
    let fraction = |v: Vertex| match v.place {
        Place::OnLine { s, .. } => s,
        Place::Corner { point } if point == ends.from => 0.0,
        Place::Corner { .. } | Place::Inside => 1.0,
    };
    let s = fraction(p) + s * (fraction(q) - fraction(p));
    let position = along(statement.points[ends.from], statement.points[ends.to], s);
    Vertex { position, place: Place::OnLine { line, s } }
}

impl Work<'_> {
    /// The finished mesh: triangles inside regions, and the vertices they use.
    pub(super) fn extract(&self) -> Result<Mesh, MeshError> {
        let regions = self.regions()?;
        let mut triangles = Vec::with_capacity(self.triangles);
        let mut used = vec![false; self.nodes.len()];
        for face in self.cdt.inner_faces() {
            if let Some(region) = regions[face.index()] {
                let corners = face.vertices().map(|v| v.index());
                corners.iter().for_each(|&v| used[v] = true);
                triangles.push(Triangle { corners, region });
            }
        }
        let mut number = vec![usize::MAX; self.nodes.len()];
        let mut vertices = Vec::new();
        for (i, node) in self.nodes.iter().enumerate().skip(FRAME).filter(|&(i, _)| used[i]) {
            number[i] = vertices.len();
            let place = match node.kind {
                Kind::Corner(point) => Place::Corner { point },
                Kind::Line { line, s } => Place::OnLine { line, s },
                Kind::Frame | Kind::Guide(_) | Kind::Free(_) => Place::Inside,
            };
            vertices.push(Vertex { position: node.at, place });
        }
        triangles.iter_mut().for_each(|t| t.corners = t.corners.map(|v| number[v]));
        let mut guide_edges: Vec<[usize; 2]> = Vec::new();
        for edge in self.cdt.undirected_edges().filter(|e| e.is_constraint_edge()) {
            let [a, b] = self.edge_ends(edge.fix());
            let follows = self.held.get(&[a.min(b), a.max(b)]).copied().unwrap_or(true);
            if follows && self.line_between(a, b).is_none() {
                guide_edges.push([number[a].min(number[b]), number[a].max(number[b])]);
            }
        }
        guide_edges.sort_unstable();
        Ok(Mesh::new(self.domain.statement, vertices, triangles, guide_edges))
    }
}
