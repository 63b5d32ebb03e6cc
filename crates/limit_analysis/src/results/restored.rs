//! Meshes of certificates as meshes of this crate, for files.

use std::collections::BTreeSet;

use soilctl_certificate::{Place, Statement, Triangle, Vertex};

use super::Point;
use super::finder::centroid;
use super::flow::FlowResults;
use super::msh::write_msh;
use super::stress::StressResults;
use crate::mesh::Mesh;

/// A certificate's mesh, its vertices where its triangles have them.
fn restored(
    statement: &Statement,
    saved: &soilctl_certificate::Mesh,
    corners: &[[Point; 3]],
    guide_edges: Vec<[usize; 2]>,
) -> Mesh {
    let soilctl_certificate::Mesh { mut vertices, triangles } = saved.clone();
    for (triangle, positions) in triangles.iter().zip(corners) {
        for (vertex, position) in triangle.corners.into_iter().zip(positions) {
            vertices[vertex].position = *position;
        }
    }
    Mesh::new(statement, vertices, triangles, guide_edges)
}

impl FlowResults {
    /// The mesh; edges along which the velocity may jump are its guides.
    pub(super) fn restored(&self) -> Mesh {
        let mut guides: Vec<[usize; 2]> = Vec::new();
        for jump in self.jumps().iter().filter(|j| !j.at_structure) {
            let t = self.saved.triangles[jump.triangle].corners;
            let v = &self.shown.corners[jump.triangle];
            if let Some(k) = (0..3).find(|k| v[(k + 1) % 3] == jump.ends[0]) {
                let (a, b) = (t[(k + 1) % 3], t[(k + 2) % 3]);
                guides.push([a.min(b), a.max(b)]);
            }
        }
        guides.sort_unstable();
        guides.dedup();
        restored(&self.statement, &self.saved, &self.shown.corners, guides)
    }

    /// The mesh in gmsh's format, with the lines along which the velocity jumps inside the soil as guides, in units of the
    /// statement.
    #[must_use]
    pub fn msh(&self) -> String {
        let mut mesh = self.restored();
        // Those on lines of the outline are on these.
        let on_lines: BTreeSet<[usize; 2]> =
            mesh.lines.iter().flat_map(|l| l.windows(2)).map(|p| [p[0].min(p[1]), p[0].max(p[1])]).collect();
        mesh.guide_edges.retain(|edge| !on_lines.contains(edge));
        write_msh(&self.statement, &mesh)
    }
}

impl StressResults {
    /// The mesh, each triangle cut into its three parts.
    pub(super) fn thirds(&self) -> Mesh {
        let mut mesh = restored(&self.statement, &self.saved, &self.shown.corners, Vec::new());
        let whole = std::mem::take(&mut mesh.triangles);
        for (t, v) in whole.into_iter().zip(&self.shown.corners) {
            let centre = mesh.vertices.len();
            mesh.vertices.push(Vertex { position: centroid(v), place: Place::Inside });
            for k in 0..3 {
                let corners = [t.corners[(k + 1) % 3], t.corners[(k + 2) % 3], centre];
                mesh.triangles.push(Triangle { corners, region: t.region });
            }
        }
        mesh
    }
}
