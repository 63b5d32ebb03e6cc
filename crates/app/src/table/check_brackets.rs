//! What must hold of proven bounds.

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_earth_pressure::table::{BracketRow, BracketTable, Quantity};

use super::brackets::Gaps;
use super::growth::{empty_nodes, violations};
use super::{Answer, Head};
use crate::AppError;
use crate::table_file::{AnyTable, find_table};

/// What was found in a table of brackets, beside its growth.
#[derive(Debug, Serialize, JsonSchema)]
pub struct BracketFindings {
    /// Its gaps; null for an empty table.
    pub gaps: Option<Gaps>,
    /// Nodes at which the lower bound is above the upper bound: alpha, phi and delta in degrees.
    pub crossed: Vec<[f64; 3]>,
    /// Bounds of another table that contradict a bracket.
    pub contradicted: Vec<Contradiction>,
}

/// A bound of another table that contradicts a bracket.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Contradiction {
    /// The other table.
    pub table: String,
    /// Node: alpha, phi and delta in degrees.
    pub node: [f64; 3],
    /// Its bound.
    pub bound: f64,
    /// The bound of the bracket that it contradicts.
    pub proven: f64,
}

pub(super) fn check(table: &BracketTable, against: &[String]) -> Result<Answer, AppError> {
    let rows = table.rows();
    let crossed: Vec<_> = rows.iter().filter(|row| row.lower > row.upper).map(BracketRow::node).collect();
    let (mut growth, mut empty) = (Vec::new(), Vec::new());
    if crossed.is_empty() {
        let (lower, upper) = table.split()?;
        // The truth may be anywhere in a bracket: only brackets that are apart contradict growth.
        growth = violations(&lower, &upper);
        empty = empty_nodes(&lower);
    }
    let mut contradicted = Vec::new();
    for name in against {
        contradicted.extend(contradictions(table, name)?);
    }
    let proven = rows.iter().all(|row| row.certified);
    Ok(Answer::Check {
        table: Head::of_brackets(table),
        consistent: proven && crossed.is_empty() && growth.is_empty() && contradicted.is_empty(),
        violations: growth,
        empty_nodes: empty,
        brackets: Some(BracketFindings { gaps: Gaps::of(table), crossed, contradicted }),
    })
}

/// Solved bounds of another table that proven brackets refute: lower bounds above an upper one, or the other way round.
fn contradictions(table: &BracketTable, name: &str) -> Result<Vec<Contradiction>, AppError> {
    let other = match find_table(name)? {
        AnyTable::Points(other, _) if other.quantity() != Quantity::Estimate => other,
        _ => {
            return Err(AppError::Request(format!(
                "--against is {name}, which is no table of lower or of upper bounds; an estimate is no contradiction \
                 wherever it lies"
            )));
        }
    };
    let mut found = Vec::new();
    for (node, cell) in other.filled() {
        let near = |a: [f64; 3]| a.iter().zip(node).all(|(x, y)| (x - y).abs() < 1e-9);
        let Some(row) = table.rows().iter().find(|row| near(row.node())) else { continue };
        let (refuted, proven) = match other.quantity() {
            Quantity::LowerBound => (cell.k_net > row.upper, row.upper),
            _ => (cell.k_net < row.lower, row.lower),
        };
        if refuted {
            found.push(Contradiction { table: other.name().into(), node, bound: cell.k_net, proven });
        }
    }
    Ok(found)
}
