//! What a cover leaves of each quantity, and of each pair of them.

use super::simplex::Over;
use super::unknowns::Quantity;
use crate::convex::{Point, clip};
use crate::piece::Strip;
use crate::region::Region;

/// The shadow of one polytope.
pub(super) struct Piece {
    corner: [i32; 3],
    size: i32,
    ranges: Vec<[f64; 2]>,
    /// Polygons by pairs, in the order of [`pairs`].
    polygons: Vec<Vec<Point>>,
}

/// Places of all pairs among so many.
pub(super) fn pairs(count: usize) -> impl Iterator<Item = [usize; 2]> {
    (0..count).flat_map(move |i| (i + 1..count).map(move |j| [i, j]))
}

impl Piece {
    /// The shadow of a polytope; `None` if it is empty.
    pub(super) fn new(over: &Over<'_>, quantities: &[Quantity], corner: [i32; 3], size: i32) -> Option<Self> {
        let functions: Vec<_> = quantities.iter().map(|quantity| over.quantity(*quantity)).collect();
        let ranges: Vec<[f64; 2]> =
            functions.iter().map(|function| over.range(function)).collect::<Option<_>>()?;
        let mut polygons = Vec::new();
        for [i, j] in pairs(quantities.len()) {
            let (x, y) = (ranges[i], ranges[j]);
            let mut polygon = vec![[x[0], y[0]], [x[1], y[0]], [x[1], y[1]], [x[0], y[1]]];
            let widths = [x[1] - x[0], y[1] - y[0]];
            // Two slanting sides each way, at half a right angle to the sides of the box.
            if widths[0] > 0.0 && widths[1] > 0.0 {
                for sign in [1.0, -1.0] {
                    let scale = [1.0 / widths[0], sign / widths[1]];
                    let (a, b) = (&functions[i], &functions[j]);
                    let start = scale[0] * a.0 + scale[1] * b.0;
                    let mut steps = a.1;
                    for (step, (a, b)) in steps.iter_mut().zip(a.1.iter().zip(&b.1)) {
                        *step = scale[0] * a + scale[1] * b;
                    }
                    let [low, high] = over.range(&(start, steps))?;
                    let at = |p: Point| scale[0] * p[0] + scale[1] * p[1];
                    // What clipping rounds.
                    let slack = 1e-12 * (low.abs() + high.abs());
                    polygon = clip(&polygon, |p| at(p) - low + slack);
                    polygon = clip(&polygon, |p| high + slack - at(p));
                }
            }
            polygons.push(polygon);
        }
        Some(Self { corner, size, ranges, polygons })
    }
}

/// What pieces leave together.
pub(super) struct Shadows {
    quantities: Vec<Quantity>,
    pieces: Vec<Piece>,
}

impl Shadows {
    pub(super) const fn new(quantities: Vec<Quantity>) -> Self {
        Self { quantities, pieces: Vec::new() }
    }

    pub(super) fn extend(&mut self, piece: Option<Piece>) {
        self.pieces.extend(piece);
    }

    /// Least and greatest value of each quantity, in their order; `None` if no soil is consistent.
    pub(super) fn ranges(&self) -> Option<Vec<(Quantity, [f64; 2])>> {
        let hull = |place: usize| {
            let ranges = self.pieces.iter().map(|piece| piece.ranges[place]);
            ranges.reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])])
        };
        let quantities = self.quantities.iter().enumerate();
        quantities.map(|(place, &quantity)| Some((quantity, hull(place)?))).collect()
    }

    /// The region of each pair. Where one of the two is an angle it is a union of convex hulls, one for each step of the angle; of two linear quantities it is the
    /// convex hull.
    pub(super) fn regions(&self) -> Vec<(Quantity, Quantity, Region)> {
        let all = pairs(self.quantities.len()).enumerate();
        all.map(|(place, [i, j])| {
            let (x, y) = (self.quantities[i], self.quantities[j]);
            let axis = Quantity::ANGLES.iter().position(|angle| *angle == x);
            let strip = |piece: &Piece| axis.map_or((0, 1), |axis| (piece.corner[axis], piece.size));
            let shadows = self.pieces.iter().map(|piece| (strip(piece), piece.polygons[place].clone()));
            (x, y, region(shadows.collect()))
        })
        .collect()
    }
}

/// The union of polygons of a pair, each axis in units of what all of them span.
fn region(mut pieces: Vec<(Strip, Vec<Point>)>) -> Region {
    let mut spans = [1.0; 2];
    for (axis, span) in spans.iter_mut().enumerate() {
        let values = || pieces.iter().flat_map(|(_, polygon)| polygon).map(|p| p[axis]);
        let (low, high) =
            (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max));
        let size = low.abs().max(high.abs());
        if high - low > 1e-9 * size {
            *span = high - low;
        } else if size > 0.0 {
            *span = size;
        }
    }
    for point in pieces.iter_mut().flat_map(|(_, polygon)| polygon) {
        *point = [point[0] / spans[0], point[1] / spans[1]];
    }
    Region::of_scaled(pieces, spans)
}
