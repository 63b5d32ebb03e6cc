//! Meshes that put elements where the gap is.

use crate::mesh::{Mesh, MeshError, SizeField};
use crate::vector::{Point, centroid, twice_area};

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
    let corners = || (0..mesh.triangles.len()).map(|t| mesh.corners(t));
    let points: Vec<Point> = corners().map(|v| centroid(&v)).collect();
    let factor = |share: f64, each: f64| (each / share.max(floor)).powf(1.0 / 3.0).clamp(0.15, 3.0);
    // Bisection on what each triangle may carry: the count falls as it grows.
    let count = |each: f64| -> f64 { shares.iter().map(|s| factor(*s, each).powi(-2)).sum() };
    let (mut low, mut high) = (1e-12 * total, total);
    for _ in 0..100 {
        let each = (low * high).sqrt();
        if count(each) > target as f64 { low = each } else { high = each }
    }
    // The edge of the equilateral triangle of the same area, times what makes the shares even.
    let size = |(v, share): ([Point; 3], &f64)| (0.5 * twice_area(v) / 0.433).sqrt() * factor(*share, high);
    let sizes: Vec<f64> = corners().zip(shares).map(size).collect();
    SizeField::new(&points, &sizes, SMALLEST, largest, GRADING)
}
