//! How triangles hang together: edges, boundary sides, and vertices split where the mesh is cut.

use std::collections::BTreeMap;

use soilctl_certificate::{LineUse, Side};

use crate::mesh::Mesh;

/// Neighbours and outline sides of each triangle edge. Edge `k` of a triangle lies opposite to its corner `k` and runs
/// from corner `k + 1` to corner `k + 2`.
#[derive(Debug, Clone)]
pub(crate) struct Topology {
    /// The triangle side across each edge, if there is one.
    pub(crate) across: Vec<[Option<Side>; 3]>,
    /// The outline line on which each edge lies, in the triangle's sense of rotation.
    pub(crate) line: Vec<[Option<LineUse>; 3]>,
    /// Whether velocities may jump across the edge because it lies on a guide.
    pub(crate) guide: Vec<[bool; 3]>,
}

impl Topology {
    pub(crate) fn new(mesh: &Mesh) -> Self {
        let mut line_of = BTreeMap::new();
        for (line, vertices) in mesh.lines.iter().enumerate() {
            for pair in vertices.windows(2) {
                line_of.insert((pair[0], pair[1]), LineUse { line, forward: true });
                line_of.insert((pair[1], pair[0]), LineUse { line, forward: false });
            }
        }
        let mut side_of = BTreeMap::new();
        for (triangle, t) in mesh.triangles.iter().enumerate() {
            for corner in 0..3 {
                let edge = (t.corners[(corner + 1) % 3], t.corners[(corner + 2) % 3]);
                side_of.insert(edge, Side { triangle, corner });
            }
        }
        let n = mesh.triangles.len();
        let mut topology =
            Self { across: vec![[None; 3]; n], line: vec![[None; 3]; n], guide: vec![[false; 3]; n] };
        for (&(a, b), side) in &side_of {
            let Side { triangle, corner } = *side;
            topology.across[triangle][corner] = side_of.get(&(b, a)).copied();
            topology.line[triangle][corner] = line_of.get(&(a, b)).copied();
            topology.guide[triangle][corner] = mesh.guide_edges.binary_search(&[a.min(b), a.max(b)]).is_ok();
        }
        topology
    }

    /// Splits every vertex into one copy for each fan of triangles that hang together across edges that are not cut.
    /// Returns the copy at each triangle corner, and the vertex of each copy.
    pub(crate) fn split(&self, mesh: &Mesh, cut: impl Fn(Side) -> bool) -> (Vec<[usize; 3]>, Vec<usize>) {
        let mut copies = vec![[usize::MAX; 3]; mesh.triangles.len()];
        let mut vertex_of = Vec::new();
        for triangle in 0..mesh.triangles.len() {
            for corner in 0..3 {
                if copies[triangle][corner] != usize::MAX {
                    continue;
                }
                let vertex = mesh.triangles[triangle].corners[corner];
                let copy = vertex_of.len();
                vertex_of.push(vertex);
                let mut open = vec![triangle];
                while let Some(t) = open.pop() {
                    let Some(c) = mesh.triangles[t].corners.iter().position(|v| *v == vertex) else {
                        continue;
                    };
                    if copies[t][c] != usize::MAX {
                        continue;
                    }
                    copies[t][c] = copy;
                    for edge in [(c + 1) % 3, (c + 2) % 3] {
                        let side = Side { triangle: t, corner: edge };
                        if !cut(side) {
                            open.extend(self.across[t][edge].map(|s| s.triangle));
                        }
                    }
                }
            }
        }
        (copies, vertex_of)
    }
}
