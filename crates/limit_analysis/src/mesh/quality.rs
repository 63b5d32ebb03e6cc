use super::extract::Mesh;
use crate::vector::{angles, distance};

/// How good a mesh is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quality {
    /// Number of triangles.
    pub triangles: usize,
    /// Smallest angle of any triangle, degrees; at most 60.
    pub min_angle_deg: f64,
    /// Mean over triangles of the smallest angle, degrees; at most 60.
    pub mean_angle_deg: f64,
    /// Length of the shortest edge, m.
    pub shortest_edge: f64,
    /// Length of the longest edge, m.
    pub longest_edge: f64,
}

impl Mesh {
    /// Statistics of the triangles.
    pub fn quality(&self) -> Quality {
        let (mut least, mut sum, mut shortest, mut longest) = (60f64, 0.0, f64::INFINITY, 0f64);
        for t in &self.triangles {
            let p = t.corners.map(|v| self.vertices[v].position);
            let angle = angles(p).into_iter().fold(60f64, |low, a| low.min(a.to_degrees()));
            least = least.min(angle);
            sum += angle;
            for i in 0..3 {
                let length = distance(p[i], p[(i + 1) % 3]);
                shortest = shortest.min(length);
                longest = longest.max(length);
            }
        }
        Quality {
            triangles: self.triangles.len(),
            min_angle_deg: least,
            mean_angle_deg: sum / self.triangles.len().max(1) as f64,
            shortest_edge: shortest,
            longest_edge: longest,
        }
    }
}
