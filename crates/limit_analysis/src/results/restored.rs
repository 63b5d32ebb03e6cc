//! Meshes of certificates as meshes of this crate, for files.

use std::collections::BTreeSet;

use soilctl_certificate::{Place, Statement};

use super::Point;
use super::finder::centroid;
use super::flow::FlowResults;
use super::stress::StressResults;
use crate::error::LimitError;
use crate::mesh::{self, files::write_msh};
use crate::problem::Problem;

/// A certificate's mesh, its vertices where its triangles have them.
fn restored(
    statement: &Statement,
    saved: &soilctl_certificate::Mesh,
    corners: &[[Point; 3]],
    guide_edges: Vec<[usize; 2]>,
) -> mesh::Mesh {
    let mut vertices: Vec<mesh::Vertex> = saved
        .vertices
        .iter()
        .map(|v| {
            let place = match v.place {
                Place::Corner { point } => mesh::Place::Corner(point),
                Place::OnLine { line, s } => mesh::Place::OnLine { line, s },
                Place::Inside => mesh::Place::Inside,
            };
            mesh::Vertex { position: v.position, place }
        })
        .collect();
    for (triangle, positions) in saved.triangles.iter().zip(corners) {
        for (vertex, position) in triangle.corners.into_iter().zip(positions) {
            vertices[vertex].position = *position;
        }
    }
    let mut on_points = vec![None; statement.points.len()];
    let mut inner: Vec<Vec<(f64, usize)>> = vec![Vec::new(); statement.lines.len()];
    for (i, v) in vertices.iter().enumerate() {
        match v.place {
            mesh::Place::Corner(point) => on_points[point] = Some(i),
            mesh::Place::OnLine { line, s } => inner[line].push((s, i)),
            mesh::Place::Inside => {}
        }
    }
    let lines = statement.lines.iter().zip(inner).map(|(line, mut inner)| {
        inner.sort_by(|a, b| a.0.total_cmp(&b.0));
        let inner = inner.into_iter().map(|(_, v)| v);
        on_points[line.from].into_iter().chain(inner).chain(on_points[line.to]).collect()
    });
    let triangles = saved.triangles.iter().map(|t| mesh::Triangle { corners: t.corners, region: t.region });
    mesh::Mesh { triangles: triangles.collect(), lines: lines.collect(), vertices, guide_edges }
}

impl FlowResults {
    /// The mesh; edges along which the velocity may jump are its guides.
    pub(super) fn restored(&self) -> mesh::Mesh {
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
    ///
    /// # Errors
    ///
    /// [`LimitError`] if the statement is not a problem.
    pub fn msh(&self) -> Result<String, LimitError> {
        let problem = Problem::new(self.statement.clone())?;
        let mut mesh = self.restored();
        // Those on lines of the outline are on these.
        let on_lines: BTreeSet<[usize; 2]> =
            mesh.lines.iter().flat_map(|l| l.windows(2)).map(|p| [p[0].min(p[1]), p[0].max(p[1])]).collect();
        mesh.guide_edges.retain(|edge| !on_lines.contains(edge));
        Ok(write_msh(&problem.outline, &mesh))
    }
}

impl StressResults {
    /// The mesh, each triangle cut into its three parts.
    pub(super) fn thirds(&self) -> mesh::Mesh {
        let mut mesh = restored(&self.statement, &self.saved, &self.shown.corners, Vec::new());
        let whole = std::mem::take(&mut mesh.triangles);
        for t in whole {
            let v = t.corners.map(|c| mesh.vertices[c].position);
            let centre = mesh.vertices.len();
            mesh.vertices.push(mesh::Vertex { position: centroid(&v), place: mesh::Place::Inside });
            for k in 0..3 {
                let corners = [t.corners[(k + 1) % 3], t.corners[(k + 2) % 3], centre];
                mesh.triangles.push(mesh::Triangle { corners, region: t.region });
            }
        }
        mesh
    }
}
