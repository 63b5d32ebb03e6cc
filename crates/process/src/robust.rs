//! Small weighted least squares and the robust scale they are used with.

use nalgebra::{SMatrix, SVector};

/// Rows with a smaller pivot, in a matrix of unit diagonal, do not determine what is sought.
const LEAST_PIVOT: f64 = 1e-12;

/// Median; 0 of nothing. Sorts its argument.
pub(crate) fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    let n = values.len();
    match (values.get(n / 2), n % 2) {
        (Some(&upper), 0) => f64::midpoint(values.get(n / 2 - 1).copied().unwrap_or(upper), upper),
        (Some(&middle), _) => middle,
        (None, _) => 0.0,
    }
}

/// Standard deviation of normal values that lies behind the median of their absolute values.
pub(crate) fn sd_of_median_abs(values: impl Iterator<Item = f64>) -> f64 {
    let mut sizes: Vec<f64> = values.map(f64::abs).collect();
    median(&mut sizes) / 0.674_489_750_196_081_7
}

/// Noise of evenly spaced values by their second differences, which a smooth course leaves nearly untouched.
pub(crate) fn noise(values: &[f64]) -> f64 {
    let second = values.windows(3).map(|w| w[0] - 2.0 * w[1] + w[2]);
    sd_of_median_abs(second) / 6.0_f64.sqrt()
}

/// Solution of a least-squares problem with `N` unknowns.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Solved<const N: usize> {
    pub(crate) x: [f64; N],
    /// Inverse of the normal matrix: covariance for residuals of unit variance.
    pub(crate) inverse: [[f64; N]; N],
}

/// Minimises the sum of `weight * (row . x - value)^2`; `None` if the rows don't determine `x`.
pub(crate) fn least_squares<const N: usize>(
    rows: impl Iterator<Item = ([f64; N], f64, f64)>,
) -> Option<Solved<N>> {
    let (mut normal, mut right) = (SMatrix::<f64, N, N>::zeros(), SVector::<f64, N>::zeros());
    for (row, value, weight) in rows {
        let row = SVector::from(row);
        normal += weight * row * row.transpose();
        right += weight * value * row;
    }
    let inverse = inverted(normal)?;
    Some(Solved { x: (inverse * right).into(), inverse: inverse.into() })
}

/// Inverse of a positive definite matrix, by its Cholesky factor after it was scaled to a unit diagonal.
fn inverted<const N: usize>(matrix: SMatrix<f64, N, N>) -> Option<SMatrix<f64, N, N>> {
    let scale = matrix.diagonal().map(f64::sqrt);
    if !scale.iter().all(|s| s.is_finite() && *s > 0.0) {
        return None;
    }
    let scales = scale * scale.transpose();
    let factor = matrix.component_div(&scales).cholesky()?;
    let is_definite = factor.l_dirty().diagonal().iter().all(|root| root * root > LEAST_PIVOT);
    is_definite.then(|| factor.inverse().component_div(&scales))
}

/// The same with residuals beyond `1.5` robust standard deviations counting linearly (Huber 1964), by reweighting;
/// also the root mean square of the residuals, each at most that size.
pub(crate) fn huber<const N: usize>(rows: &[([f64; N], f64)]) -> Option<(Solved<N>, f64)> {
    let mut weights = vec![1.0; rows.len()];
    let mut found = None;
    for _ in 0..8 {
        let solved = least_squares(rows.iter().zip(&weights).map(|((row, value), w)| (*row, *value, *w)))?;
        let residual =
            |row: &[f64; N], value: f64| value - row.iter().zip(&solved.x).map(|(a, b)| a * b).sum::<f64>();
        let residuals: Vec<f64> = rows.iter().map(|(row, value)| residual(row, *value)).collect();
        let bound = 1.5 * sd_of_median_abs(residuals.iter().copied());
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

    #[test]
    fn equal_rows_do_not_determine_a_line() {
        assert!(least_squares([([1.0, 2.0], 3.0, 1.0), ([1.0, 2.0], 3.1, 1.0)].into_iter()).is_none());
    }

    #[test]
    fn noise_of_a_slow_course_is_that_of_its_values() {
        // Nearly normal: sums of twelve uniform numbers from a linear congruence.
        let mut state = 1u64;
        let mut uniform = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1u64 << 53) as f64
        };
        let values: Vec<f64> = (0..20_000)
            .map(|i| f64::from(i) * 1e-3 + (0..12).map(|_| uniform()).sum::<f64>() - 6.0)
            .collect();
        assert!((noise(&values) - 1.0).abs() < 0.03);
    }
}
