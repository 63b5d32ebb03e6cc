//! Interpolation in a table: monotone piecewise cubics (Fritsch & Carlson 1980, Butland's slopes) in `ln K`
//! along alpha, then delta, then phi.
//!
//! The margin is an estimate of how far off the result may be. Along each axis it is the largest error that
//! **linear** interpolation can make of a function whose second derivative is the largest second difference seen
//! at the four nodes around the cell, times 1.5 (3 in an outermost cell and next to `delta = phi`). It is 0 at a solved node. A
//! test compares it with what interpolation really misses of a closed-form model.

use super::cubic::{cell_error, cell_slopes};
use super::place::{Node, Place};
use super::{CellStatus, PredictionTable};

/// A table made ready for look-ups: what depends on its nodes alone is worked out once.
#[derive(Debug, Clone)]
pub(super) struct Interpolator {
    table: PredictionTable,
    /// In the order of the table's cells.
    nodes: Vec<Option<Prepared>>,
}

/// A node of the table, and the cell between it and the next one along alpha.
#[derive(Debug, Clone, Copy)]
pub(super) struct Prepared {
    pub(super) node: Node,
    /// Slopes of `ln K` along alpha at both ends of the cell.
    pub(super) slopes: (f64, f64),
    /// Bound on the error along alpha in the cell, before the factor t (1 - t).
    pub(super) error: f64,
}

impl Interpolator {
    pub(super) fn new(table: PredictionTable) -> Self {
        let nodes = (0..table.len()).map(|index| prepared(&table, index)).collect();
        Self { table, nodes }
    }

    pub(super) const fn table(&self) -> &PredictionTable {
        &self.table
    }

    /// A filled node of the table.
    pub(super) fn node(&self, alpha: usize, phi: usize, delta: usize) -> Option<Prepared> {
        self.nodes[self.table.index(alpha, phi, delta)]
    }
}

fn prepared(table: &PredictionTable, index: usize) -> Option<Prepared> {
    let [alphas, phis, deltas] = table.axes();
    let (i, j, k) =
        (index / (phis.len() * deltas.len()), index / deltas.len() % phis.len(), index % deltas.len());
    let ln_k = |i: usize| Some(libm::log(table.cell(i, j, k)?.k_net));
    let margin = match table.cell(i, j, k)?.status {
        CellStatus::Solved => 0.0,
        CellStatus::Interpolated => filled_in_margin(table, i, j, k, ln_k(i)?),
    };
    let knot = |i: usize| Some((*alphas.get(i)?, ln_k(i)?));
    let slopes = match (knot(i), knot(i + 1)) {
        (Some(a), Some(b)) => cell_slopes(i.checked_sub(1).and_then(knot), a, b, knot(i + 2)),
        _ => (f64::NAN, f64::NAN),
    };
    let node = Node { ln_k: ln_k(i)?, margin };
    Some(Prepared { node, slopes, error: cell_error(alphas, i, &(0..alphas.len()), ln_k) })
}

