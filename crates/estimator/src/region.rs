use std::collections::BTreeMap;

use i_overlay::core::fill_rule::FillRule;
use i_overlay::core::overlay_rule::OverlayRule;
use i_overlay::float::simplify::SimplifyShape;
use i_overlay::float::single::SingleFloatOverlay;

use crate::convex::{Point, area_centroid, hull};
use crate::piece::Strip;

/// A closed curve of `[x, y]` points; the first point is not repeated at the end.
pub type Ring = Vec<[f64; 2]>;

/// Densities are divided by this inside polygon operations, so that both axes have similar extents.
const DENSITY_SCALE: f64 = 100.0;
/// Pieces are grown by this much before they are united, so that neighbours overlap in spite of rounding.
const GROWTH: f64 = 1e-6;
/// A set in a parameter plane: polygons with holes, possibly several, possibly none.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Region {
    polygons: Vec<Vec<Ring>>,
}

impl Region {
    /// Union of the hulls of point sets in the plane of an angle (degrees) and density (kg/m3).
    pub(crate) fn of_angle_and_density(pieces: impl IntoIterator<Item = (Strip, Vec<Point>)>) -> Self {
        Self::union(pieces, DENSITY_SCALE)
    }

    /// Union of the hulls of point sets in the plane of two angles.
    pub(crate) fn of_angles(pieces: impl IntoIterator<Item = (Strip, Vec<Point>)>) -> Self {
        Self::union(pieces, 1.0)
    }

    /// Union of the hulls of point sets whose coordinates were divided by scales.
    pub(crate) fn of_scaled(pieces: impl IntoIterator<Item = (Strip, Vec<Point>)>, scales: [f64; 2]) -> Self {
        let mut scaled = Self::union(pieces, 1.0);
        for point in scaled.polygons.iter_mut().flatten().flatten() {
            *point = [point[0] * scales[0], point[1] * scales[1]];
        }
        scaled
    }

    /// Pieces that stand in the same narrow strip and overlap are replaced by their convex hull, which differs from
    /// their union by the square of the strip's width; the hulls are united by the library on its 64-bit integer
    /// grid. Every contour is counter-clockwise, so "non-zero" means "in any of them".
    fn union(pieces: impl IntoIterator<Item = (Strip, Vec<Point>)>, y_scale: f64) -> Self {
        let mut strips: BTreeMap<Strip, Vec<Vec<Point>>> = BTreeMap::new();
        for (strip, piece) in pieces {
            if piece.len() >= 3 {
                strips.entry(strip).or_default().push(piece);
            }
        }
        let contours: Vec<Ring> =
            strips.into_values().flat_map(hulls).map(|piece| grown(&piece, y_scale)).collect();
        let mut polygons = contours.simplify_shape_as::<i64>(FillRule::NonZero);
        for point in polygons.iter_mut().flatten().flatten() {
            point[1] *= y_scale;
        }
        Self { polygons }
    }

