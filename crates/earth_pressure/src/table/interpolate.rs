//! Interpolation in a table: monotone piecewise cubics (Fritsch & Carlson 1980, Butland's slopes) in `ln K`
//! along alpha, then delta, then phi.
//!
//! The margin is an estimate of how far off the result may be. Along each axis it is the largest error that
//! **linear** interpolation can make of a function whose second derivative is the largest second difference seen
//! at the four nodes around the cell, times 1.5 (3 in an outermost cell). It is 0 at a solved node. A test
//! compares it with what interpolation really misses of a closed-form model.

use soilctl_soil::Rounded;

use super::cubic::{cell_error, cell_slopes, hermite, node_slope};
use super::{CellStatus, PredictionTable};
use crate::EarthPressureError;

/// Result of a look-up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Lookup {
    /// Slant-normalised net coefficient.
    pub(super) k_net: f64,
    /// By how much, relatively, it may differ from what a solve would give; 0 at a solved node.
    pub(super) margin: f64,
}

/// A table made ready for look-ups: what depends on its nodes alone is worked out once.
#[derive(Debug, Clone)]
pub(super) struct Interpolator {
    table: PredictionTable,
    /// In the order of the table's cells.
    nodes: Vec<Option<Prepared>>,
}

/// A node of the table, and the cell between it and the next one along alpha.
#[derive(Debug, Clone, Copy)]
struct Prepared {
    node: Node,
    /// Slopes of `ln K` along alpha at both ends of the cell.
    slopes: (f64, f64),
    /// Bound on the error along alpha in the cell, before the factor t (1 - t).
    error: f64,
}

#[derive(Debug, Clone, Copy)]
struct Node {
    ln_k: f64,
    margin: f64,
}

impl Interpolator {
    pub(super) fn new(table: PredictionTable) -> Self {
        let nodes = (0..table.len()).map(|index| prepared(&table, index)).collect();
        Self { table, nodes }
    }

    pub(super) const fn table(&self) -> &PredictionTable {
        &self.table
    }

    /// The table at a tool angle in degrees, for one look-up.
    ///
    /// # Errors
    /// [`EarthPressureError::BadTable`] if the angle is outside the range of the table.
    pub(super) fn at(&self, alpha_deg: f64) -> Result<Section<'_>, EarthPressureError> {
        let alphas = &self.table.axes()[0];
        let place = Place::find(alphas, alpha_deg).ok_or_else(|| {
            self.table.bad(format!(
                "alpha is {} deg; the table covers {} to {} deg",
                Rounded(alpha_deg),
                Rounded(alphas[0]),
                Rounded(alphas[alphas.len() - 1])
            ))
        })?;
        Ok(Section { whole: self, alpha_deg, place })
    }

    /// The same for many look-ups.
    ///
    /// # Errors
    /// As [`Interpolator::at`].
    pub(super) fn slice(&self, alpha_deg: f64) -> Result<TableSlice<'_>, EarthPressureError> {
        Ok(TableSlice::new(self.at(alpha_deg)?))
    }
}

fn prepared(table: &PredictionTable, index: usize) -> Option<Prepared> {
    let [alphas, phis, deltas] = table.axes();
    let (i, j, k) =
        (index / (phis.len() * deltas.len()), index / deltas.len() % phis.len(), index % deltas.len());
    let ln_k = |i: usize| Some(table.cell(i, j, k)?.k_net.ln());
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
    Some(Prepared { node, slopes, error: cell_error(alphas, i, ln_k) })
}

/// Margin of a cell that was itself filled in: its distance from the chord between the solved cells on
/// either side along delta, plus what that chord may miss.
fn filled_in_margin(table: &PredictionTable, i: usize, j: usize, k: usize, ln_k: f64) -> f64 {
    let deltas = &table.axes()[2];
    let (x, y): (Vec<f64>, Vec<f64>) = (0..deltas.len())
        .filter_map(|k| table.cell(i, j, k).map(|cell| (deltas[k], cell)))
        .filter(|(_, cell)| cell.status == CellStatus::Solved)
        .map(|(x, cell)| (x, cell.k_net.ln()))
        .unzip();
    match Place::find(&x, deltas[k]) {
        Some(place) => {
            let chord = y[place.cell] + place.t * (y[(place.cell + 1).min(y.len() - 1)] - y[place.cell]);
            let error = cell_error(&x, place.cell, |i| y.get(i).copied());
            (ln_k - chord).abs() + place.t * (1.0 - place.t) * error
        }
        // Nothing solved around it: as uncertain as a whole step of the table.
        None => std::f64::consts::LN_2,
    }
}

/// `ln K` and the margin so far at the nodes of phi and delta, at one tool angle.
trait Grid {
    fn section(&self) -> &Section<'_>;

    fn node(&self, j: usize, k: usize) -> Option<Node>;

    /// Slope of `ln K` along delta at a node.
    fn slope(&self, j: usize, k: usize) -> f64;

