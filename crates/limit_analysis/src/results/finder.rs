use soilctl_certificate::{Adjoins, Side};

use super::Point;
use crate::fields::near;
use crate::vector::twice_area;

/// How far outside of a triangle, as a fraction of its height, a point may be that is still taken for one inside.
const SLACK: f64 = 1e-9;

/// Finds triangles.
#[derive(Debug, Clone)]
pub(super) struct Finder {
    pub(super) corners: Vec<[Point; 3]>,
    across: Vec<[Option<Side>; 3]>,
}

impl Finder {
    pub(super) fn new(corners: &[[Point; 3]], adjoins: &[[Adjoins; 3]]) -> Self {
        let side = |adjoins: Adjoins| match adjoins {
            Adjoins::Soil(other) => Some(other),
            Adjoins::Boundary { .. } => None,
        };
        Self { corners: corners.to_vec(), across: adjoins.iter().map(|a| a.map(side)).collect() }
    }

    /// The triangle that holds a point, looked for from another one on; none outside of the soil.
    pub(super) fn triangle(&self, p: Point, start: usize) -> Option<usize> {
        let start = start.min(self.corners.len().checked_sub(1)?);
        let found = near(&self.corners, &self.across, p, start);
        let inside = barycentric(&self.corners[found], p).iter().all(|l| *l >= -SLACK);
        inside.then_some(found)
    }
}

/// Barycentric coordinates of a point.
pub(super) fn barycentric(v: &[Point; 3], p: Point) -> [f64; 3] {
    let whole = twice_area([v[0], v[1], v[2]]);
    [0, 1, 2].map(|k| twice_area([v[(k + 1) % 3], v[(k + 2) % 3], p]) / whole)
}

/// The point with some barycentric coordinates.
pub(super) fn at(v: &[Point; 3], l: [f64; 3]) -> Point {
    [0, 1].map(|axis| (0..3).map(|k| l[k] * v[k][axis]).sum())
}

pub(super) fn centroid(v: &[Point; 3]) -> Point {
    at(v, [1.0 / 3.0; 3])
}