/// Margin of a cell that was itself filled in: its distance from the chord between the solved cells on
/// either side along delta, plus what that chord may miss.
fn filled_in_margin(table: &PredictionTable, i: usize, j: usize, k: usize, ln_k: f64) -> f64 {
    let deltas = &table.axes()[2];
    let (x, y): (Vec<f64>, Vec<f64>) = (0..deltas.len())
        .filter_map(|k| table.cell(i, j, k).map(|cell| (deltas[k], cell)))
        .filter(|(_, cell)| cell.status == CellStatus::Solved)
        .map(|(x, cell)| (x, libm::log(cell.k_net)))
        .unzip();
    match Place::find(&x, deltas[k]) {
        Some(place) => {
            let chord = y[place.cell] + place.t * (y[(place.cell + 1).min(y.len() - 1)] - y[place.cell]);
            let error = cell_error(&x, place.cell, &(0..x.len()), |i| y.get(i).copied());
            (ln_k - chord).abs() + place.t * (1.0 - place.t) * error
        }
        // Nothing solved around it: as uncertain as a whole step of the table.
        None => std::f64::consts::LN_2,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::EarthPressureError;
    use crate::table::{Cell, Quantity};
    use crate::{Case, ChenLiu, ForceModel};
    use proptest::prelude::*;

    fn grid(low: f64, high: f64, step: f64) -> Vec<f64> {
        (0..=((high - low) / step).round() as usize).map(|i| low + step * i as f64).collect()
    }

    fn chen_table() -> Interpolator {
        let axes = [grid(70.0, 100.0, 5.0), grid(25.0, 50.0, 5.0), grid(0.0, 30.0, 5.0)];
        Interpolator::new(PredictionTable::fill(&ChenLiu, axes).unwrap())
    }

    #[test]
    fn exact_on_nodes_and_exponential_planes() {
        let mut table = PredictionTable::new(
            "t",
            Quantity::Estimate,
            [grid(70., 100., 10.), grid(25., 45., 5.), grid(0., 20., 5.)],
        )
        .unwrap();
        let f = |a: f64, p: f64, d: f64| libm::exp(0.01 * a + 0.08 * p + 0.02 * d - 3.0);
        for i in 0..table.len() {
            let [a, p, d] = table.node(i);
            table.insert([a, p, d], Cell { k_net: f(a, p, d), status: CellStatus::Solved }).unwrap();
        }
        let look = Interpolator::new(table).at(83.0).unwrap().lookup(37.3, 12.9).unwrap();
        assert!((look.k_net / f(83.0, 37.3, 12.9) - 1.0).abs() < 1e-12 && look.margin < 1e-12);
    }

    proptest! {
        /// Against the model itself: the margin covers what interpolation really misses.
        #[test]
        fn the_margin_covers_the_error(alpha in 70.0..100.0, phi in 25.0..50.0, delta in 0.0..30.0) {
            prop_assume!(delta <= phi);
            let exact = ChenLiu.predict(&Case::level_deg(alpha, phi, delta)).unwrap().k_net().0;
            let table = chen_table();
            let look = table.at(alpha).unwrap().lookup(phi, delta).unwrap();
            // One look-up works out what it needs, many share it; the bits are the same.
            prop_assert_eq!(look, table.slice(alpha).unwrap().lookup(phi, delta).unwrap());
            let error = libm::log(look.k_net / exact).abs();
            prop_assert!(error <= look.margin + 1e-4, "error {error} margin {}", look.margin);
            prop_assert!(error < 0.01);
        }

        /// A monotone table stays monotone between its nodes.
        #[test]
        fn interpolation_is_monotone(alpha in 70.0..100.0, phi in 30.0..49.0, delta in 0.0..29.0, step in 0.01..1.0) {
            let table = chen_table();
            let slice = table.slice(alpha).unwrap();
            let k = |p, d| slice.lookup(p, d).unwrap().k_net;
            prop_assert!(k(phi + step, delta) > k(phi, delta));
            prop_assert!(k(phi, delta + step) > k(phi, delta));
        }
    }

    /// Where the table ends at delta = phi its curvature is least known.
    #[test]
    fn the_margin_covers_the_error_up_to_delta_equal_phi() {
        let table = chen_table();
        for alpha in grid(70.0, 100.0, 2.5) {
            let slice = table.slice(alpha).unwrap();
            for phi in grid(25.0, 30.0, 0.25) {
                for delta in grid(phi - 5.0, phi, 0.125) {
                    let exact = ChenLiu.predict(&Case::level_deg(alpha, phi, delta)).unwrap().k_net().0;
                    let look = slice.lookup(phi, delta).unwrap();
                    let error = libm::log(look.k_net / exact).abs();
                    assert!(error <= look.margin + 1e-6, "{alpha} {phi} {delta}: {error} {}", look.margin);
                }
            }
        }
    }

    #[test]
    fn outside_and_empty_are_errors() {
        let table = chen_table();
        assert!(table.at(65.0).is_err());
        let slice = table.slice(70.0).unwrap();
        assert!(slice.lookup(24.0, 0.0).is_err() && slice.lookup(40.0, f64::NAN).is_err());
        let empty =
            PredictionTable::new("e", Quantity::Estimate, [vec![70., 80.], vec![30., 40.], vec![0., 10.]])
                .unwrap();
        let error = Interpolator::new(empty).at(75.0).unwrap().lookup(35.0, 5.0).unwrap_err();
        assert!(matches!(error, EarthPressureError::EmptyCell { .. }));
    }
}
