//! Weighted least squares with a few unknowns.

use nalgebra::{SMatrix, SVector};

use crate::sd_of_median_abs;

/// Least pivot of the normal matrix, scaled to a unit diagonal, from which rows determine the unknowns: a condition number of
/// some 1e12 leaves four digits of a double.
const LEAST_PIVOT: f64 = 1e-12;
/// Robust standard deviations from which on residuals count linearly: 96 % as exact as least squares for normal errors.
const HUBER: f64 = 1.5;
/// Rounds of reweighting; the weights settle within a few.
const ROUNDS: usize = 8;

/// Solution of a least-squares problem with `N` unknowns.
#[derive(Debug, Clone, Copy)]
pub struct Solved<const N: usize> {
    /// The unknowns.
    pub x: [f64; N],
    /// Inverse of the normal matrix: covariance for residuals of unit variance.
    pub inverse: [[f64; N]; N],
}

/// Minimises the sum of `weight * (row . x - value)^2` over `(row, value, weight)`; `None` if the rows don't determine `x`.
pub fn least_squares<const N: usize>(rows: impl Iterator<Item = ([f64; N], f64, f64)>) -> Option<Solved<N>> {
    let mut normal = SMatrix::<f64, N, N>::zeros();
    let mut right = SVector::<f64, N>::zeros();
    for (row, value, weight) in rows {
        let row = SVector::from(row);
        normal += row * row.transpose() * weight;
        right += row * (weight * value);
    }
    let scale = normal.diagonal().map(f64::sqrt);
    if scale.iter().any(|s| !(s.is_finite() && *s > 0.0)) {
        return None;
    }
    let over_scale = SMatrix::from_diagonal(&scale.map(f64::recip));
    let cholesky = (over_scale * normal * over_scale).cholesky()?;
    if cholesky.l_dirty().diagonal().iter().any(|pivot| pivot * pivot <= LEAST_PIVOT) {
        return None;
    }
    let x = over_scale * cholesky.solve(&(over_scale * right));
    let inverse = over_scale * cholesky.inverse() * over_scale;
    Some(Solved { x: x.into(), inverse: inverse.into() })
}

/// The same with unit weights, where residuals beyond 1.5 robust standard deviations count linearly (Huber 1964), by
/// reweighting; also the root mean square of the residuals, each at most that size.
#[must_use]
pub fn huber<const N: usize>(rows: &[([f64; N], f64)]) -> Option<(Solved<N>, f64)> {
    let mut weights = vec![1.0; rows.len()];
    let mut found = None;
    for _ in 0..ROUNDS {
        let solved = least_squares(rows.iter().zip(&weights).map(|((row, value), w)| (*row, *value, *w)))?;
        let residual =
            |row: &[f64; N], value: f64| value - row.iter().zip(&solved.x).map(|(a, b)| a * b).sum::<f64>();
        let residuals: Vec<f64> = rows.iter().map(|(row, value)| residual(row, *value)).collect();
        let bound = HUBER * sd_of_median_abs(residuals.iter().copied());
        let n = rows.len().max(1) as f64;
        let square =
            residuals.iter().map(|r| r.abs().min(bound.max(f64::MIN_POSITIVE)).powi(2)).sum::<f64>() / n;
        for (weight, r) in weights.iter_mut().zip(&residuals) {
            *weight = if r.abs() > bound && bound > 0.0 { bound / r.abs() } else { 1.0 };
        }
        found = Some((solved, square.sqrt()));
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_parabola_is_recovered_and_one_wild_value_hardly_matters() {
        let mut rows: Vec<([f64; 3], f64)> = (0..40)
            .map(|i| {
                let x = f64::from(i) / 10.0;
                ([1.0, x, x * x], 2.0 - 3.0 * x + 0.5 * x * x + 1e-3 * f64::from((i * 7) % 5 - 2))
            })
            .collect();
        rows[20].1 += 50.0;
        let (solved, _) = huber(&rows).unwrap();
        for (found, expected) in solved.x.iter().zip([2.0, -3.0, 0.5]) {
            assert!((found - expected).abs() < 5e-3, "{found} {expected}");
        }
    }

    /// Of a mean of n values of unit variance the variance is 1 / n; of a line about its middle, by the sums of the textbook.
    #[test]
    fn the_inverse_is_the_covariance() {
        let line = least_squares((-2..=2).map(|x| ([1.0, f64::from(x)], 0.0, 4.0))).unwrap();
        assert!((line.inverse[0][0] - 1.0 / 20.0).abs() < 1e-15);
        assert!((line.inverse[1][1] - 1.0 / 40.0).abs() < 1e-15);
        assert!(line.inverse[0][1].abs() < 1e-15);
    }

    #[test]
    fn equal_rows_do_not_determine_a_line() {
        assert!(least_squares([([1.0, 2.0], 3.0, 1.0), ([1.0, 2.0], 3.1, 1.0)].into_iter()).is_none());
    }
}
