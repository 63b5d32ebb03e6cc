use spade::Triangulation;

use super::MeshError;
use super::triangulation::FRAME;
use super::work::{Kind, Work};

/// A triangulation of all regions of an outline. It is conforming; slits and interfaces are edges like others, with
/// the same vertices on both sides.
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh {
    /// Vertices, each used by a triangle.
    pub vertices: Vec<Vertex>,
    /// Triangles.
    pub triangles: Vec<Triangle>,
    /// For each line of the outline, its vertices from the first point to the last.
    pub lines: Vec<Vec<usize>>,
    /// Edges that follow guides, lower vertex first, in ascending order. Edges on lines are not among them.
    pub guide_edges: Vec<[usize; 2]>,
}

/// A vertex of a mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Vertex {
    /// Where it is, x and y.
    pub position: [f64; 2],
    /// What part of the outline it is on.
    pub place: Place,
}

/// Where a vertex is in the outline.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Place {
    /// At a point of the outline, by index.
    Corner(usize),
    /// On a line, at `from + s (to - from)`, computed by just this formula.
    OnLine {
        /// Index of the line.
        line: usize,
        /// Fraction of the way from the line's first point to its last, between 0 and 1.
        s: f64,
    },
    /// Inside a region, perhaps on a guide.
    Inside,
}

/// A triangle of a mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Triangle {
    /// Its corners, counter-clockwise, as indices of vertices.
    pub corners: [usize; 3],
    /// Index of the region it is in.
    pub region: usize,
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
        let mut lines: Vec<Vec<(f64, usize)>> = vec![Vec::new(); self.domain.outline.lines.len()];
        let mut corner = vec![usize::MAX; self.domain.outline.points.len()];
        for (i, node) in self.nodes.iter().enumerate().skip(FRAME).filter(|&(i, _)| used[i]) {
            number[i] = vertices.len();
            let place = match node.kind {
                Kind::Corner(c) => {
                    corner[c] = number[i];
                    Place::Corner(c)
                }
                Kind::Line { line, s } => {
                    lines[line].push((s, number[i]));
                    Place::OnLine { line, s }
                }
                Kind::Frame | Kind::Guide(_) | Kind::Free(_) => Place::Inside,
            };
            vertices.push(Vertex { position: node.at, place });
        }
        triangles.iter_mut().for_each(|t| t.corners = t.corners.map(|v| number[v]));
        let lines = self.domain.outline.lines.iter().zip(lines).map(|(line, mut inner)| {
            inner.sort_by(|a, b| a.0.total_cmp(&b.0));
            let inner = inner.into_iter().map(|(_, v)| v);
            [corner[line.from]].into_iter().chain(inner).chain([corner[line.to]]).collect()
        });
        let lines = lines.collect();
        let mut guide_edges: Vec<[usize; 2]> = Vec::new();
        for edge in self.cdt.undirected_edges().filter(|e| e.is_constraint_edge()) {
            let [a, b] = self.edge_ends(edge.fix());
            let follows = self.held.get(&[a.min(b), a.max(b)]).copied().unwrap_or(true);
            if follows && self.line_between(a, b).is_none() {
                guide_edges.push([number[a].min(number[b]), number[a].max(number[b])]);
            }
        }
        guide_edges.sort_unstable();
        Ok(Mesh { vertices, triangles, lines, guide_edges })
    }
}