    /// Bound on the error along phi in the cell above a node and along delta in the cell to its right, before the
    /// factor t (1 - t). Between nodes of the other axis it is interpolated, so that the margin is continuous.
    fn errors(&self, j: usize, k: usize) -> (f64, f64);
}

fn slope_at(grid: &impl Grid, j: usize, k: usize) -> f64 {
    node_slope(grid.section().delta(), k, |k| Some(grid.node(j, k)?.ln_k))
}

fn errors_at(grid: &impl Grid, j: usize, k: usize) -> (f64, f64) {
    let ln_k = |j: usize, k: usize| Some(grid.node(j, k)?.ln_k);
    let section = grid.section();
    (cell_error(section.phi(), j, |j| ln_k(j, k)), cell_error(section.delta(), k, |k| ln_k(j, k)))
}

/// A table at one tool angle. Nodes are worked out when they are asked for, which for one look-up are few.
#[derive(Debug, Clone, Copy)]
pub(super) struct Section<'a> {
    whole: &'a Interpolator,
    alpha_deg: f64,
    place: Place,
}

impl<'a> Section<'a> {
    fn phi(&self) -> &'a [f64] {
        &self.whole.table.axes()[1]
    }

    fn delta(&self) -> &'a [f64] {
        &self.whole.table.axes()[2]
    }

    /// A node between those of the table along alpha.
    fn between(&self, j: usize, k: usize) -> Option<Node> {
        let Place { cell, t } = self.place;
        let at = |i: usize| self.whole.nodes[self.whole.table.index(i, j, k)];
        let left = at(cell)?;
        let mut node = left.node;
        if t != 0.0 {
            let right = at(cell + 1)?.node;
            let alphas = &self.whole.table.axes()[0];
            let h = alphas[cell + 1] - alphas[cell];
            let ends = ((node.ln_k, left.slopes.0), (right.ln_k, left.slopes.1));
            node.ln_k = hermite(h, ends.0, ends.1, t);
            node.margin += t * (right.margin - node.margin);
        }
        node.margin += t * (1.0 - t) * left.error;
        Some(node)
    }
}

impl Grid for Section<'_> {
    fn section(&self) -> &Section<'_> {
        self
    }

    /// The node just above delta = phi in each row comes from a parallelogram, so that the triangle of the grid
    /// below the diagonal is interpolated linearly. Such a node is never an answer itself: delta <= phi.
    fn node(&self, j: usize, k: usize) -> Option<Node> {
        let node = self.between(j, k);
        let (phi, delta) = (self.phi(), self.delta());
        let is_above = || k > 0 && j + 1 < phi.len() && delta[k] > phi[j] && delta[k - 1] <= phi[j];
        if node.is_some() || !is_above() {
            return node;
        }
        let (a, b, c) = (self.between(j, k - 1)?, self.between(j + 1, k)?, self.between(j + 1, k - 1)?);
        Some(Node { ln_k: a.ln_k + b.ln_k - c.ln_k, margin: a.margin.max(b.margin).max(c.margin) })
    }

    fn slope(&self, j: usize, k: usize) -> f64 {
        slope_at(self, j, k)
    }

    fn errors(&self, j: usize, k: usize) -> (f64, f64) {
        errors_at(self, j, k)
    }
}

/// A table at one tool angle with all that a look-up needs, worked out for many of them.
#[derive(Debug, Clone)]
pub(super) struct TableSlice<'a> {
    section: Section<'a>,
    /// Row by row in phi, as what follows.
    nodes: Vec<Option<Node>>,
    slopes: Vec<f64>,
    errors: Vec<(f64, f64)>,
}

impl<'a> TableSlice<'a> {
    fn new(section: Section<'a>) -> Self {
        let columns = section.delta().len();
        let places = || (0..section.phi().len()).flat_map(|j| (0..columns).map(move |k| (j, k)));
        let nodes = places().map(|(j, k)| section.node(j, k)).collect();
        let mut slice = Self { section, nodes, slopes: Vec::new(), errors: Vec::new() };
        slice.slopes = places().map(|(j, k)| slope_at(&slice, j, k)).collect();
        slice.errors = places().map(|(j, k)| errors_at(&slice, j, k)).collect();
        slice
    }

    fn index(&self, j: usize, k: usize) -> usize {
        j * self.section.delta().len() + k
    }

    /// As [`Section::lookup`].
    pub(super) fn lookup(&self, phi_deg: f64, delta_deg: f64) -> Result<Lookup, EarthPressureError> {
        lookup(self, phi_deg, delta_deg)
    }
}

impl Grid for TableSlice<'_> {
    fn section(&self) -> &Section<'_> {
        &self.section
    }

    fn node(&self, j: usize, k: usize) -> Option<Node> {
        self.nodes[self.index(j, k)]
    }

    fn slope(&self, j: usize, k: usize) -> f64 {
        self.slopes[self.index(j, k)]
    }

    fn errors(&self, j: usize, k: usize) -> (f64, f64) {
        self.errors[self.index(j, k)]
    }
}

