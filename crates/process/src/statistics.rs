//! Distributions, by the crate statrs.

use statrs::distribution::{ContinuousCDF, StudentsT};

/// Two-sided probability of a t value at least so large by chance; 1 without freedom.
pub(crate) fn two_sided_p(t: f64, freedom: f64) -> f64 {
    match StudentsT::new(0.0, 1.0, freedom) {
        Ok(student) if t.is_finite() => (2.0 * student.cdf(-t.abs())).clamp(0.0, 1.0),
        Ok(_) if t.is_infinite() => 0.0,
        _ => 1.0,
    }
}

/// The t value that is exceeded with probability `tail`, in (0, 0.5); `None` without freedom.
pub(crate) fn t_quantile(tail: f64, freedom: f64) -> Option<f64> {
    let t = StudentsT::new(0.0, 1.0, freedom).ok()?.inverse_cdf(1.0 - tail);
    t.is_finite().then_some(t)
}

/// Mean and sample standard deviation; `None` of fewer than two values.
pub(crate) fn mean_and_sd(values: &[f64]) -> Option<(f64, f64)> {
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
    fn students_t_is_that_of_the_tables() {
        // 97.5 % points of Student's t, any table.
        for (freedom, t) in [(1.0, 12.706), (4.0, 2.776), (10.0, 2.228), (30.0, 2.042)] {
            assert!((t_quantile(0.025, freedom).unwrap() - t).abs() < 1e-3);
            assert!((two_sided_p(t, freedom) - 0.05).abs() < 1e-4);
        }
        assert_eq!(two_sided_p(f64::INFINITY, 3.0), 0.0);
        assert_eq!(two_sided_p(2.0, 0.0), 1.0);
    }
}
