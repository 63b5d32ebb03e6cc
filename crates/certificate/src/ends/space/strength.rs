//! Whether the soil bears a stress.
//!
//! Soil without cohesion bears a stress with the principal pressures `p1 >= p2 >= p3` if and only if `p1 <= K p3`, `K
//! = (1 + sin(phi))/(1 - sin(phi))`: if there is a `t` such that `P - t` and `K t - P` have no negative eigenvalue. A
//! good `t` is guessed in floating point; both matrices are then proven to be positive definite, by the pivots of
//! Gauss's elimination in intervals.

use super::simplex::Matrix;
use crate::interval::{Angle, Interval, angle};

/// Strengths of soil and plate.
#[derive(Debug, Clone, Copy)]
pub(super) struct Strengths {
    /// `(1 + sin(phi))/(1 - sin(phi))`.
    pub(super) ratio: Interval,
    /// `tan(delta)`.
    pub(super) slip: Interval,
}

impl Strengths {
    pub(super) fn new(phi: Angle, delta_deg: f64) -> Self {
        let ratio = (Interval::ONE + phi.sin) / (Interval::ONE - phi.sin);
        Self { ratio, slip: angle(delta_deg).tan() }
    }

    /// What the soil has to spare, proven: not negative if it bears the stress.
    pub(super) fn spare(&self, stress: &Matrix<3>) -> f64 {
        if stress.iter().flatten().all(|x| x.is_zero()) {
            return 0.0;
        }
        let middle = stress.map(|row| row.map(Interval::middle));
        if middle.iter().flatten().any(|x| !x.is_finite()) {
            return f64::NEG_INFINITY;
        }
        let [least, greatest] = extremes(middle);
        let t = Interval::point(0.5 * least + 0.5 * greatest / self.ratio.middle());
        let mut below = *stress;
        let mut above = stress.map(|row| row.map(|x| -x));
        for k in 0..3 {
            below[k][k] = below[k][k] - t;
            above[k][k] = above[k][k] + self.ratio * t;
        }
        least_pivot(below).min(least_pivot(above))
    }

    /// What pressures to one side of the ground at rest must not go below: `least` and `greatest` times the pressure
    /// of its weight.
    pub(super) fn far(&self, pressure: Interval, depth: f64) -> f64 {
        let weight = Interval::point(depth);
        (self.ratio * pressure - weight).lo().min((self.ratio * weight - pressure).lo())
    }

    /// What the plate's face has to spare of the shear stresses at a pressure: not negative if it bears them.
    pub(super) fn face(&self, pressure: Interval, shears: &[Interval]) -> f64 {
        let squares = shears.iter().fold(Interval::ZERO, |sum, shear| sum + shear.square());
        (self.slip * pressure - squares.sqrt()).lo().min(pressure.lo())
    }
}

/// The least pivot of a symmetric matrix, proven; it is positive definite if that is positive, and minus infinity or
/// not positive is returned if that is not proven.
fn least_pivot(mut matrix: Matrix<3>) -> f64 {
    let mut least = f64::INFINITY;
    let mut left = vec![0, 1, 2];
    while let Some(at) = (0..left.len())
        .max_by(|&a, &b| matrix[left[a]][left[a]].lo().total_cmp(&matrix[left[b]][left[b]].lo()))
    {
        let k = left.swap_remove(at);
        let pivot = matrix[k][k];
        if !pivot.is_positive() {
            // Zero would do, but is not proven to be enough.
            return pivot.lo().min(-f64::MIN_POSITIVE);
        }
        least = least.min(pivot.lo());
        for &i in &left {
            let factor = matrix[i][k] / pivot;
            for &j in &left {
                let less = if i == j { matrix[i][k].square() / pivot } else { factor * matrix[j][k] };
                matrix[i][j] = matrix[i][j] - less;
            }
        }
    }
    least
}

/// Least and greatest eigenvalue of a symmetric matrix, about, by Jacobi's rotations.
pub(super) fn extremes(mut a: [[f64; 3]; 3]) -> [f64; 2] {
    for _ in 0..12 {
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            if a[p][q] == 0.0 {
                continue;
            }
            let theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
            let tan = theta.signum() / (theta.abs() + theta.hypot(1.0));
            let cos = 1.0 / tan.hypot(1.0);
            let sin = tan * cos;
            for row in &mut a {
                let (x, y) = (row[p], row[q]);
                (row[p], row[q]) = (cos * x - sin * y, sin * x + cos * y);
            }
            let (x, y) = (a[p], a[q]);
            a[p] = std::array::from_fn(|k| cos * x[k] - sin * y[k]);
            a[q] = std::array::from_fn(|k| sin * x[k] + cos * y[k]);
        }
    }
    let diagonal = [a[0][0], a[1][1], a[2][2]];
    [diagonal.into_iter().fold(f64::MAX, f64::min), diagonal.into_iter().fold(f64::MIN, f64::max)]
}
