//! A table from loose cells, and what may be wrong with them.

use soilctl_soil::Rounded;

use super::{Cell, PredictionTable, Quantity};
use crate::EarthPressureError;

/// A cell with its node: alpha, phi and delta in degrees.
pub(crate) type Placed = ([f64; 3], Cell);

/// Names of the axes.
pub(super) const AXIS_NAMES: [&str; 3] = ["alpha", "phi", "delta"];
/// Two angles closer than this (degrees) are one node, so that nodes survive a unit conversion.
pub(super) const SAME_NODE_DEG: f64 = 1e-9;

impl PredictionTable {
    /// A table from loose cells: the axes are the values that occur. `whence` says where a cell was read, for
    /// messages.
    pub(crate) fn from_cells(
        name: &str,
        quantity: Quantity,
        cells: &[Placed],
        whence: impl Fn(usize) -> String,
    ) -> Result<Self, EarthPressureError> {
        let bad = |i: usize, problem: String| EarthPressureError::BadTable { table: whence(i), problem };
        for (i, (node, cell)) in cells.iter().enumerate() {
            if let Some(d) = node.iter().position(|x| !x.is_finite()) {
                let problem =
                    format!("{}_deg is {}; it must be a finite number of degrees", AXIS_NAMES[d], node[d]);
                return Err(bad(i, problem));
            }
            if let Some(problem) = k_net_problem(cell.k_net) {
                return Err(bad(i, problem));
            }
        }
        let axis = |d: usize| {
            let mut nodes: Vec<f64> = cells.iter().map(|(n, _)| n[d]).collect();
            nodes.sort_by(f64::total_cmp);
            nodes.dedup_by(|next, kept| *next - *kept < SAME_NODE_DEG);
            nodes
        };
        let mut table = Self::new(name, quantity, [axis(0), axis(1), axis(2)])?;
        for (i, &(node, cell)) in cells.iter().enumerate() {
            table.insert(node, cell).map_err(|error| {
                // Every node is on the grid and every coefficient is good: it can only be given twice.
                let same = |other: &Placed| {
                    other.0.iter().zip(node).all(|(a, b)| (a - b).abs() < 2.0 * SAME_NODE_DEG)
                };
                match cells[..i].iter().position(same) {
                    Some(first) => bad(
                        i,
                        format!(
                            "{} is given twice, first in {}; give it once",
                            in_words(node),
                            whence(first)
                        ),
                    ),
                    None => error,
                }
            })?;
        }
        Ok(table)
    }
}

/// A node as messages show it.
pub(super) fn in_words(node: [f64; 3]) -> String {
    let [alpha, phi, delta] = node.map(Rounded);
    format!("alpha {alpha} deg, phi {phi} deg, delta {delta} deg")
}

/// What is wrong with a coefficient.
pub(super) fn k_net_problem(k_net: f64) -> Option<String> {
    let good = k_net > 0.0 && k_net.is_finite();
    (!good).then(|| format!("k_net is {}; it must be a finite number above 0", Rounded(k_net)))
}

/// What is wrong with an axis; names the values, not the whole axis, which may be long.
pub(super) fn axis_problem(axis: &[f64]) -> Option<String> {
    if let Some(value) = axis.iter().find(|x| !x.is_finite()) {
        return Some(format!("has a node at {value}; every node must be a finite number of degrees"));
    }
    if let Some(pair) = axis.windows(2).find(|pair| pair[0] >= pair[1]) {
        let (before, after) = (Rounded(pair[0]), Rounded(pair[1]));
        return Some(format!("goes from {before} to {after} deg; its nodes must ascend"));
    }
    match axis {
        [] => Some("is empty; it must have at least two nodes".into()),
        [only] => Some(format!("has one node only, {} deg; it must have at least two", Rounded(*only))),
        _ => None,
    }
}
