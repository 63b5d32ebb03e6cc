//! The consistent set over one triangle of the (phi, delta) plane, enclosed in a convex polytope.

use crate::convex::{Point, area_centroid, clip};
use crate::end_factor::EndFactors;

/// A linear function on a triangle: values at its three corners.
#[derive(Clone, Copy)]
pub(crate) struct Plane(pub(crate) [f64; 3]);

/// A row or column of lattice cells: lower edge and width in lattice units.
pub(crate) type Strip = (i32, i32);

/// Lower and upper density bounds over a triangle, each set reduced to those that matter somewhere in it.
pub(crate) struct Piece {
    /// Lattice cell the triangle belongs to: lower corner in phi and delta, size.
    cell: [i32; 3],
    corners: [Point; 3],
    ends: EndFactors,
    lower: Vec<Plane>,
    upper: Vec<Plane>,
    /// Part of the triangle in (phi, delta) where every lower bound is below every upper bound.
    base: Vec<Point>,
}

impl Piece {
    /// The set between the bounds over the part of a triangle where delta lies in `delta` and phi in `phi`, for end factors
    /// in an interval; `None` if it is empty. Corners counter-clockwise.
    pub(crate) fn new(
        cell: [i32; 3],
        corners: [Point; 3],
        ends: EndFactors,
        lower: Vec<Plane>,
        upper: Vec<Plane>,
        phi: (f64, f64),
        delta: (f64, f64),
    ) -> Option<Self> {
        let lower = undominated(lower, |a, b| a <= b);
        let upper = undominated(upper, |a, b| a >= b);
        let mut piece = Self { cell, corners, ends, lower, upper, base: corners.to_vec() };
        for (d, (low, high)) in [phi, delta].into_iter().enumerate() {
            piece.base = clip(&piece.base, |p| p[d] - low);
            piece.base = clip(&piece.base, |p| high - p[d]);
        }
        for lo in &piece.lower {
            for hi in &piece.upper {
                piece.base = clip(&piece.base, |p| value(&corners, hi, p) - value(&corners, lo, p));
            }
        }
        (piece.base.len() >= 3).then_some(piece)
    }

    /// The column of cells in phi that this piece stands in: lower edge and width.
    pub(crate) const fn phi_strip(&self) -> Strip {
        (self.cell[0], self.cell[2])
    }

    /// The row of cells in delta that this piece stands in.
    pub(crate) const fn delta_strip(&self) -> Strip {
        (self.cell[1], self.cell[2])
    }

    /// End factors for which it holds.
    pub(crate) const fn ends(&self) -> EndFactors {
        self.ends
    }

    /// Shadow on the (phi, delta) plane.
    pub(crate) fn base(&self) -> &[Point] {
        &self.base
    }

    /// Points whose hull is the shadow on the plane of one base coordinate (0 phi, 1 delta) and density: the lifted
    /// vertices.
    pub(crate) fn shadow(&self, coordinate: usize) -> Vec<Point> {
        let mut points = Vec::new();
        for (planes, side) in [(&self.lower, 1.0), (&self.upper, -1.0)] {
            for (plane, part) in self.parts(planes, side) {
                points.extend(part.iter().map(|&p| [p[coordinate], value(&self.corners, plane, p)]));
            }
        }
        points
    }

    /// Volume in deg2 kg/m3 of pieces over one triangle together. At each point of the triangle what they leave of the density is
    /// one interval, because what measurements leave of density and density times end factor is convex there.
    pub(crate) fn volume_together(pieces: &[Self]) -> f64 {
        let [alone] = pieces else {
            let Some(first) = pieces.first() else { return 0.0 };
            let (area, _) = area_centroid(&first.corners);
            let height = |p: Point| {
                let ranges = pieces.iter().filter_map(|piece| piece.densities(p));
                let hull = ranges.reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])]);
                hull.map_or(0.0, |[low, high]| high - low)
            };
            let points = midpoints(&first.corners, QUADRATURE);
            return area.abs() * points.iter().map(|&p| height(p)).sum::<f64>() / points.len() as f64;
        };
        alone.volume()
    }

    /// Whether it stands over the same triangle as another one.
    pub(crate) fn beside(&self, other: &Self) -> bool {
        self.corners == other.corners
    }

    /// Densities left at a point of the triangle; `None` if none are.
    fn densities(&self, p: Point) -> Option<[f64; 2]> {
        let at = |plane: &Plane| value(&self.corners, plane, p);
        let low = self.lower.iter().map(at).fold(f64::NEG_INFINITY, f64::max);
        let high = self.upper.iter().map(at).fold(f64::INFINITY, f64::min);
        (low <= high).then_some([low, high])
    }

    /// Volume in deg2 kg/m3: the density range integrated over the base.
    fn volume(&self) -> f64 {
        let integral = |planes: &[Plane], side: f64| -> f64 {
            self.parts(planes, side)
                .map(|(plane, part)| {
                    let (area, centroid) = area_centroid(&part);
                    area.abs() * value(&self.corners, plane, centroid)
                })
                .sum()
        };
        integral(&self.upper, -1.0) - integral(&self.lower, 1.0)
    }

    /// The base cut into the parts on which each plane is the binding one.
    fn parts<'a>(
        &'a self,
        planes: &'a [Plane],
        side: f64,
    ) -> impl Iterator<Item = (&'a Plane, Vec<Point>)> + 'a {
        planes.iter().enumerate().filter_map(move |(i, plane)| {
            let mut part = self.base.clone();
            for (j, other) in planes.iter().enumerate() {
                if i != j && !part.is_empty() {
                    part = clip(&part, |p| {
                        side * (value(&self.corners, plane, p) - value(&self.corners, other, p))
                    });
                }
            }
            (!part.is_empty()).then_some((plane, part))
        })
    }
}

