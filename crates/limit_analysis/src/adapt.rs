//! Meshes that put elements where the gap is.

use crate::mesh::{Mesh, MeshError, SizeField};

/// Smallest edge wanted.
const SMALLEST: f64 = 1e-4;

/// How fast edges may grow with distance.
const GRADING: f64 = 0.3;

/// Wanted edge length of each triangle so that about `target` triangles share the gap evenly.
///
/// A share is taken to scale with the third power of the edge length.
pub(crate) fn wanted_sizes(
    mesh: &Mesh,
    shares: &[f64],
    target: usize,
    largest: f64,
) -> Result<SizeField, MeshError> {
    let total: f64 = shares.iter().map(|s| s.max(0.0)).sum();
    let floor = 1e-6 * total / shares.len() as f64;
    let current: Vec<([f64; 2], f64)> = mesh
        .triangles
        .iter()
        .map(|t| {
            let v = t.corners.map(|c| mesh.vertices[c].position);
            let centre = [(v[0][0] + v[1][0] + v[2][0]) / 3.0, (v[0][1] + v[1][1] + v[2][1]) / 3.0];
            let area =
                0.5 * ((v[1][0] - v[0][0]) * (v[2][1] - v[0][1]) - (v[1][1] - v[0][1]) * (v[2][0] - v[0][0]));
            (centre, (area / 0.433).sqrt())
        })
        .collect();
    let factor = |share: f64, each: f64| (each / share.max(floor)).powf(1.0 / 3.0).clamp(0.15, 3.0);
    // Bisection on what each triangle may carry: the count falls as it grows.
    let count = |each: f64| -> f64 { shares.iter().map(|s| factor(*s, each).powi(-2)).sum() };
    let (mut low, mut high) = (1e-12 * total, total);
    for _ in 0..100 {
        let each = (low * high).sqrt();
        if count(each) > target as f64 { low = each } else { high = each }
    }
    let points: Vec<[f64; 2]> = current.iter().map(|c| c.0).collect();
    let sizes: Vec<f64> = current.iter().zip(shares).map(|((_, h), s)| h * factor(*s, high)).collect();
    SizeField::new(&points, &sizes, SMALLEST, largest, GRADING)
}
