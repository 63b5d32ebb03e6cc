//! Interpolation in a table: monotone piecewise cubics (Fritsch & Carlson 1980, Butland's slopes) in `ln K`
//! along alpha, then delta, then phi.
//!
//! The margin is an estimate of how far off the result may be. Along each axis it is the largest error that
//! **linear** interpolation can make of a function whose second derivative is the largest second difference seen
//! at the four nodes around the cell, times 1.5 (3 in an outermost cell). It is 0 at a solved node. A test
//! compares it with what interpolation really misses of a closed-form model.

use soilctl_soil::Rounded;

use super::cubic::{cell_error, hermite, monotone_cubic, node_slope};
use super::{CellStatus, PredictionTable};
use crate::EarthPressureError;

/// Result of a look-up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lookup {
    /// Slant-normalised net coefficient.
    pub k_net: f64,
    /// By how much, relatively, it may differ from what a solve would give; 0 at a solved node.
    pub margin: f64,
}

/// A table at one tool angle: `ln K` and the margin so far at the nodes of phi and delta.
#[derive(Debug, Clone)]
pub struct TableSlice {
    name: String,
    alpha_deg: f64,
    phi: Vec<f64>,
    delta: Vec<f64>,
    /// Row by row in phi.
    nodes: Vec<Option<Node>>,
    /// Slope of `ln K` along delta at each node.
    slopes: Vec<f64>,
    /// Bound on the error along phi in the cell above each node and along delta in the cell to its right, before
    /// the factor t (1 - t). Between nodes of the other axis it is interpolated, so that the margin is continuous.
    errors: Vec<(f64, f64)>,
}

#[derive(Debug, Clone, Copy)]
struct Node {
    ln_k: f64,
    margin: f64,
}

impl PredictionTable {
    /// The table at a tool angle inside its range.
    ///
    /// # Errors
    /// [`EarthPressureError::BadTable`] if the angle is outside the range of the table.
    pub fn slice(&self, alpha_deg: f64) -> Result<TableSlice, EarthPressureError> {
        let [alphas, phis, deltas] = self.axes();
        let place = Place::find(alphas, alpha_deg).ok_or_else(|| {
            self.bad(format!(
                "alpha is {} deg; the table covers {} to {} deg",
                Rounded(alpha_deg),
                Rounded(alphas[0]),
                Rounded(alphas[alphas.len() - 1])
            ))
        })?;
        let mut nodes = Vec::with_capacity(phis.len() * deltas.len());
        for j in 0..phis.len() {
            for k in 0..deltas.len() {
                let node = |i: usize| {
                    let cell = self.cell(i, j, k)?;
                    let margin = match cell.status {
                        CellStatus::Solved => 0.0,
                        CellStatus::Interpolated => self.filled_in_margin(i, j, k, cell.k_net.ln()),
                    };
                    Some(Node { ln_k: cell.k_net.ln(), margin })
                };
                let error = cell_error(alphas, place.cell, |i| node(i).map(|n| n.ln_k));
                nodes.push(place.interpolate(alphas, node).map(|mut node| {
                    node.margin += place.t * (1.0 - place.t) * error;
                    node
                }));
            }
        }
        let (phi, delta) = (phis.clone(), deltas.clone());
        let (name, slopes, errors) = (self.name.clone(), Vec::new(), Vec::new());
        let mut slice = TableSlice { name, alpha_deg, phi, delta, nodes, slopes, errors };
        slice.complete_diagonal();
        slice.prepare();
        Ok(slice)
    }

    /// Margin of a cell that was itself filled in: its distance from the chord between the solved cells on
    /// either side along delta, plus what that chord may miss.
    fn filled_in_margin(&self, i: usize, j: usize, k: usize, ln_k: f64) -> f64 {
        let deltas = &self.axes()[2];
        let solved: Vec<(f64, f64)> = (0..deltas.len())
            .filter_map(|k| self.cell(i, j, k).map(|c| (deltas[k], c)))
            .filter(|(_, c)| c.status == CellStatus::Solved)
            .map(|(x, c)| (x, c.k_net.ln()))
            .collect();
        let (x, y): (Vec<f64>, Vec<f64>) = solved.into_iter().unzip();
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
}

impl TableSlice {
    /// Look-up at phi and delta in degrees.
    ///
    /// # Errors
    /// [`EarthPressureError::BadTable`] if the point is outside the table, [`EarthPressureError::EmptyCell`] if
    /// the cells around it are not filled.
    pub fn lookup(&self, phi_deg: f64, delta_deg: f64) -> Result<Lookup, EarthPressureError> {
        let place = |axis: &[f64], x: f64, label: &str| {
            Place::find(axis, x).ok_or_else(|| EarthPressureError::BadTable {
                table: self.name.clone(),
                problem: format!(
                    "{label} is {} deg; the table covers {} to {} deg",
                    Rounded(x),
                    Rounded(axis[0]),
                    Rounded(axis[axis.len() - 1])
                ),
            })
        };
        let in_phi = place(&self.phi, phi_deg, "phi")?;
        let in_delta = place(&self.delta, delta_deg, "delta")?;
        let node = in_phi.interpolate(&self.phi, |j| self.along_delta(j, in_delta));
        let node = node.ok_or_else(|| EarthPressureError::EmptyCell {
            table: self.name.clone(),
            alpha_deg: self.alpha_deg,
            phi_deg,
            delta_deg,
        })?;
        let error = |j: usize, k: usize| {
            let (j, k) = (j.min(self.phi.len() - 1), k.min(self.delta.len() - 1));
            self.errors[j * self.delta.len() + k]
        };
        let (j, k) = (in_phi.cell, in_delta.cell);
        let along_phi = error(j, k).0 + in_delta.t * (error(j, k + 1).0 - error(j, k).0);
        let along_delta = error(j, k).1 + in_phi.t * (error(j + 1, k).1 - error(j, k).1);
        let margin = node.margin
            + in_phi.t * (1.0 - in_phi.t) * along_phi
            + in_delta.t * (1.0 - in_delta.t) * along_delta;
        Ok(Lookup { k_net: node.ln_k.exp(), margin })
    }

