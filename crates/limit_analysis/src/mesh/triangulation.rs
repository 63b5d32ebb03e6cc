//! The constrained Delaunay triangulation, from `spade`, and how it is made.

use spade::{ConstrainedDelaunayTriangulation, Point2, Triangulation};

use super::MeshError;
use crate::vector::Point;

/// A constrained Delaunay triangulation. Its vertex numbers are the order in which points came.
pub(super) type Cdt = ConstrainedDelaunayTriangulation<Point2<f64>>;
/// A vertex of it.
pub(super) type VertexId = spade::handles::FixedVertexHandle;
/// A triangle of it.
pub(super) type FaceId = spade::handles::FixedFaceHandle<spade::handles::InnerTag>;
/// An edge of it, without direction.
pub(super) type EdgeId = spade::handles::FixedUndirectedEdgeHandle;

/// How many vertices the frame has. They come first.
pub(super) const FRAME: usize = 4;

/// The point as spade takes it: what is nearly zero becomes zero.
pub(super) fn to_spade(at: Point) -> Point2<f64> {
    spade::mitigate_underflow(Point2::new(at[0], at[1]))
}

/// Corners of a box well around the points. With it, every vertex and every edge of a domain is surrounded by
/// triangles: the hull of the triangulation is never anybody's boundary.
pub(super) fn frame(points: &[Point]) -> [Point; FRAME] {
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for p in points {
        for d in 0..2 {
            low[d] = low[d].min(p[d]);
            high[d] = high[d].max(p[d]);
        }
    }
    let by = (high[0] - low[0]).max(high[1] - low[1]);
    let (low, high) = (low.map(|c| c - by), high.map(|c| c + by));
    [low, [high[0], low[1]], high, [low[0], high[1]]]
}

/// Triangulates points and constraints one by one. Spade's way to do it all at once keeps what it puts off in hash sets, and so
/// gives other triangles in each run where points are aligned.
///
/// # Errors
///
/// [`MeshError::Numerical`] if points coincide or constraints cross, which the checks before exclude.
pub(super) fn triangulate(points: &[Point], constraints: &[[usize; 2]]) -> Result<Cdt, MeshError> {
    let mut cdt = Cdt::with_capacity(points.len(), 3 * points.len(), 2 * points.len());
    for &p in points {
        cdt.insert(to_spade(p)).map_err(|e| MeshError::insertion(p, e))?;
    }
    let failure =
        |at: Point, reason: &str| MeshError::Numerical { x: at[0], y: at[1], reason: reason.into() };
    if cdt.num_vertices() != points.len() {
        return Err(failure(points[0], "two vertices coincide"));
    }
    for &[a, b] in constraints {
        let ends = [a, b].map(VertexId::from_index);
        if cdt.try_add_constraint(ends[0], ends[1]).is_empty() {
            return Err(failure(points[a], "two edges cross"));
        }
    }
    Ok(cdt)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn aligned_points_are_always_triangulated_alike() {
        let n = 12;
        let place = |i: usize| [(i % n) as f64, (i / n) as f64];
        let inner: Vec<Point> = (0..n * n).map(place).collect();
        let points: Vec<Point> = frame(&inner).into_iter().chain(inner).collect();
        let rows = (0..n).flat_map(|row| (1..n).map(move |i| FRAME + row * n + i));
        let constraints: Vec<[usize; 2]> = rows.map(|i| [i - 1, i]).collect();
        let faces = || -> Vec<[usize; 3]> {
            let cdt = triangulate(&points, &constraints).unwrap();
            cdt.inner_faces().map(|f| f.vertices().map(|v| v.index())).collect()
        };
        let first = faces();
        assert!((0..20).all(|_| faces() == first));
    }
}
