/// Mean, standard deviation and ends of forces measured under the same conditions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Spread {
    pub(crate) mean: f64,
    /// Sample standard deviation (divided by n - 1); 0 for a single value.
    pub(crate) sd: f64,
    pub(crate) min: f64,
    pub(crate) max: f64,
}

impl Spread {
    /// Of at least one value.
    pub(crate) fn of(values: &[f64]) -> Self {
        let n = values.len() as f64;
        let min = values.iter().copied().fold(f64::INFINITY, f64::min);
        let max = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        // About the smallest value, so that equal values give exactly themselves and a deviation of exactly 0.
        let mean = min + values.iter().map(|x| x - min).sum::<f64>() / n;
        let squares = values.iter().map(|x| (x - mean).powi(2)).sum::<f64>();
        let sd = if values.len() < 2 { 0.0 } else { (squares / (n - 1.0)).sqrt() };
        Self { mean, sd, min, max }
    }
}

/// Mean of the values that are there; NaN is none.
pub(crate) fn mean_of_some(values: impl Iterator<Item = Option<f64>>) -> Option<f64> {
    let some: Vec<f64> = values.flatten().filter(|x| !x.is_nan()).collect();
    (!some.is_empty()).then(|| Spread::of(&some).mean)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_values_have_no_spread_at_all() {
        let spread = Spread::of(&[0.1, 0.1, 0.1]);
        assert_eq!((spread.mean, spread.sd), (0.1, 0.0));
    }

    #[test]
    fn the_deviation_is_that_of_a_sample() {
        // 2, 4, 4, 4, 5, 5, 7, 9: squares about 5 sum to 32, over n - 1 = 7.
        let spread = Spread::of(&[2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0]);
        assert!((spread.mean - 5.0).abs() < 1e-14);
        assert!((spread.sd - (32.0_f64 / 7.0).sqrt()).abs() < 1e-14);
        assert_eq!((spread.min, spread.max), (2.0, 9.0));
        assert_eq!(mean_of_some([None, Some(f64::NAN)].into_iter()), None);
    }
}
