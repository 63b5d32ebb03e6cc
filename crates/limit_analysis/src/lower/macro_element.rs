//! The Clough-Tocher element: a triangle cut in three at its centroid, on which a stress function is piecewise cubic
//! and has continuous slopes. Its second derivatives are stresses in equilibrium, linear in each of the three parts,
//! with tractions that balance across every edge.
//!
//! Clough & Tocher (1965); the Bernstein form follows Lai & Schumaker, Spline Functions on Triangulations (2007), 6.

use crate::vector::{between, centroid, dot, midpoint, turned};

/// Number of local values: stress function and its two slopes at each corner, and the slope across each edge at its
/// middle.
pub(crate) const LOCAL: usize = 12;

/// A linear function of the local values.
pub(crate) type Row = [f64; LOCAL];

/// Second derivatives `[xx, yy, xy]` of the stress function as linear functions of the local values.
pub(crate) type Curvature = [Row; 3];

/// Curvatures at the nodes of the three parts: part `k` lies opposite to corner `k`, its nodes are corner `k + 1`,
/// corner `k + 2` and the centroid.
pub(crate) type Curvatures = [[Curvature; 3]; 3];

fn unit(index: usize) -> Row {
    let mut row = [0.0; LOCAL];
    row[index] = 1.0;
    row
}

fn sum(terms: &[(f64, &Row)]) -> Row {
    let mut row = [0.0; LOCAL];
    for (factor, other) in terms {
        for (r, o) in row.iter_mut().zip(*other) {
            *r += factor * o;
        }
    }
    row
}

/// Slope along `direction` at corner `k`.
fn slope(k: usize, direction: [f64; 2]) -> Row {
    let mut row = [0.0; LOCAL];
    row[3 * k + 1] = direction[0];
    row[3 * k + 2] = direction[1];
    row
}

/// Curvatures at all nodes of the element with corners `v`.
///
/// Local values are `[f, fx, fy]` at each corner, then for each edge `k` (opposite to corner `k`) the derivative at its
/// middle along the edge vector from corner `k + 1` to corner `k + 2`, turned to the left. Corners marked in `apex`
/// have no stress: the function vanishes to second order there, whatever the other values.
pub(crate) fn curvatures(v: &[[f64; 2]; 3], apex: [bool; 3]) -> Curvatures {
    let g = centroid(v);
    let next = |k: usize| (k + 1) % 3;
    let last = |k: usize| (k + 2) % 3;
    // Bernstein coefficients. Names: a corner's own; along an edge near a corner; towards the centroid.
    let own: [Row; 3] = std::array::from_fn(|k| if apex[k] { [0.0; LOCAL] } else { unit(3 * k) });
    let near = |k: usize, to: [f64; 2], other: Option<usize>| -> Row {
        if apex[k] || other.is_some_and(|o| apex[o]) {
            return [0.0; LOCAL];
        }
        sum(&[(1.0, &own[k]), (1.0 / 3.0, &slope(k, between(v[k], to)))])
    };
    // The coefficient next to corner k on the edge to corner o vanishes if either end is an apex.
    let along = |k: usize, o: usize| near(k, v[o], Some(o));
    let inward: [Row; 3] = std::array::from_fn(|k| near(k, g, None));
    let middle: [Row; 3] = std::array::from_fn(|k| {
        let (a, b) = (next(k), last(k));
        if apex[a] || apex[b] {
            return [0.0; LOCAL];
        }
        let t = between(v[a], v[b]);
        let n = turned(t);
        let m = midpoint(v[a], v[b]);
        let to = between(m, g);
        let (alpha, beta) = (dot(to, t) / dot(t, t), dot(to, n) / dot(t, t));
        let (ab, ba) = (along(a, b), along(b, a));
        let tangent = sum(&[(0.75, &own[b]), (0.75, &ba), (-0.75, &ab), (-0.75, &own[a])]);
        let across = unit(9 + k);
        sum(&[
            (2.0 / 3.0 * alpha, &tangent),
            (2.0 / 3.0 * beta, &across),
            (0.25, &own[a]),
            (0.25, &own[b]),
            (0.75, &ab),
            (0.75, &ba),
            (-0.5, &inward[a]),
            (-0.5, &inward[b]),
        ])
    });
    let third = 1.0 / 3.0;
    let deep: [Row; 3] = std::array::from_fn(|k| {
        if apex[k] {
            return [0.0; LOCAL];
        }
        sum(&[(third, &inward[k]), (third, &middle[next(k)]), (third, &middle[last(k)])])
    });
    let centre = sum(&[(third, &deep[0]), (third, &deep[1]), (third, &deep[2])]);
    std::array::from_fn(|k| {
        let (a, b) = (next(k), last(k));
        let (ab, ba) = (along(a, b), along(b, a));
        let (p, q, r) = (v[a], v[b], g);
        [
            hessian(p, q, r, [&own[a], &ab, &ba, &inward[a], &middle[k], &deep[a]]),
            hessian(q, r, p, [&own[b], &inward[b], &deep[b], &ba, &middle[k], &ab]),
            hessian(r, p, q, [&centre, &deep[a], &inward[a], &deep[b], &middle[k], &inward[b]]),
        ]
    })
}

