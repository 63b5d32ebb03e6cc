//! Gridded models: coefficients on a grid of tool angle, friction angle and interface friction.
//!
//! Any model or bound can fill a [`PredictionTable`]. Every cell says whether it was solved or itself comes from
//! interpolation; every look-up says by how much interpolation may be wrong.

mod bracket;
mod bracket_file;
mod cells;
mod csv_file;
mod cubic;
mod interpolate;
mod model;
mod parquet_file;
mod parquet_pages;
mod place;
mod section;
mod sidecar;
mod write;

pub use bracket::{BracketRow, BracketRules, BracketTable};
pub use bracket_file::{
    BRACKET_SCHEMA, BracketSidecar, is_bracket_file, parse_bracket, read_bracket, write_bracket,
};
pub use csv_file::read_csv;
pub use model::{BracketModel, TableModel};
pub use parquet_file::read_parquet;
pub use sidecar::{SIDECAR_SCHEMA, Sidecar, sidecar_path};
pub use soilctl_columns::Form;
pub use write::write_table;

use serde::{Deserialize, Serialize};

use cells::{AXIS_NAMES, Placed, SAME_NODE_DEG, axis_problem, in_words, k_net_problem};

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

/// Columns of a table file.
const COLUMNS: [&str; 5] = ["alpha_deg", "phi_deg", "delta_deg", "k_net", "status"];

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
}
