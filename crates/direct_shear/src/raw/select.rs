//! Which runs of a load agree best.

/// Splits indices of `values` into the `keep` values with the smallest spread (maximum minus minimum) and the rest.
///
/// The closest values are neighbours when sorted, so only runs of neighbours are tried; of equal spreads the lowest
/// values win. Both lists are in the original order.
pub(crate) fn closest(values: &[f64], keep: usize) -> (Vec<usize>, Vec<usize>) {
    let mut order: Vec<usize> = (0..values.len()).collect();
    if values.len() <= keep || keep == 0 {
        return (order, Vec::new());
    }
    order.sort_by(|a, b| values[*a].total_cmp(&values[*b]));
    let mut best = (f64::INFINITY, 0);
    for start in 0..=order.len() - keep {
        let spread = values[order[start + keep - 1]] - values[order[start]];
        if spread < best.0 {
            best = (spread, start);
        }
    }
    let chosen = &order[best.1..best.1 + keep];
    (0..values.len()).partition(|index| chosen.contains(index))
}

/// Mean and sample standard deviation (`n - 1`), the latter only for two or more values.
#[allow(clippy::cast_precision_loss)]
pub(crate) fn mean_and_deviation(values: &[f64]) -> (f64, Option<f64>) {
    let n = values.len() as f64;
    let mean = values.iter().sum::<f64>() / n;
    let squares: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
    (mean, (values.len() > 1).then(|| (squares / (n - 1.0)).sqrt()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn the_odd_one_out_is_dropped() {
        assert_eq!(closest(&[41.0, 43.5, 41.4, 40.8], 3), (vec![0, 2, 3], vec![1]));
        assert_eq!(closest(&[41.0, 42.0], 3), (vec![0, 1], vec![]));
    }

    #[test]
    fn deviation_needs_two_values() {
        assert_eq!(mean_and_deviation(&[40.0]), (40.0, None));
        assert_eq!(mean_and_deviation(&[39.0, 40.0, 41.0]), (40.0, Some(1.0)));
    }

    proptest! {
        #[test]
        fn no_other_three_are_closer(values in prop::collection::vec(20.0..50.0, 4)) {
            let spread = |indices: &[usize]| {
                let chosen = indices.iter().map(|i| values[*i]);
                chosen.clone().fold(f64::MIN, f64::max) - chosen.fold(f64::MAX, f64::min)
            };
            let (kept, dropped) = closest(&values, 3);
            prop_assert_eq!((kept.len(), dropped.len()), (3, 1));
            for out in 0..4 {
                let others: Vec<usize> = (0..4).filter(|i| *i != out).collect();
                prop_assert!(spread(&kept) <= spread(&others));
            }
        }
    }
}