/// Rows of smaller triangles whose centres the volume of several pieces is summed over.
const QUADRATURE: usize = 6;

/// Centres of the triangles into which one is cut by rows.
fn midpoints([a, b, c]: &[Point; 3], rows: usize) -> Vec<Point> {
    let third = 1.0 / (3.0 * rows as f64);
    let mut points = Vec::with_capacity(rows * rows);
    for i in 0..rows {
        for j in 0..rows - i {
            for (step, fits) in [(1.0, true), (2.0, i + j + 2 <= rows)] {
                if fits {
                    let u = (3.0 * i as f64 + step) * third;
                    let v = (3.0 * j as f64 + step) * third;
                    points.push([0, 1].map(|d| a[d] + u * (b[d] - a[d]) + v * (c[d] - a[d])));
                }
            }
        }
    }
    points
}

/// Drops planes that another one makes redundant at all three corners, hence everywhere between them.
fn undominated(planes: Vec<Plane>, weaker: impl Fn(f64, f64) -> bool) -> Vec<Plane> {
    let mut kept: Vec<Plane> = Vec::with_capacity(2);
    for plane in planes {
        let beaten_by = |other: &Plane| (0..3).all(|c| weaker(plane.0[c], other.0[c]));
        if kept.iter().any(beaten_by) {
            continue;
        }
        kept.retain(|other| !(0..3).all(|c| weaker(other.0[c], plane.0[c])));
        kept.push(plane);
    }
    kept
}

/// Value of a plane at a point, by the point's barycentric coordinates.
fn value(corners: &[Point; 3], plane: &Plane, p: Point) -> f64 {
    let [a, b, c] = corners;
    let (bx, by, cx, cy) = (b[0] - a[0], b[1] - a[1], c[0] - a[0], c[1] - a[1]);
    let (px, py) = (p[0] - a[0], p[1] - a[1]);
    let scale = 1.0 / (bx * cy - by * cx);
    let (u, v) = ((px * cy - py * cx) * scale, (bx * py - by * px) * scale);
    plane.0[0] + u * (plane.0[1] - plane.0[0]) + v * (plane.0[2] - plane.0[0])
}

#[cfg(test)]
mod tests {
    use super::*;

    const CORNERS: [Point; 3] = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]];

    #[test]
    fn a_prism_has_the_volume_of_a_prism() {
        let piece = Piece::new(
            [0, 0, 1],
            CORNERS,
            EndFactors::ANY,
            vec![Plane([1.0; 3]), Plane([0.5; 3])],
            vec![Plane([3.0; 3])],
            (0.0, 1.0),
            (0.0, 1.0),
        )
        .unwrap();
        assert!((piece.volume() - 1.0).abs() < 1e-15);
        assert!((area_centroid(&crate::convex::hull(piece.shadow(0))).0 - 2.0).abs() < 1e-15);
    }

    #[test]
    fn a_tent_over_half_the_triangle() {
        // Upper bound falls from 1 to -1 along phi, lower bound is 0: only phi < 1/2 is left.
        let piece = Piece::new(
            [0, 0, 1],
            CORNERS,
            EndFactors::ANY,
            vec![Plane([0.0; 3])],
            vec![Plane([1.0, -1.0, -1.0])],
            (0.0, 1.0),
            (0.0, 1.0),
        )
        .unwrap();
        let reach = piece.base().iter().map(|p| p[0]).fold(0.0, f64::max);
        assert!((reach - 0.5).abs() < 1e-15);
        // Volume: integral over phi in 0..1/2 of phi (1 - 2 phi).
        assert!((piece.volume() - 1.0 / 24.0).abs() < 1e-15);
        assert!(
            Piece::new(
                [0, 0, 1],
                CORNERS,
                EndFactors::ANY,
                vec![Plane([2.0; 3])],
                vec![Plane([1.0; 3])],
                (0., 1.),
                (0., 1.)
            )
            .is_none()
        );
    }
}
