//! What `table` answers.

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_earth_pressure::table::{CellStatus, PredictionTable, Quantity};

use super::check::check_text;
use super::show::show_text;
use crate::output::Answer;
use crate::verbs::Outcome;

/// What was done with a table.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(tag = "action", rename_all = "lowercase")]
pub(crate) enum TableAnswer {
    /// The table itself.
    Show {
        /// The table.
        table: Head,
        /// Filled cells, by alpha, then phi, then delta.
        cells: Vec<TableCell>,
    },
    /// A table was filled and written.
    Build {
        /// The table.
        table: Head,
        /// File that was written; its description is beside it, with `.json` added to the name.
        file: String,
        /// What the model said about the first node it has no answer for.
        first_refusal: Option<String>,
    },
    /// A table was checked.
    Check {
        /// The table.
        table: Head,
        /// Whether no violation was found.
        consistent: bool,
        /// Neighbouring cells between which the coefficient does not grow.
        violations: Vec<Violation>,
        /// Nodes with delta up to phi that are not filled: alpha, phi and delta in degrees.
        empty_nodes: Vec<[f64; 3]>,
    },
}

/// What a table is.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Head {
    /// Name.
    pub(super) name: String,
    /// `estimate`, `lower-bound` or `upper-bound`.
    pub(super) quantity: String,
    /// Where the numbers come from.
    pub(super) source: String,
    /// Nodes of the tool angle.
    pub(super) alpha_deg: Vec<f64>,
    /// Nodes of the friction angle.
    pub(super) phi_deg: Vec<f64>,
    /// Nodes of the interface friction angle.
    pub(super) delta_deg: Vec<f64>,
    /// Number of filled cells.
    pub(super) filled: usize,
    /// Of these, cells that were interpolated when the table was made.
    pub(super) interpolated: usize,
    /// Number of nodes.
    pub(super) nodes: usize,
}

impl Head {
    pub(super) fn of(table: &PredictionTable, source: &str) -> Self {
        let [alpha, phi, delta] = table.axes().clone();
        let quantity = match table.quantity() {
            Quantity::Estimate => "estimate",
            Quantity::LowerBound => "lower-bound",
            Quantity::UpperBound => "upper-bound",
        };
        let interpolated = table.filled().filter(|(_, cell)| cell.status == CellStatus::Interpolated).count();
        Self {
            name: table.name().into(),
            quantity: quantity.into(),
            source: source.into(),
            alpha_deg: alpha,
            phi_deg: phi,
            delta_deg: delta,
            filled: table.filled().count(),
            interpolated,
            nodes: table.len(),
        }
    }

    pub(super) fn text(&self) -> String {
        format!(
            "{} ({})\n{}\nnodes: {} (alpha {}, phi {}, delta {}), filled: {}, of these interpolated: {}\n",
            self.name,
            self.quantity,
            self.source,
            self.nodes,
            self.alpha_deg.len(),
            self.phi_deg.len(),
            self.delta_deg.len(),
            self.filled,
            self.interpolated,
        )
    }
}

/// A filled cell.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct TableCell {
    /// Tool angle.
    pub(super) alpha_deg: f64,
    /// Friction angle.
    pub(super) phi_deg: f64,
    /// Interface friction angle.
    pub(super) delta_deg: f64,
    /// Net coefficient per slant length.
    pub(super) k_net: f64,
    /// `solved` or `interpolated`.
    pub(super) status: &'static str,
}

/// Two neighbouring cells between which the coefficient does not grow.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Violation {
    /// The angle that grows: alpha, phi or delta.
    pub(super) along: &'static str,
    /// First node: alpha, phi and delta in degrees.
    pub(super) from: [f64; 3],
    /// Second node.
    pub(super) to: [f64; 3],
    /// Coefficient at the first node.
    pub(super) k_from: f64,
    /// Coefficient at the second node.
    pub(super) k_to: f64,
}

impl TableAnswer {
    pub(super) fn outcome(&self) -> Outcome {
        match self {
            Self::Check { consistent: false, .. } => Outcome::Negative,
            _ => Outcome::Done,
        }
    }
}

impl Answer for TableAnswer {
    const SCHEMA: &'static str = "soilctl.table/1";

    fn text(&self) -> String {
        match self {
            Self::Show { table, cells } => table.text() + &show_text(table, cells),
            Self::Build { table, file, first_refusal } => {
                let refusal = first_refusal.as_ref().map(|text| format!("first empty node: {text}\n"));
                table.text() + &format!("written to {file}\n") + &refusal.unwrap_or_default()
            }
            Self::Check { table, violations, empty_nodes, .. } => {
                table.text() + &check_text(violations, empty_nodes)
            }
        }
    }
}
