//! Solved fields as plain numbers, and how to find one's way in them.

use crate::lower::{Lower, node_stresses};
use crate::mesh::Mesh;
use crate::topology::{Side, Topology};
use crate::upper::Upper;

pub(crate) type Point = [f64; 2];

/// A stress field: values `[xx, yy, xy]` at the nodes of the three parts of each triangle.
#[derive(Debug, Clone)]
pub(crate) struct StressField {
    pub(crate) corners: Vec<[Point; 3]>,
    pub(crate) across: Vec<[Option<Side>; 3]>,
    pub(crate) parts: Vec<[[[f64; 3]; 3]; 3]>,
}

/// A velocity field: control points of each triangle.
#[derive(Debug, Clone)]
pub(crate) struct VelocityField {
    pub(crate) control: Vec<[Point; 6]>,
}

impl StressField {
    pub(crate) fn new(mesh: &Mesh, topology: &Topology, lower: &Lower, x: &[f64]) -> Self {
        let corners = mesh.triangles.iter().map(|t| t.corners.map(|c| mesh.vertices[c].position)).collect();
        let parts = (0..mesh.triangles.len())
            .map(|t| {
                node_stresses(&lower.reference, mesh, &lower.function, t)
                    .map(|part| part.map(|s| s.map_or([0.0; 3], |s| s.map(|f| f.value(x)))))
            })
            .collect();
        Self { corners, across: topology.across.clone(), parts }
    }

    pub(crate) fn centre(&self, t: usize) -> Point {
        let v = &self.corners[t];
        [(v[0][0] + v[1][0] + v[2][0]) / 3.0, (v[0][1] + v[1][1] + v[2][1]) / 3.0]
    }
}

/// A triangle near a point: a walk towards it that stops at holes and rims.
pub(crate) fn near(corners: &[[Point; 3]], across: &[[Option<Side>; 3]], p: Point, start: usize) -> usize {
    let mut here = start;
    for _ in 0..corners.len() {
        let v = &corners[here];
        let outside = (0..3)
            .map(|k| (k, doubled_area(v[(k + 1) % 3], v[(k + 2) % 3], p)))
            .filter(|(k, a)| *a < 0.0 && across[here][*k].is_some())
            .min_by(|a, b| a.1.total_cmp(&b.1));
        match outside.and_then(|(k, _)| across[here][k]) {
            Some(next) => here = next.triangle,
            None => break,
        }
    }
    here
}

impl VelocityField {
    pub(crate) fn new(upper: &Upper, x: &[f64]) -> Self {
        let control = upper
            .nodes
            .iter()
            .map(|nodes| nodes.map(|n| [upper.velocities[n][0].value(x), upper.velocities[n][1].value(x)]))
            .collect();
        Self { control }
    }
}

pub(crate) fn doubled_area(a: Point, b: Point, c: Point) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}
