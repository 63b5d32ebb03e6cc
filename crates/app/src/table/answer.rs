//! What `table` answers.

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_earth_pressure::table::{BracketTable, CellStatus, PredictionTable, Quantity};

use super::bounds::{BuiltBounds, Plan};
use super::brackets::{BracketCell, Gaps, SOURCE};
use super::check_brackets::BracketFindings;
use crate::Outcome;

/// What was done with a table.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(tag = "action", rename_all = "lowercase")]
pub enum Answer {
    /// The table itself.
    Show {
        /// The table.
        table: Head,
        /// Filled cells, by alpha, then phi, then delta.
        cells: Vec<TableCell>,
    },
    /// A table of brackets itself.
    #[serde(rename = "show")]
    ShowBrackets {
        /// The table.
        table: Head,
        /// Its gaps; null for an empty table.
        gaps: Option<Gaps>,
        /// Filled cells, by alpha, then phi, then delta.
        cells: Vec<BracketCell>,
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
    /// A table of bounds was built, or a part of it.
    #[serde(rename = "build")]
    BuildBounds(BuiltBounds),
    /// What building a table of bounds would take.
    Plan(Plan),
    /// Tables of bounds were united.
    Merge {
        /// The table.
        table: Head,
        /// Its gaps; null for an empty table.
        gaps: Option<Gaps>,
        /// File that was written; its description is beside it, with `.json` added to the name.
        file: String,
    },
    /// A table was checked.
    Check {
        /// The table.
        table: Head,
        /// Whether nothing was found against it.
        consistent: bool,
        /// Neighbouring cells between which the coefficient does not grow, wherever it lies in a bracket.
        violations: Vec<Violation>,
        /// Nodes with delta up to phi that are not filled: alpha, phi and delta in degrees.
        empty_nodes: Vec<[f64; 3]>,
        /// What else was checked of brackets; null for a table with one number a node.
        brackets: Option<BracketFindings>,
    },
}

/// What a table is.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Head {
    /// Name.
    pub name: String,
    /// `estimate`, `lower-bound`, `upper-bound` or `bracket`.
    pub quantity: String,
    /// Where the numbers come from.
    pub source: String,
    /// Nodes of the tool angle.
    pub alpha_deg: Vec<f64>,
    /// Nodes of the friction angle.
    pub phi_deg: Vec<f64>,
    /// Nodes of the interface friction angle.
    pub delta_deg: Vec<f64>,
    /// Number of filled cells.
    pub filled: usize,
    /// Of these, cells that were interpolated when the table was made.
    pub interpolated: usize,
    /// Number of nodes.
    pub nodes: usize,
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

    pub(super) fn of_brackets(table: &BracketTable) -> Self {
        let rows = table.rows();
        let axis = |d: usize| {
            let mut nodes: Vec<f64> = rows.iter().map(|row| row.node()[d]).collect();
            nodes.sort_by(f64::total_cmp);
            nodes.dedup();
            nodes
        };
        let [alpha_deg, phi_deg, delta_deg] = [axis(0), axis(1), axis(2)];
        Self {
            name: table.name().into(),
            quantity: "bracket".into(),
            source: SOURCE.into(),
            nodes: alpha_deg.len() * phi_deg.len() * delta_deg.len(),
            alpha_deg,
            phi_deg,
            delta_deg,
            filled: rows.len(),
            interpolated: rows.iter().filter(|row| row.status == CellStatus::Interpolated).count(),
        }
    }
}

/// A filled cell.
#[derive(Debug, Serialize, JsonSchema)]
pub struct TableCell {
    /// Tool angle.
    pub alpha_deg: f64,
    /// Friction angle.
    pub phi_deg: f64,
    /// Interface friction angle.
    pub delta_deg: f64,
    /// Net coefficient per slant length.
    pub k_net: f64,
    /// `solved` or `interpolated`.
    pub status: &'static str,
}

/// Two neighbouring cells between which the coefficient does not grow.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Violation {
    /// The angle that grows: alpha, phi or delta.
    pub along: &'static str,
    /// First node: alpha, phi and delta in degrees.
    pub from: [f64; 3],
    /// Second node.
    pub to: [f64; 3],
    /// Coefficient at the first node; of a bracket, its lower bound.
    pub k_from: f64,
    /// Coefficient at the second node; of a bracket, its upper bound.
    pub k_to: f64,
}

impl crate::Answer for Answer {
    const SCHEMA: &'static str = "soilctl.table/1";

    fn outcome(&self) -> Outcome {
        match self {
            Self::Check { consistent: false, .. } => Outcome::Negative,
            Self::BuildBounds(built) if !built.finished => Outcome::Partial,
            _ => Outcome::Done,
        }
    }
}