/// Second derivatives at `p` of the cubic on triangle `p q r`, from the coefficients `[ppp, ppq, pqq, ppr, pqr, prr]`.
fn hessian(p: [f64; 2], q: [f64; 2], r: [f64; 2], b: [&Row; 6]) -> Curvature {
    let [ppp, ppq, pqq, ppr, pqr, prr] = b;
    let (d1, d2) = (between(p, q), between(p, r));
    let det = d1[0] * d2[1] - d1[1] * d2[0];
    let u = [d2[1] / det, -d2[0] / det];
    let w = [-d1[1] / det, d1[0] / det];
    let h11 = sum(&[(6.0, ppp), (-12.0, ppq), (6.0, pqq)]);
    let h12 = sum(&[(6.0, ppp), (-6.0, ppq), (-6.0, ppr), (6.0, pqr)]);
    let h22 = sum(&[(6.0, ppp), (-12.0, ppr), (6.0, prr)]);
    let part = |i: usize, j: usize| {
        sum(&[(u[i] * u[j], &h11), (u[i] * w[j] + w[i] * u[j], &h12), (w[i] * w[j], &h22)])
    };
    [part(0, 0), part(1, 1), part(0, 1)]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Value, slopes and curvatures of `sum c_ij x^i y^j`, degree three.
    fn cubic(c: &[f64; 10], p: [f64; 2]) -> (f64, [f64; 2], [f64; 3]) {
        let [x, y] = p;
        let powers = [(0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2), (3, 0), (2, 1), (1, 2), (0, 3)];
        let pow = |v: f64, n: i32| if n < 0 { 0.0 } else { v.powi(n) };
        let (mut f, mut g, mut h) = (0.0, [0.0; 2], [0.0; 3]);
        for (c, (i, j)) in c.iter().zip(powers) {
            let (fi, fj) = (f64::from(i), f64::from(j));
            f += c * pow(x, i) * pow(y, j);
            g[0] += c * fi * pow(x, i - 1) * pow(y, j);
            g[1] += c * fj * pow(x, i) * pow(y, j - 1);
            h[0] += c * fi * (fi - 1.0) * pow(x, i - 2) * pow(y, j);
            h[1] += c * fj * (fj - 1.0) * pow(x, i) * pow(y, j - 2);
            h[2] += c * fi * fj * pow(x, i - 1) * pow(y, j - 1);
        }
        (f, g, h)
    }

    fn reproduces(c: &[f64; 10], v: [[f64; 2]; 3], apex: [bool; 3]) {
        let mut local = [0.0; LOCAL];
        for k in 0..3 {
            let (f, g, _) = cubic(c, v[k]);
            local[3 * k..3 * k + 3].copy_from_slice(&[f, g[0], g[1]]);
            let (a, b) = (v[(k + 1) % 3], v[(k + 2) % 3]);
            let (_, g, _) = cubic(c, midpoint(a, b));
            let n = turned(between(a, b));
            local[9 + k] = dot(g, n);
        }
        let curvature = curvatures(&v, apex);
        for (k, part) in curvature.iter().enumerate() {
            for (node, rows) in part.iter().enumerate() {
                let p = if node < 2 { v[(k + 1 + node) % 3] } else { centroid(&v) };
                let (_, _, h) = cubic(c, p);
                for (row, expected) in rows.iter().zip(h) {
                    let got: f64 = row.iter().zip(&local).map(|(r, l)| r * l).sum();
                    assert!((got - expected).abs() < 1e-10, "part {k} node {node}: {got} {expected}");
                }
            }
        }
    }

    #[test]
    fn cubics_are_reproduced() {
        let v = [[0.3, -0.2], [1.7, 0.1], [0.6, 1.1]];
        reproduces(&[0.7, -1.0, 0.4, 2.0, -0.6, 1.1, 0.9, -1.4, 0.3, 0.8], v, [false; 3]);
    }

    #[test]
    fn cubics_that_vanish_to_second_order_at_an_apex_are_reproduced() {
        let v = [[0.0, 0.0], [1.7, 0.1], [0.6, 1.1]];
        reproduces(&[0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.9, -1.4, 0.3, 0.8], v, [true, false, false]);
    }
}
