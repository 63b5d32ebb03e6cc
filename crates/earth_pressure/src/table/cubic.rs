//! Cubic between two nodes, and what a straight line between them may miss.

use std::ops::Range;

/// Abscissa and value.
pub(super) type Knot = (f64, f64);

/// Slope of the chord.
fn secant(a: Knot, b: Knot) -> f64 {
    (b.1 - a.1) / (b.0 - a.0)
}

/// Step and secant slope towards a neighbour.
type Side = (f64, f64);

/// Slope at a node that keeps monotone data monotone: a weighted harmonic mean of the secants on both sides, or, at
/// an end of the data, a limited three-point slope from the one side and the one beyond it.
fn slope(left: Option<Side>, right: Option<Side>, beyond: Option<Side>) -> f64 {
    match (left, right) {
        (Some((h0, s0)), Some((h1, s1))) => {
            if s0 * s1 <= 0.0 {
                return 0.0;
            }
            let (w0, w1) = (2.0 * h1 + h0, h1 + 2.0 * h0);
            (w0 + w1) / (w0 / s0 + w1 / s1)
        }
        (Some((h0, s0)), None) | (None, Some((h0, s0))) => {
            let Some((h1, s1)) = beyond else { return s0 };
            let slope = ((2.0 * h0 + h1) * s0 - h0 * s1) / (h0 + h1);
            if slope * s0 <= 0.0 {
                0.0
            } else if s0 * s1 <= 0.0 && slope.abs() > 3.0 * s0.abs() {
                3.0 * s0
            } else {
                slope
            }
        }
        (None, None) => 0.0,
    }
}

/// Slope at node `i` of values on an axis, some of which may be missing; NaN if its own is.
pub(super) fn node_slope(axis: &[f64], i: usize, at: impl Fn(usize) -> Option<f64>) -> f64 {
    let knot = |i: usize| Some((*axis.get(i)?, at(i)?));
    let side = |a: usize, b: usize| {
        let (a, b) = (knot(a)?, knot(b)?);
        Some((b.0 - a.0, secant(a, b)))
    };
    if knot(i).is_none() {
        return f64::NAN;
    }
    let left = i.checked_sub(1).and_then(|before| side(before, i));
    let right = side(i, i + 1);
    let beyond = match (left, right) {
        (None, _) => side(i + 1, i + 2),
        (_, None) => i.checked_sub(2).and_then(|before| side(before, i - 1)),
        _ => None,
    };
    slope(left, right, beyond)
}

/// Cubic Hermite on a cell of width h at fraction t, from values and slopes at its ends.
#[inline]
pub(super) fn hermite(h: f64, (y0, m0): (f64, f64), (y1, m1): (f64, f64), t: f64) -> f64 {
    let (t2, t3) = (t * t, t * t * t);
    (2.0 * t3 - 3.0 * t2 + 1.0) * y0
        + (t3 - 2.0 * t2 + t) * h * m0
        + (3.0 * t2 - 2.0 * t3) * y1
        + (t3 - t2) * h * m1
}

/// Slopes by [`slope`] at both ends of the cell a-b, from the nodes around it.
#[inline]
pub(super) fn cell_slopes(before: Option<Knot>, a: Knot, b: Knot, after: Option<Knot>) -> (f64, f64) {
    let middle = Some((b.0 - a.0, secant(a, b)));
    let left = before.map(|p| (a.0 - p.0, secant(p, a)));
    let right = after.map(|p| (p.0 - b.0, secant(b, p)));
    (slope(left, middle, right), slope(middle, right, left))
}

/// `t (1 - t)` times this bounds what linear interpolation in a cell may miss. A cell is inner if its own nodes and the next
/// one on either side are among `seen`, those whose values were not made up; then 1.5 times the largest curvature around is
/// allowed for, otherwise 3 times.
///
/// At `delta = phi` the function ends and the node beyond is made up. In slip-line fields the square roots of `phi - delta` in
/// `ln K` cancel and `x^(3/2)`, with `x = phi - delta`, is the first term that is not smooth. Its chord over `0..h` misses
/// `h^(3/2) t (1 - sqrt(t))`, at most `h^(3/2) t (1 - t)`; its second difference over `0, h, 2 h` is `0.83 h^(3/2)`, half of
/// which, 3 times, is more than that, and 1.5 times is not.
pub(super) fn cell_error(
    axis: &[f64],
    cell: usize,
    seen: &Range<usize>,
    at: impl Fn(usize) -> Option<f64>,
) -> f64 {
    if cell + 1 >= axis.len() {
        return 0.0;
    }
    let h = axis[cell + 1] - axis[cell];
    let curvature_at = |i: usize| {
        let knot = |i: usize| Some((*axis.get(i)?, at(i)?));
        let (p, q, r) = (knot(i.checked_sub(1)?)?, knot(i)?, knot(i + 1)?);
        Some((2.0 * (secant(q, r) - secant(p, q)) / (r.0 - p.0)).abs())
    };
    let around = cell.saturating_sub(1)..=cell + 2;
    let largest = around.filter_map(curvature_at).fold(f64::NAN, f64::max);
    if largest.is_nan() {
        // Nothing is known about the curvature; allow twice the step of the cell.
        return at(cell).zip(at(cell + 1)).map_or(0.0, |(a, b)| 2.0 * (b - a).abs());
    }
    let inner =
        seen.start < cell && cell + 2 < seen.end && curvature_at(cell).and(curvature_at(cell + 1)).is_some();
    0.5 * h * h * largest * if inner { 1.5 } else { 3.0 }
}
