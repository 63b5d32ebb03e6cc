//! Distributions, by the crate `statrs`.

use statrs::distribution::{ChiSquared, ContinuousCDF, Normal, StudentsT};

/// Probability that chi-square with `freedom` degrees of freedom exceeds `value`; 1 without freedom or below 0.
#[must_use]
pub fn chi_square_tail(value: f64, freedom: usize) -> f64 {
    match ChiSquared::new(freedom as f64) {
        Ok(chi_square) if value > 0.0 => chi_square.sf(value).clamp(0.0, 1.0),
        _ => 1.0,
    }
}

/// Probability that a standard normal number exceeds a value.
#[must_use]
pub fn normal_tail(value: f64) -> f64 {
    Normal::standard().sf(value)
}

/// The standard normal number that is exceeded with probability `tail`, in (0, 1).
#[must_use]
pub fn normal_quantile(tail: f64) -> f64 {
    -Normal::standard().inverse_cdf(tail)
}

/// Two-sided probability of a t value at least so large by chance; 1 without freedom.
#[must_use]
pub fn two_sided_p(t: f64, freedom: f64) -> f64 {
    match StudentsT::new(0.0, 1.0, freedom) {
        Ok(student) if t.is_finite() => (2.0 * student.cdf(-t.abs())).clamp(0.0, 1.0),
        Ok(_) if t.is_infinite() => 0.0,
        _ => 1.0,
    }
}

/// The t value that is exceeded with probability `tail`, in (0, 0.5); `None` without freedom.
#[must_use]
pub fn t_quantile(tail: f64, freedom: f64) -> Option<f64> {
    let t = StudentsT::new(0.0, 1.0, freedom).ok()?.inverse_cdf(1.0 - tail);
    t.is_finite().then_some(t)
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

    /// Against mpmath 1.3 with 50 digits: `gammainc(k/2, x/2, inf, regularized=True)` and `erfc(x/sqrt(2))/2`.
    #[test]
    fn tails_are_those_of_many_digits() {
        for (value, freedom, expected) in [
            (0.01, 1, 0.920_344_325_445_942),
            (3.84, 1, 0.050_043_521_248_705_1),
            (60.0, 1, 9.485_737_571_073_848e-15),
            (5.99, 2, 0.050_036_627_086_586_28),
            (7.8, 3, 0.050_331_097_859_853_35),
            (40.0, 4, 4.328_422_607_120_971e-8),
            (11.0, 5, 0.051_379_983_483_069_53),
            (200.0, 9, 3.312_992_393_909_553e-38),
        ] {
            assert!((chi_square_tail(value, freedom) / expected - 1.0).abs() < 1e-11, "{value} {freedom}");
        }
        for (value, expected) in [
            (-3.0, 0.998_650_101_968_369_9),
            (-0.5, 0.691_462_461_274_013_1),
            (0.0, 0.5),
            (1.0, 0.158_655_253_931_457_1),
            (2.9, 0.001_865_813_300_384_038),
            (8.0, 6.220_960_574_271_784e-16),
        ] {
            // `statrs` is 9e-11 off at 1.
            assert!((normal_tail(value) / expected - 1.0).abs() < 2e-10, "{value}");
        }
        for (tail, expected) in [(0.025, 1.959_963_984_540_054), (0.5, 0.0), (1e-6, 4.753_424_308_822_899)] {
            assert!((normal_quantile(tail) - expected).abs() < 1e-8, "{tail}");
        }
        assert_eq!((chi_square_tail(-1.0, 3), chi_square_tail(5.0, 0)), (1.0, 1.0));
    }
}
