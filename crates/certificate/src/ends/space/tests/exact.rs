//! Solutions of equations against rational numbers.

use num_traits::Zero;
use proptest::prelude::*;

use super::super::system::{Row, System};
use crate::interval::tests::{BigRational, exact, holds};

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// As many equations as numbers, each with the one before: enclosures hold the only solution, and are narrow.
    #[test]
    fn the_only_solution_is_enclosed(
        factors in prop::collection::vec((-1.0..1.0_f64, 0.7..2.0_f64, -1.0..1.0_f64), 1..90), guess in -10.0..10.0_f64,
        scale in -8..8_i32,
    ) {
        let count = factors.len();
        let scale = 10.0_f64.powi(scale);
        let rows: Vec<Row> = factors.iter().enumerate().map(|(group, &(before, own, right))| {
            let before = group.checked_sub(1).map(|k| (k, (scale * before).into()));
            let entries = before.into_iter().chain([(group, (scale * own).into())]).collect();
            Row { group, entries, right: right.into() }
        }).collect();
        let mut solution: Vec<BigRational> = Vec::new();
        for &(before, own, right) in &factors {
            let last = solution.last().cloned().unwrap_or_else(BigRational::zero);
            solution.push((exact(right) - exact(scale * before) * last) / exact(scale * own));
        }
        let places = (0..count).map(|i| [i as f64, 0.0, 0.0]).collect();
        let system = System { rows, places, columns: count, of: "equations" };
        let found = system.solve(&vec![guess; count]).unwrap();
        let largest = found.iter().map(|x| x.hi().abs()).fold(0.0, f64::max);
        for (found, solution) in found.iter().zip(&solution) {
            prop_assert!(holds(*found, solution));
            prop_assert!(found.hi() - found.lo() < 1e-8 * largest.max(1.0), "{found:?} {largest}");
        }
    }
}