    /// Whether nothing is consistent.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.polygons.is_empty()
    }

    /// Area in the product of the axes' units.
    #[must_use]
    pub fn area(&self) -> f64 {
        // Holes run the other way round and count negative.
        self.rings().map(|ring| area_centroid(ring).0).sum::<f64>().abs()
    }

    /// Least and greatest value of both coordinates, `([x_low, x_high], [y_low, y_high])`.
    #[must_use]
    pub fn bounds(&self) -> Option<([f64; 2], [f64; 2])> {
        let ends = |d: usize| {
            let values = self.rings().flatten().map(|p| p[d]);
            values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
        };
        (!self.is_empty()).then(|| (ends(0), ends(1)))
    }

    /// Centroid.
    #[must_use]
    pub fn centroid(&self) -> Option<[f64; 2]> {
        let (mut area, mut x, mut y) = (0.0, 0.0, 0.0);
        for ring in self.rings() {
            let (a, c) = area_centroid(ring);
            area += a;
            x += a * c[0];
            y += a * c[1];
        }
        (area != 0.0).then(|| [x / area, y / area])
    }

    /// Whether a point lies inside (by the parity of boundary crossings on a ray).
    #[must_use]
    pub fn contains(&self, point: [f64; 2]) -> bool {
        let crossings = |ring: &Ring| {
            let mut count = 0;
            for (i, a) in ring.iter().enumerate() {
                let b = ring[(i + 1) % ring.len()];
                if (a[1] > point[1]) != (b[1] > point[1]) {
                    let x = a[0] + (point[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
                    count += usize::from(x > point[0]);
                }
            }
            count
        };
        self.rings().map(crossings).sum::<usize>() % 2 == 1
    }

    /// Polygons, each an outer ring (counter-clockwise) followed by its holes (clockwise).
    #[must_use]
    pub fn polygons(&self) -> &[Vec<Ring>] {
        &self.polygons
    }

    /// Area of what two regions in the same plane share.
    #[must_use]
    pub fn common_area(&self, other: &Self) -> f64 {
        let shared =
            self.polygons.overlay_as::<i64>(&other.polygons, OverlayRule::Intersect, FillRule::NonZero);
        Self { polygons: shared }.area()
    }

    fn rings(&self) -> impl Iterator<Item = &Ring> {
        self.polygons.iter().flatten()
    }
}

/// Hulls of the connected groups among the pieces of one strip.
///
/// Overlap is judged after taking out the slope that the pieces have in common, so that steep thin bands side by
/// side stay apart.
fn hulls(pieces: Vec<Vec<Point>>) -> Vec<Vec<Point>> {
    if pieces.len() == 1 {
        return pieces.into_iter().map(hull).collect();
    }
    let (mut n, mut sx, mut sy, mut sxx, mut sxy) = (0.0, 0.0, 0.0, 0.0, 0.0);
    for piece in &pieces {
        // Slope within pieces only: each is taken about its own mean.
        let count = piece.len() as f64;
        let mean = [0, 1].map(|d| piece.iter().map(|p| p[d]).sum::<f64>() / count);
        for p in piece {
            let (x, y) = (p[0] - mean[0], p[1] - mean[1]);
            (n, sx, sy, sxx, sxy) = (n + 1.0, sx + x, sy + y, sxx + x * x, sxy + x * y);
        }
    }
    let variance = sxx - sx * sx / n;
    let slope = if variance > 0.0 { (sxy - sx * sy / n) / variance } else { 0.0 };
    let mut ranged: Vec<(f64, f64, Vec<Point>)> = pieces
        .into_iter()
        .map(|piece| {
            let level = |p: &Point| p[1] - slope * p[0];
            let low = piece.iter().map(level).fold(f64::INFINITY, f64::min);
            let high = piece.iter().map(level).fold(f64::NEG_INFINITY, f64::max);
            (low, high, piece)
        })
        .collect();
    ranged.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut groups: Vec<(f64, Vec<Point>)> = Vec::new();
    for (low, high, piece) in ranged {
        match groups.last_mut() {
            Some((top, points)) if low <= *top => {
                *top = top.max(high);
                points.extend(piece);
            }
            _ => groups.push((high, piece)),
        }
    }
    groups.into_iter().map(|(_, points)| hull(points)).collect()
}

fn grown(piece: &[Point], y_scale: f64) -> Ring {
    let n = piece.len() as f64;
    let scaled = |p: &Point| [p[0], p[1] / y_scale];
    let centre = [0, 1].map(|d| piece.iter().map(|p| scaled(p)[d]).sum::<f64>() / n);
    let grow = |p: &Point| {
        let [x, y] = scaled(p);
        let (x, y) = (x - centre[0], y - centre[1]);
        let factor = 1.0 + GROWTH / x.hypot(y).max(GROWTH);
        [centre[0] + factor * x, centre[1] + factor * y]
    };
    piece.iter().map(grow).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn square(x: f64, y: f64, size: f64) -> Vec<Point> {
        vec![[x, y], [x + size, y], [x + size, y + 100.0 * size], [x, y + 100.0 * size]]
    }

    #[test]
    fn a_ring_of_squares_has_a_hole_and_an_outlier_is_a_second_polygon() {
        let ring = [(0., 0.), (1., 0.), (2., 0.), (0., 100.), (2., 100.), (0., 200.), (1., 200.), (2., 200.)];
        let squares = ring.iter().map(|&(x, y)| square(x, y, 1.0)).chain([square(10.0, 0.0, 1.0)]);
        let pieces = squares.map(|s| ((s[0][0] as i32, 1), s));
        let region = Region::of_angle_and_density(pieces);
        assert_eq!(region.polygons().len(), 2);
        assert_eq!(region.polygons().iter().map(Vec::len).max(), Some(2));
        assert!((region.area() - 900.0).abs() < 1e-2);
        assert!(!region.contains([1.5, 150.0]) && region.contains([0.5, 150.0]));
        let (x, y) = region.bounds().unwrap();
        assert!((x[1] - 11.0).abs() < 1e-5 && (y[1] - 300.0).abs() < 1e-3);
    }

    #[test]
    fn nothing_is_nothing() {
        let region = Region::of_angles([]);
        assert!(region.is_empty() && region.bounds().is_none() && region.area() == 0.0);
    }

    proptest! {
        /// The union is the union: compared with sample points.
        #[test]
        fn the_union_is_the_union(corners in proptest::collection::vec((0.0..10.0, 0.0..1000.0, 0.1..2.0), 1..90)) {
            let pieces: Vec<_> = corners.iter().map(|&(x, y, size)| square(x, y, size)).collect();
            // Each in a strip of its own: nothing is replaced by a hull.
            let region = Region::of_angle_and_density((0..).map(|i| (i, 1)).zip(pieces.clone()));
            for i in 0..30 {
                for j in 0..30 {
                    let p = [0.0137 + f64::from(i) * 0.4, 1.37 + f64::from(j) * 40.0];
                    // Pieces are grown a little; points on the rim prove nothing.
                    let on_rim = |s: &Vec<Point>| {
                        let near = |d: usize, edge: f64, by: f64| (p[d] - edge).abs() < by;
                        near(0, s[0][0], 1e-5) || near(0, s[2][0], 1e-5) || near(1, s[0][1], 1e-3) || near(1, s[2][1], 1e-3)
                    };
                    if pieces.iter().any(on_rim) { continue }
                    let inside = pieces.iter().any(|s| s[0][0] < p[0] && p[0] < s[2][0] && s[0][1] < p[1] && p[1] < s[2][1]);
                    prop_assert_eq!(region.contains(p), inside);
                }
            }
        }
    }
}