impl Section<'_> {
    /// Look-up at phi and delta in degrees.
    ///
    /// # Errors
    /// [`EarthPressureError::BadTable`] if the point is outside the table, [`EarthPressureError::EmptyCell`] if
    /// the cells around it are not filled.
    pub(super) fn lookup(&self, phi_deg: f64, delta_deg: f64) -> Result<Lookup, EarthPressureError> {
        lookup(self, phi_deg, delta_deg)
    }
}

fn lookup(grid: &impl Grid, phi_deg: f64, delta_deg: f64) -> Result<Lookup, EarthPressureError> {
    let section = grid.section();
    let (phi, delta) = (section.phi(), section.delta());
    let place = |axis: &[f64], x: f64, label: &str| {
        Place::find(axis, x).ok_or_else(|| {
            section.whole.table.bad(format!(
                "{label} is {} deg; the table covers {} to {} deg",
                Rounded(x),
                Rounded(axis[0]),
                Rounded(axis[axis.len() - 1])
            ))
        })
    };
    let in_phi = place(phi, phi_deg, "phi")?;
    let in_delta = place(delta, delta_deg, "delta")?;
    let node = in_phi.interpolate(phi, |j| along_delta(grid, j, in_delta));
    let node = node.ok_or_else(|| EarthPressureError::EmptyCell {
        table: section.whole.table.name().into(),
        alpha_deg: section.alpha_deg,
        phi_deg,
        delta_deg,
    })?;
    let error = |j: usize, k: usize| grid.errors(j.min(phi.len() - 1), k.min(delta.len() - 1));
    let (j, k) = (in_phi.cell, in_delta.cell);
    let here = error(j, k);
    let along_phi = here.0 + in_delta.t * (error(j, k + 1).0 - here.0);
    let along_delta = here.1 + in_phi.t * (error(j + 1, k).1 - here.1);
    let margin =
        node.margin + in_phi.t * (1.0 - in_phi.t) * along_phi + in_delta.t * (1.0 - in_delta.t) * along_delta;
    Ok(Lookup { k_net: node.ln_k.exp(), margin })
}

/// Row `j` at a place along delta.
fn along_delta(grid: &impl Grid, j: usize, place: Place) -> Option<Node> {
    let a = grid.node(j, place.cell)?;
    if place.t == 0.0 {
        return Some(a);
    }
    let b = grid.node(j, place.cell + 1)?;
    let delta = grid.section().delta();
    let h = delta[place.cell + 1] - delta[place.cell];
    let ends = ((a.ln_k, grid.slope(j, place.cell)), (b.ln_k, grid.slope(j, place.cell + 1)));
    Some(Node {
        ln_k: hermite(h, ends.0, ends.1, place.t),
        margin: a.margin + place.t * (b.margin - a.margin),
    })
}

/// Place of a value on an axis: between nodes `cell` and `cell + 1` at fraction `t`.
#[derive(Debug, Clone, Copy)]
struct Place {
    cell: usize,
    t: f64,
}

impl Place {
    fn find(axis: &[f64], x: f64) -> Option<Self> {
        const SNAP: f64 = 1e-9;
        let last = axis.len().checked_sub(1)?;
        if !(x >= axis[0] - SNAP && x <= axis[last] + SNAP) {
            return None;
        }
        let after = axis.partition_point(|&node| node <= x + SNAP);
        let cell = after.saturating_sub(1);
        if cell == last || (x - axis[cell]).abs() <= SNAP {
            return Some(Self { cell, t: 0.0 });
        }
        Some(Self { cell, t: (x - axis[cell]) / (axis[cell + 1] - axis[cell]) })
    }

    /// Interpolated node; `None` if an end of the cell is not filled.
    fn interpolate(self, axis: &[f64], at: impl Fn(usize) -> Option<Node>) -> Option<Node> {
        let left = at(self.cell)?;
        if self.t == 0.0 {
            return Some(left);
        }
        let right = at(self.cell + 1)?;
        let before = self.cell.checked_sub(1).and_then(|i| Some((axis[i], at(i)?.ln_k)));
        let after = (self.cell + 2 < axis.len())
            .then(|| at(self.cell + 2))
            .flatten()
            .map(|n| (axis[self.cell + 2], n.ln_k));
        let (a, b) = ((axis[self.cell], left.ln_k), (axis[self.cell + 1], right.ln_k));
        let slopes = cell_slopes(before, a, b, after);
        Some(Node {
            ln_k: hermite(b.0 - a.0, (a.1, slopes.0), (b.1, slopes.1), self.t),
            margin: left.margin + self.t * (right.margin - left.margin),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
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
        let f = |a: f64, p: f64, d: f64| (0.01 * a + 0.08 * p + 0.02 * d - 3.0).exp();
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
            let error = (look.k_net / exact).ln().abs();
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