    /// Row `j` at a place along delta.
    fn along_delta(&self, j: usize, place: Place) -> Option<Node> {
        let left = j * self.delta.len() + place.cell;
        let a = self.nodes[left]?;
        if place.t == 0.0 {
            return Some(a);
        }
        let b = self.nodes[left + 1]?;
        let h = self.delta[place.cell + 1] - self.delta[place.cell];
        let ends = ((a.ln_k, self.slopes[left]), (b.ln_k, self.slopes[left + 1]));
        Some(Node {
            ln_k: hermite(h, ends.0, ends.1, place.t),
            margin: a.margin + place.t * (b.margin - a.margin),
        })
    }

    /// Slopes and error bounds at all nodes.
    fn prepare(&mut self) {
        let (rows, columns) = (self.phi.len(), self.delta.len());
        for j in 0..rows {
            for k in 0..columns {
                let ln_k = |j: usize, k: usize| {
                    (j < rows && k < columns).then(|| self.nodes[j * columns + k])?.map(|n| n.ln_k)
                };
                self.slopes.push(node_slope(&self.delta, k, |k| ln_k(j, k)));
                self.errors.push((
                    cell_error(&self.phi, j, |j| ln_k(j, k)),
                    cell_error(&self.delta, k, |k| ln_k(j, k)),
                ));
            }
        }
    }

    /// Fills the node just above delta = phi in each row by a parallelogram, so that the triangle of the grid
    /// below the diagonal is interpolated linearly. Such a node is never an answer itself: delta <= phi.
    fn complete_diagonal(&mut self) {
        let n = self.delta.len();
        for j in 0..self.phi.len().saturating_sub(1) {
            for k in 1..n {
                let above = self.delta[k] > self.phi[j] && self.delta[k - 1] <= self.phi[j];
                if !above || self.nodes[j * n + k].is_some() {
                    continue;
                }
                let corners =
                    (self.nodes[j * n + k - 1], self.nodes[(j + 1) * n + k], self.nodes[(j + 1) * n + k - 1]);
                if let (Some(a), Some(b), Some(c)) = corners {
                    self.nodes[j * n + k] = Some(Node {
                        ln_k: a.ln_k + b.ln_k - c.ln_k,
                        margin: a.margin.max(b.margin).max(c.margin),
                    });
                }
            }
        }
    }
}

/// Place of a value on an axis: between nodes `cell` and `cell + 1` at fraction `t`.
#[derive(Clone, Copy)]
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
        let ends = ((axis[self.cell], left.ln_k), (axis[self.cell + 1], right.ln_k));
        Some(Node {
            ln_k: monotone_cubic(before, ends.0, ends.1, after, self.t),
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

    fn chen_table() -> PredictionTable {
        PredictionTable::fill(&ChenLiu, [grid(70.0, 100.0, 5.0), grid(25.0, 50.0, 5.0), grid(0.0, 30.0, 5.0)])
            .unwrap()
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
        let look = table.slice(83.0).unwrap().lookup(37.3, 12.9).unwrap();
        assert!((look.k_net / f(83.0, 37.3, 12.9) - 1.0).abs() < 1e-12 && look.margin < 1e-12);
    }

    proptest! {
        /// Against the model itself: the margin covers what interpolation really misses.
        #[test]
        fn the_margin_covers_the_error(alpha in 70.0..100.0, phi in 25.0..50.0, delta in 0.0..30.0) {
            prop_assume!(delta <= phi);
            let exact = ChenLiu.predict(&Case::level_deg(alpha, phi, delta)).unwrap().k_net().0;
            let look = chen_table().slice(alpha).unwrap().lookup(phi, delta).unwrap();
            let error = (look.k_net / exact).ln().abs();
            prop_assert!(error <= look.margin + 1e-4, "error {error} margin {}", look.margin);
            prop_assert!(error < 0.01);
        }

        /// A monotone table stays monotone between its nodes.
        #[test]
        fn interpolation_is_monotone(alpha in 70.0..100.0, phi in 30.0..49.0, delta in 0.0..29.0, step in 0.01..1.0) {
            let slice = chen_table().slice(alpha).unwrap();
            let k = |p, d| slice.lookup(p, d).unwrap().k_net;
            prop_assert!(k(phi + step, delta) > k(phi, delta));
            prop_assert!(k(phi, delta + step) > k(phi, delta));
        }
    }

    #[test]
    fn outside_and_empty_are_errors() {
        let table = chen_table();
        assert!(table.slice(65.0).is_err());
        let slice = table.slice(70.0).unwrap();
        assert!(slice.lookup(24.0, 0.0).is_err() && slice.lookup(40.0, f64::NAN).is_err());
        let empty =
            PredictionTable::new("e", Quantity::Estimate, [vec![70., 80.], vec![30., 40.], vec![0., 10.]])
                .unwrap();
        let error = empty.slice(75.0).unwrap().lookup(35.0, 5.0).unwrap_err();
        assert!(matches!(error, EarthPressureError::EmptyCell { .. }));
    }
}
