//! What `table` answers.

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_earth_pressure::table::{BracketTable, CellStatus, PredictionTable, Quantity};

use super::bounds::{BuiltBounds, Plan};
use super::brackets::{self, BracketCell, Gaps, SOURCE};
use super::check::check_text;
use super::check_brackets::BracketFindings;
use super::show::show_text;
use crate::output::Words;
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
pub(crate) struct Head {
    /// Name.
    pub(super) name: String,
    /// `estimate`, `lower-bound`, `upper-bound` or `bracket`.
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
    /// Coefficient at the first node; of a bracket, its lower bound.
    pub(super) k_from: f64,
    /// Coefficient at the second node; of a bracket, its upper bound.
    pub(super) k_to: f64,
}

impl TableAnswer {
    pub(super) fn outcome(&self) -> Outcome {
        match self {
            Self::Check { consistent: false, .. } => Outcome::Negative,
            Self::BuildBounds(built) if !built.finished => Outcome::Partial,
            _ => Outcome::Done,
        }
    }
}

impl soilctl_app::Answer for TableAnswer {
    const SCHEMA: &'static str = "soilctl.table/1";
}

impl Words for TableAnswer {
    fn text(&self) -> String {
        match self {
            Self::Show { table, cells } => table.text() + &show_text(table, cells),
            Self::Build { table, file, first_refusal } => {
                let refusal = first_refusal.as_ref().map(|text| format!("first empty node: {text}\n"));
                table.text() + &format!("written to {file}\n") + &refusal.unwrap_or_default()
            }
            Self::Check { table, violations, empty_nodes, brackets, .. } => {
                let findings = brackets.as_ref().map_or_else(String::new, BracketFindings::text);
                table.text() + &findings + &check_text(violations, empty_nodes)
            }
            Self::ShowBrackets { table, gaps, cells } => {
                table.text() + &gaps_text(gaps) + &brackets::show_text(cells)
            }
            Self::BuildBounds(built) => built.text(),
            Self::Plan(plan) => plan.text(),
            Self::Merge { table, gaps, file } => {
                table.text() + &gaps_text(gaps) + &format!("written to {file}\n")
            }
        }
    }
}

fn gaps_text(gaps: &Option<Gaps>) -> String {
    gaps.as_ref().map_or_else(String::new, Gaps::text)
}
