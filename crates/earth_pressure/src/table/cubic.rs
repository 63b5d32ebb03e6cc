//! Cubic between two nodes, and what a straight line between them may miss.

/// Abscissa and value.
pub(super) type Knot = (f64, f64);

/// Slope of the chord.
fn secant(a: Knot, b: Knot) -> f64 {
    (b.1 - a.1) / (b.0 - a.0)
}

/// Cubic Hermite on the cell a-b at fraction t, with slopes that keep monotone data monotone.
#[inline]
pub(super) fn monotone_cubic(before: Option<Knot>, a: Knot, b: Knot, after: Option<Knot>, t: f64) -> f64 {
    let (h, middle) = (b.0 - a.0, secant(a, b));
    // Inner slope: weighted harmonic mean. At an end of the data: three-point slope, limited.
    let inner = |h0: f64, s0: f64, h1: f64, s1: f64| {
        if s0 * s1 <= 0.0 {
            return 0.0;
        }
        let (w0, w1) = (2.0 * h1 + h0, h1 + 2.0 * h0);
        (w0 + w1) / (w0 / s0 + w1 / s1)
    };
    let end = |h0: f64, s0: f64, next: Option<(f64, f64)>| match next {
        None => s0,
        Some((h1, s1)) => {
            let slope = ((2.0 * h0 + h1) * s0 - h0 * s1) / (h0 + h1);
            if slope * s0 <= 0.0 {
                0.0
            } else if s0 * s1 <= 0.0 && slope.abs() > 3.0 * s0.abs() {
                3.0 * s0
            } else {
                slope
            }
        }
    };
    let left = before.map(|p| (a.0 - p.0, secant(p, a)));
    let right = after.map(|p| (p.0 - b.0, secant(b, p)));
    let slope_a = left.map_or_else(|| end(h, middle, right), |(h0, s0)| inner(h0, s0, h, middle));
    let slope_b = right.map_or_else(|| end(h, middle, left), |(h1, s1)| inner(h, middle, h1, s1));
    let (t2, t3) = (t * t, t * t * t);
    (2.0 * t3 - 3.0 * t2 + 1.0) * a.1
        + (t3 - 2.0 * t2 + t) * h * slope_a
        + (3.0 * t2 - 2.0 * t3) * b.1
        + (t3 - t2) * h * slope_b
}

/// `t (1 - t)` times this bounds what linear interpolation in a cell may miss.
pub(super) fn cell_error(axis: &[f64], cell: usize, at: impl Fn(usize) -> Option<f64>) -> f64 {
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
    let inner = curvature_at(cell).is_some() && curvature_at(cell + 1).is_some();
    0.5 * h * h * largest * if inner { 1.5 } else { 3.0 }
}
