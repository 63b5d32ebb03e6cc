//! The Clough-Tocher element: a triangle cut in three at its centroid, with a cubic polynomial in each part.
//!
//! Corner values and slopes, and the slopes across the middles of edges, determine the Bernstein coefficients of the
//! parts such that the slopes are continuous inside, and on each edge the function and its slopes depend only on what
//! belongs to the edge (Clough & Tocher 1965; Lai & Schumaker, Spline Functions on Triangulations, 2007, section 6.3).
//!
//! At an apex the function vanishes to second order: all coefficients up to two steps from it are zero. If `f + grad f .
//! (apex - corner)/3` is zero at the other corners, this is the same element with slopes across the edges at the apex
//! such that the coefficients in the middle of these edges vanish.

use crate::interval::{Interval, Vector};
use crate::problem::Stress;
use crate::tiling::after;

/// What determines the function on one triangle.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Local {
    /// Positions of the corners.
    pub(crate) corners: [Vector; 3],
    /// Corners at which the function vanishes to second order. `f` and `slopes` are zero there.
    pub(crate) apex: [bool; 3],
    /// Values at the corners.
    pub(crate) f: [Interval; 3],
    /// Slopes at the corners.
    pub(crate) slopes: [Vector; 3],
    /// Slopes across the middle of each edge, along the edge vector turned left. Not used next to an apex.
    pub(crate) across: [Interval; 3],
}

/// Stresses at the nodes of the three parts of a triangle: part `k` lies at edge `k`, its nodes are corner `k + 1`,
/// corner `k + 2` and the centroid.
pub(crate) type NodeStresses = [[Stress; 3]; 3];

/// Bernstein coefficients of the element. Each is named by what it is next to.
struct Coefficients {
    /// `[k][i]`: one step from corner `k` towards corner `k + 1 + i`.
    near: [[Interval; 2]; 3],
    /// One step from corner `k` towards the centroid.
    inward: [Interval; 3],
    /// In the middle of the part at edge `k`.
    middle: [Interval; 3],
    /// Two steps from corner `k` towards the centroid.
    deep: [Interval; 3],
    /// At the centroid.
    centre: Interval,
}

impl Local {
    fn coefficients(&self) -> Coefficients {
        let Self { corners, apex, f, slopes, across } = self;
        let to = |k: usize, i: usize| corners[after(k, i)] - corners[k];
        let near = [0, 1, 2].map(|k| {
            [1, 2].map(|i| {
                let vanishes = apex[k] || apex[after(k, i)];
                if vanishes { Interval::ZERO } else { f[k] + slopes[k].dot(to(k, i)).third() }
            })
        });
        let inward = [0, 1, 2].map(|k| {
            let to_centroid_by_3 = to(k, 1) + to(k, 2);
            f[k] + slopes[k].dot(to_centroid_by_3) / Interval::point(9.0)
        });
        let middle = [0, 1, 2].map(|k| {
            let (a, b) = (after(k, 1), after(k, 2));
            if apex[a] || apex[b] {
                return Interval::ZERO;
            }
            let edge = corners[b] - corners[a];
            // From the middle of the edge to the centroid, times 6, in parts along and across the edge.
            let inside = -(to(k, 1) + to(k, 2));
            let by_6 = Interval::point(6.0) * edge.square();
            let (along, over) = (inside.dot(edge) / by_6, edge.cross(inside) / by_6);
            // From a to b, the coefficients along the edge.
            let [fa, ab, ba, fb] = [f[a], near[a][0], near[b][1], f[b]];
            let tangent = ((fb - fa) + (ba - ab)) * Interval::point(0.75);
            let slope = along * tangent + over * across[k];
            let ends = ((fa + fb) + (ab + ba) * Interval::point(3.0)) * Interval::point(0.25);
            slope * Interval::point(2.0).third() + ends - (inward[a] + inward[b]).half()
        });
        let deep = [0, 1, 2].map(|k| {
            let sum = inward[k] + middle[after(k, 1)] + middle[after(k, 2)];
            if apex[k] { Interval::ZERO } else { sum.third() }
        });
        let centre = (deep[0] + deep[1] + deep[2]).third();
        Coefficients { near, inward, middle, deep, centre }
    }

