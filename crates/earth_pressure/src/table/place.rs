//! A place on an axis, and the node that belongs there.

use super::cubic::{cell_slopes, hermite};

/// `ln K` and the margin at a node.
#[derive(Debug, Clone, Copy)]
pub(super) struct Node {
    pub(super) ln_k: f64,
    pub(super) margin: f64,
}

/// Place of a value on an axis: between nodes `cell` and `cell + 1` at fraction `t`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    pub(super) cell: usize,
    pub(super) t: f64,
}

impl Place {
    pub(super) fn find(axis: &[f64], x: f64) -> Option<Self> {
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
    pub(super) fn interpolate(self, axis: &[f64], at: impl Fn(usize) -> Option<Node>) -> Option<Node> {
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
