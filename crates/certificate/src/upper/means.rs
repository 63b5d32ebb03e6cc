//! Mean values of products of polynomials.

use crate::interval::Interval;

fn sum(of: impl IntoIterator<Item = Interval>) -> Interval {
    of.into_iter().fold(Interval::ZERO, |sum, x| sum + x)
}

/// Mean over a triangle of the product of two linear functions, from their values at the corners.
pub(super) fn over_triangle(a: [Interval; 3], b: [Interval; 3]) -> Interval {
    (sum(a) * sum(b) + sum([0, 1, 2].map(|i| a[i] * b[i]))) / Interval::point(12.0)
}

/// Mean over an edge of the product of a linear function, given by its values at the ends, and a quadratic one, given by
/// its Bernstein coefficients.
pub(super) fn over_edge([start, end]: [Interval; 2], [a, b, c]: [Interval; 3]) -> Interval {
    let (two, three) = (Interval::point(2.0), Interval::point(3.0));
    let weighed = start * (a * three + b * two + c) + end * (a + b * two + c * three);
    weighed / Interval::point(12.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn means_are_those_of_sums() {
        // Against midpoint sums in double arithmetic.
        let n = 200;
        let at = |i: usize| (i as f64 + 0.5) / n as f64;
        let (p, q) = ([0.3, -1.2], [0.7, 2.0, -0.4]);
        let edge: f64 = (0..n)
            .map(|i| {
                let (s, r) = (at(i), 1.0 - at(i));
                (p[0] * r + p[1] * s) * (q[0] * r * r + 2.0 * q[1] * r * s + q[2] * s * s) / n as f64
            })
            .sum();
        let found = over_edge(p.map(Interval::point), q.map(Interval::point));
        assert!((found.lo() - edge).abs() < 1e-4 && (found.hi() - edge).abs() < 1e-4, "{edge} {found:?}");
        let (a, b) = ([0.3, -1.2, 2.0], [0.7, 2.0, -0.4]);
        let mut triangle = 0.0;
        for i in 0..n {
            for j in 0..n {
                // The square folded over its diagonal.
                let (s, t) = (at(i), at(j));
                let (s, t) = if s + t > 1.0 { (1.0 - s, 1.0 - t) } else { (s, t) };
                let of = |c: [f64; 3]| c[0] * (1.0 - s - t) + c[1] * s + c[2] * t;
                triangle += of(a) * of(b) / (n * n) as f64;
            }
        }
        let found = over_triangle(a.map(Interval::point), b.map(Interval::point));
        assert!((found.lo() - triangle).abs() < 1e-3 && (found.hi() - triangle).abs() < 1e-3);
    }
}
