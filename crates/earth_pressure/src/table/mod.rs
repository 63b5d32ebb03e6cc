//! Gridded models: coefficients on a grid of tool angle, friction angle and interface friction.
//!
//! Any model or bound can fill a [`PredictionTable`]. Every cell says whether it was solved or itself comes from
//! interpolation; every look-up says by how much interpolation may be wrong.

mod csv_file;
mod cubic;
mod interpolate;
mod model;
mod parquet_file;
mod parquet_pages;
mod sidecar;

pub use csv_file::{read_csv, write_csv};
pub use interpolate::{Lookup, TableSlice};
pub use model::{BracketModel, TableModel};
pub use parquet_file::{read_parquet, write_parquet};
pub use sidecar::{SIDECAR_SCHEMA, Sidecar, sidecar_path};

use serde::{Deserialize, Serialize};
use soilctl_soil::Rounded;

use crate::{Case, EarthPressureError, ForceModel};

/// Most nodes of a table and most rows of a table file. Far beyond what anyone has solved (Appendix C has 294), and
/// reading it still takes less than 1 GB.
pub const MAX_NODES: usize = 4_000_000;

/// Whether a cell was computed or filled in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum CellStatus {
    /// Computed by the model.
    Solved,
    /// Interpolated from other cells when the table was made.
    Interpolated,
}

impl CellStatus {
    /// The word used in files.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Solved => "solved",
            Self::Interpolated => "interpolated",
        }
    }

    /// The status behind a word, or what is wrong with the word.
    fn parse(word: &str) -> Result<Self, String> {
        [Self::Solved, Self::Interpolated]
            .into_iter()
            .find(|status| status.word() == word)
            .ok_or_else(|| format!("status is {word:?}; it must be \"solved\" or \"interpolated\""))
    }
}

/// What the numbers of a table are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Quantity {
    /// A point estimate.
    Estimate,
    /// A lower bound.
    LowerBound,
    /// An upper bound.
    UpperBound,
}

/// One filled cell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cell {
    /// Slant-normalised net coefficient, above 0.
    pub k_net: f64,
    /// How it came about.
    pub status: CellStatus,
}

/// A cell with its node: alpha, phi and delta in degrees.
pub(crate) type Placed = ([f64; 3], Cell);

const AXIS_NAMES: [&str; 3] = ["alpha", "phi", "delta"];
/// Two angles closer than this (degrees) are one node, so that nodes survive a unit conversion.
const SAME_NODE_DEG: f64 = 1e-9;

/// Net coefficients on a grid (level surface, cohesionless, slant-normalised).
#[derive(Debug, Clone, PartialEq)]
pub struct PredictionTable {
    name: String,
    quantity: Quantity,
    /// Ascending nodes of alpha, phi and delta in degrees.
    axes: [Vec<f64>; 3],
    cells: Vec<Option<Cell>>,
}

impl PredictionTable {
    /// An empty table on a grid. Each axis is strictly ascending, at least two nodes, degrees; all three together
    /// make at most [`MAX_NODES`] nodes.
    ///
    /// # Errors
    /// [`EarthPressureError::BadTable`] if an axis is too short, not finite or not ascending,
    /// [`EarthPressureError::TooLarge`] if there are too many nodes.
    pub fn new(
        name: impl Into<String>,
        quantity: Quantity,
        axes: [Vec<f64>; 3],
    ) -> Result<Self, EarthPressureError> {
        let name = name.into();
        for (axis, label) in axes.iter().zip(AXIS_NAMES) {
            if let Some(problem) = axis_problem(axis) {
                let problem = format!("axis {label} {problem}");
                return Err(EarthPressureError::BadTable { table: name, problem });
            }
        }
        let counts = [axes[0].len(), axes[1].len(), axes[2].len()];
        let nodes = counts.into_iter().try_fold(1_usize, usize::checked_mul);
        match nodes.filter(|&nodes| nodes <= MAX_NODES) {
            Some(nodes) => Ok(Self { name, quantity, axes, cells: vec![None; nodes] }),
            None => {
                let size = format!("a grid of {} x {} x {} nodes", counts[0], counts[1], counts[2]);
                Err(EarthPressureError::TooLarge { table: name, size, limit: MAX_NODES })
            }
        }
    }