    /// The stresses that belong to the function: `xx = f_yy`, `yy = f_xx`, `xy = -f_xy`. They are linear in each part.
    pub(crate) fn stresses(&self) -> NodeStresses {
        let c = self.coefficients();
        let [p, q, r] = self.corners;
        // From the centroid to the corners, times 3.
        let arms = [p - q + (p - r), q - r + (q - p), r - p + (r - q)];
        [0, 1, 2].map(|k| {
            let (a, b) = (after(k, 1), after(k, 2));
            let shape = Shape::new(arms[a], arms[b]);
            let [ab, ba] = [c.near[a][0], c.near[b][1]];
            // Second differences, along the two arms and mixed, around a, b and the centroid.
            let at_a = [self.f[a], c.inward[a], c.deep[a], ab, c.middle[k], ba];
            let at_b = [ba, c.middle[k], c.deep[b], self.f[b], c.inward[b], ab];
            let at_g = [c.deep[a], c.deep[b], c.inward[a], c.middle[k], c.inward[b], c.centre];
            [
                if self.apex[a] { Stress::ZERO } else { shape.stress(around_a(at_a)) },
                if self.apex[b] { Stress::ZERO } else { shape.stress(around_b(at_b)) },
                shape.stress(around_centroid(at_g)),
            ]
        })
    }

    /// The slopes of the function in each part, quadratic there, in Bernstein form: at the part's nodes (corner `k + 1`,
    /// corner `k + 2`, centroid), then on its edges opposite to these.
    pub(crate) fn part_slopes(&self) -> [[Vector; 6]; 3] {
        let c = self.coefficients();
        let [p, q, r] = self.corners;
        let centroid = Vector { x: (p.x + q.x + r.x).third(), y: (p.y + q.y + r.y).third() };
        [0, 1, 2].map(|k| {
            let (a, b) = (after(k, 1), after(k, 2));
            let (pa, pb) = (self.corners[a], self.corners[b]);
            let to_slope = Interval::point(3.0) / (pb - pa).cross(centroid - pa);
            let towards = [(centroid - pb).turned(), (pa - centroid).turned(), (pb - pa).turned()];
            let slope = |coefficients: [Interval; 3]| {
                (0..3).fold(Vector::ZERO, |sum, i| sum + towards[i] * (coefficients[i] * to_slope))
            };
            let [ab, ba] = [c.near[a][0], c.near[b][1]];
            [
                slope([self.f[a], ab, c.inward[a]]),
                slope([ba, self.f[b], c.inward[b]]),
                slope([c.deep[a], c.deep[b], c.centre]),
                slope([c.middle[k], c.inward[b], c.deep[b]]),
                slope([c.inward[a], c.middle[k], c.deep[a]]),
                slope([ab, ba, c.middle[k]]),
            ]
        })
    }
}

/// Second differences of Bernstein coefficients along the steps from the centroid to `a` (twice), to `b` (twice), and
/// along both.
type Differences = [Interval; 3];

fn second(a: Interval, b: Interval, c: Interval) -> Interval {
    (a - b) - (b - c)
}

/// From the coefficients `aaa, aaG, aGG, aab, abG, abb`.
fn around_a([aaa, aag, agg, aab, abg, abb]: [Interval; 6]) -> Differences {
    [second(aaa, aag, agg), second(abb, abg, agg), (aab - aag) - (abg - agg)]
}

/// From the coefficients `abb, abG, bGG, bbb, bbG, aab`.
fn around_b([abb, abg, bgg, bbb, bbg, aab]: [Interval; 6]) -> Differences {
    [second(aab, abg, bgg), second(bbb, bbg, bgg), (abb - bbg) - (abg - bgg)]
}

/// From the coefficients `aGG, bGG, aaG, abG, bbG, GGG`.
fn around_centroid([agg, bgg, aag, abg, bbg, ggg]: [Interval; 6]) -> Differences {
    [second(aag, agg, ggg), second(bbg, bgg, ggg), (abg - agg) - (bgg - ggg)]
}

/// How second differences in one part turn into second derivatives.
struct Shape {
    /// Gradients of the barycentric coordinates of `a` and `b`, times the determinant.
    a: Vector,
    b: Vector,
    /// Six, the factor of second derivatives of cubics, over the square of the determinant.
    factor: Interval,
}

impl Shape {
    /// From three times the steps from the centroid to two corners.
    fn new(to_a: Vector, to_b: Vector) -> Self {
        let square = to_a.cross(to_b).square();
        // Steps three times too long: the product of two gradients is nine times too small.
        Self { a: -to_b.turned(), b: to_a.turned(), factor: Interval::point(54.0) / square }
    }

