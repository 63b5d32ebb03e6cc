//! Order statistics: what outliers do not move.

/// The upper quartile of the standard normal distribution, which is the median of its absolute values.
const NORMAL_QUARTILE: f64 = 0.674_489_750_196_081_7;

/// Median; 0 of nothing. Sorts its argument.
#[must_use]
pub fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    let n = values.len();
    match (values.get(n / 2), n % 2) {
        (Some(&upper), 0) => f64::midpoint(values.get(n / 2 - 1).copied().unwrap_or(upper), upper),
        (Some(&middle), _) => middle,
        (None, _) => 0.0,
    }
}

/// Median of the distances from the median; 0 of nothing.
#[must_use]
pub fn median_absolute_deviation(values: &[f64]) -> f64 {
    let middle = median(&mut values.to_vec());
    median(&mut values.iter().map(|x| (x - middle).abs()).collect::<Vec<_>>())
}

/// Standard deviation of normal values about 0 that lies behind the median of their absolute values.
pub fn sd_of_median_abs(values: impl Iterator<Item = f64>) -> f64 {
    median(&mut values.map(f64::abs).collect::<Vec<_>>()) / NORMAL_QUARTILE
}

/// Standard deviation of the noise of evenly spaced values by their second differences, which a smooth course leaves nearly
/// untouched.
#[must_use]
pub fn noise(values: &[f64]) -> f64 {
    // The variance of a second difference is 1 + 4 + 1 times that of a value.
    sd_of_median_abs(values.windows(3).map(|w| w[0] - 2.0 * w[1] + w[2])) / 6.0_f64.sqrt()
}

/// Quantile of sorted values, linear between them (Hyndman and Fan 1996, type 7), for a share from 0 to 1; `None` of none.
#[must_use]
pub fn quantile(sorted: &[f64], share: f64) -> Option<f64> {
    let at = share * sorted.len().checked_sub(1)? as f64;
    // In range for a share from 0 to 1; `get` answers for others.
    let (low, high) = (sorted.get(at.floor() as usize)?, sorted.get(at.ceil() as usize)?);
    Some(low + (high - low) * at.fract())
}

/// Mean and sample standard deviation; `None` of fewer than two values.
#[must_use]
pub fn mean_and_sd(values: &[f64]) -> Option<(f64, f64)> {
    let n = values.len() as f64;
    (values.len() >= 2).then(|| {
        let mean = values.iter().sum::<f64>() / n;
        (mean, (values.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / (n - 1.0)).sqrt())
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn medians_of_even_odd_and_nothing() {
        assert_eq!(median(&mut [5.0, 1.0, 2.0]), 2.0);
        assert_eq!(median(&mut [5.0, 1.0, 2.0, 4.0]), 3.0);
        assert_eq!(median(&mut []), 0.0);
        assert_eq!(median_absolute_deviation(&[1.0, 1.0, 2.0, 2.0, 4.0, 6.0, 9.0]), 1.0);
    }

    /// Against R's `quantile(x, type = 7)`, worked by hand: 1, 2, 4, 8.
    #[test]
    fn quantiles_between_values() {
        let x = [1.0, 2.0, 4.0, 8.0];
        for (share, expected) in [(0.0, 1.0), (0.5, 3.0), (0.95, 7.4), (1.0, 8.0)] {
            assert!((quantile(&x, share).unwrap() - expected).abs() < 1e-12, "{share}");
        }
        assert_eq!((quantile(&[], 0.5), quantile(&[3.0], 0.95)), (None, Some(3.0)));
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