    /// A table filled by a model on every node with delta <= phi. Nodes where the model has no answer stay
    /// empty.
    ///
    /// # Errors
    /// As [`PredictionTable::new`].
    pub fn fill(model: &dyn ForceModel, axes: [Vec<f64>; 3]) -> Result<Self, EarthPressureError> {
        let mut table = Self::new(model.id(), Quantity::Estimate, axes)?;
        for index in 0..table.cells.len() {
            let [alpha, phi, delta] = table.node(index);
            if delta <= phi
                && let Ok(p) = model.predict(&Case::level_deg(alpha, phi, delta))
            {
                table.set(index, Cell { k_net: p.k_net().0, status: CellStatus::Solved })?;
            }
        }
        Ok(table)
    }

    /// Name, for messages and provenance.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// What the numbers are.
    #[must_use]
    pub const fn quantity(&self) -> Quantity {
        self.quantity
    }

    /// Nodes of alpha, phi and delta in degrees.
    #[must_use]
    pub const fn axes(&self) -> &[Vec<f64>; 3] {
        &self.axes
    }

    /// Number of nodes, filled or not.
    #[must_use]
    pub fn len(&self) -> usize {
        self.cells.len()
    }

    /// Whether no cell is filled.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.cells.iter().all(Option::is_none)
    }

    /// Filled cells with their nodes (alpha, phi, delta in degrees), in order.
    pub fn filled(&self) -> impl Iterator<Item = ([f64; 3], Cell)> + '_ {
        self.cells.iter().enumerate().filter_map(|(i, c)| c.map(|c| (self.node(i), c)))
    }

    /// The cell at node indices, if filled.
    #[must_use]
    pub fn cell(&self, alpha: usize, phi: usize, delta: usize) -> Option<Cell> {
        self.cells[self.index(alpha, phi, delta)]
    }

    /// Fills the cell at a node given in degrees.
    ///
    /// # Errors
    /// [`EarthPressureError::BadTable`] if the point is not a node, is filled already, or the coefficient is not
    /// above 0.
    pub fn insert(&mut self, node: [f64; 3], cell: Cell) -> Result<(), EarthPressureError> {
        let mut at = [0; 3];
        for (d, place) in at.iter_mut().enumerate() {
            let axis = &self.axes[d];
            // Binary search: an axis may have a million nodes, and a file a row for each.
            *place = axis.partition_point(|&x| x <= node[d] - SAME_NODE_DEG);
            if !axis.get(*place).is_some_and(|x| (x - node[d]).abs() < SAME_NODE_DEG) {
                return Err(self.bad(format!("{} is not a node of the grid", in_words(node))));
            }
        }
        let index = self.index(at[0], at[1], at[2]);
        if self.cells[index].is_some() {
            return Err(self.bad(format!("the cell at {} is given twice; give it once", in_words(node))));
        }
        self.set(index, cell)
    }

    fn set(&mut self, index: usize, cell: Cell) -> Result<(), EarthPressureError> {
        if let Some(problem) = k_net_problem(cell.k_net) {
            return Err(self.bad(format!("{problem}, at {}", in_words(self.node(index)))));
        }
        self.cells[index] = Some(cell);
        Ok(())
    }

    fn index(&self, alpha: usize, phi: usize, delta: usize) -> usize {
        (alpha * self.axes[1].len() + phi) * self.axes[2].len() + delta
    }

    fn node(&self, index: usize) -> [f64; 3] {
        let (n1, n2) = (self.axes[1].len(), self.axes[2].len());
        [self.axes[0][index / (n1 * n2)], self.axes[1][index / n2 % n1], self.axes[2][index % n2]]
    }

    fn bad(&self, problem: String) -> EarthPressureError {
        EarthPressureError::BadTable { table: self.name.clone(), problem }
    }

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
                        format!("{} is given twice, first in {}; give it once", in_words(node), whence(first)),
                    ),
                    None => error,
                }
            })?;
        }
        Ok(table)
    }
}

/// A node as messages show it.
fn in_words(node: [f64; 3]) -> String {
    let [alpha, phi, delta] = node.map(Rounded);
    format!("alpha {alpha} deg, phi {phi} deg, delta {delta} deg")
}

fn k_net_problem(k_net: f64) -> Option<String> {
    let good = k_net > 0.0 && k_net.is_finite();
    (!good).then(|| format!("k_net is {}; it must be a finite number above 0", Rounded(k_net)))
}

/// What is wrong with an axis; names the values, not the whole axis, which may be long.
fn axis_problem(axis: &[f64]) -> Option<String> {
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