    fn stress(&self, [aa, bb, ab]: Differences) -> Stress {
        let Self { a, b, factor } = *self;
        let two = Interval::point(2.0);
        let xx = a.x.square() * aa + b.x.square() * bb + two * a.x * b.x * ab;
        let yy = a.y.square() * aa + b.y.square() * bb + two * a.y * b.y * ab;
        let xy = a.x * a.y * aa + b.x * b.y * bb + (a.x * b.y + a.y * b.x) * ab;
        Stress { xx: factor * yy, yy: factor * xx, xy: -(factor * xy) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    impl Vector {
        fn halved(self) -> Self {
            self * Interval::point(0.5)
        }
    }

    /// Value, slopes and stresses of `sum c_ij x^i y^j` up to degree three.
    fn cubic(c: &[f64; 10], [x, y]: [f64; 2]) -> (f64, [f64; 2], [f64; 3]) {
        let f = c[0] + c[1] * x + c[2] * y + c[3] * x * x + c[4] * x * y + c[5] * y * y;
        let f = f + c[6] * x * x * x + c[7] * x * x * y + c[8] * x * y * y + c[9] * y * y * y;
        let fx = c[1] + 2.0 * c[3] * x + c[4] * y + 3.0 * c[6] * x * x + 2.0 * c[7] * x * y + c[8] * y * y;
        let fy = c[2] + c[4] * x + 2.0 * c[5] * y + c[7] * x * x + 2.0 * c[8] * x * y + 3.0 * c[9] * y * y;
        let xx = 2.0 * c[3] + 6.0 * c[6] * x + 2.0 * c[7] * y;
        let yy = 2.0 * c[5] + 2.0 * c[8] * x + 6.0 * c[9] * y;
        let xy = c[4] + 2.0 * c[7] * x + 2.0 * c[8] * y;
        (f, [fx, fy], [yy, xx, -xy])
    }

    fn reproduces(c: &[f64; 10], v: [[f64; 2]; 3], apex: [bool; 3]) {
        let values = v.map(|p| cubic(c, p));
        let across = [0, 1, 2].map(|k| {
            let (a, b) = (v[after(k, 1)], v[after(k, 2)]);
            let (_, g, _) = cubic(c, [(a[0] + b[0]) / 2.0, (a[1] + b[1]) / 2.0]);
            Interval::point(g[1] * (b[0] - a[0]) - g[0] * (b[1] - a[1]))
        });
        let local = Local {
            corners: v.map(Vector::point),
            apex,
            f: values.map(|(f, ..)| f.into()),
            slopes: values.map(|(_, g, _)| Vector::point(g)),
            across,
        };
        let centroid = [0, 1].map(|i| (v[0][i] + v[1][i] + v[2][i]) / 3.0);
        for (k, slopes) in local.part_slopes().iter().enumerate() {
            let at = [v[after(k, 1)], v[after(k, 2)], centroid];
            for i in 0..3 {
                // At a node the coefficient, in the middle of an edge the mean of three, one of them twice.
                let (p, q) = (at[after(i, 1)], at[after(i, 2)]);
                let middle = [0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1])];
                let mean = (slopes[after(i, 1)] + slopes[after(i, 2)]).halved() + slopes[3 + i];
                for (got, p) in [(slopes[i], at[i]), (mean.halved(), middle)] {
                    let (_, [gx, gy], _) = cubic(c, p);
                    assert!((got.x.middle() - gx).abs() < 1e-12 && (got.y.middle() - gy).abs() < 1e-12);
                }
            }
        }
        for (k, nodes) in local.stresses().iter().enumerate() {
            let at = [v[after(k, 1)], v[after(k, 2)], centroid];
            for (stress, p) in nodes.iter().zip(at) {
                let (_, _, expected) = cubic(c, p);
                for (got, expected) in [stress.xx, stress.yy, stress.xy].iter().zip(expected) {
                    assert!((got.lo() - expected).abs() < 1e-12 && (got.hi() - expected).abs() < 1e-12);
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
        let c = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.9, -1.4, 0.3, 0.8];
        reproduces(&c, v, [true, false, false]);
        reproduces(&c, [v[2], v[0], v[1]], [false, true, false]);
    }
}
