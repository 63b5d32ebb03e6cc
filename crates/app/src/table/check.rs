//! Checks what must hold for any table of net coefficients.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_earth_pressure::table::PredictionTable;

pub use super::Answer;
use super::{Head, Source, Violation, check_brackets};
use crate::table_file::{AnyTable, find_table};
use crate::{AppError, Watch};

/// Checks a table; it is inconsistent if a coefficient does not grow with alpha, phi or delta.
#[derive(Debug, Clone, Default, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
pub struct Request {
    #[command(flatten)]
    #[serde(flatten)]
    #[allow(missing_docs)]
    pub source: Source,

    /// With a table of bounds: another table of lower or upper bounds, whose errors it proves; may be repeated
    #[arg(long, value_name = "FILE|NAME")]
    pub against: Vec<String>,
}

/// Checks the table.
///
/// # Errors
/// [`AppError`] if there is no such table, its file makes no sense, or there is nothing to hold it against.
pub fn run(request: &Request, _watch: &dyn Watch) -> Result<Answer, AppError> {
    let (table, source) = match find_table(&request.source.table)? {
        AnyTable::Brackets(table) => return check_brackets::check(&table, &request.against),
        AnyTable::Points(table, source) => (table, source),
    };
    if let Some(name) = request.against.first() {
        return Err(AppError::Request(format!(
            "--against {name} needs a table of brackets to hold it against, and {} has one number a node",
            table.name()
        )));
    }
    let violations = violations(&table, &table);
    Ok(Answer::Check {
        table: Head::of(&table, &source),
        consistent: violations.is_empty(),
        violations,
        empty_nodes: empty_nodes(&table),
        brackets: None,
    })
}

fn places(table: &PredictionTable) -> impl Iterator<Item = [usize; 3]> {
    let [n0, n1, n2] = [0, 1, 2].map(|d| table.axes()[d].len());
    (0..n0).flat_map(move |i| (0..n1).flat_map(move |j| (0..n2).map(move |k| [i, j, k])))
}

fn node(table: &PredictionTable, at: [usize; 3]) -> [f64; 3] {
    [0, 1, 2].map(|d| table.axes()[d][at[d]])
}

/// Neighbours between which the coefficient fails to grow, wherever it lies between its ends; more friction or a plate
/// leaning further back resists more in every model.
pub(super) fn violations(lower: &PredictionTable, upper: &PredictionTable) -> Vec<Violation> {
    let mut found = Vec::new();
    for at in places(lower) {
        let Some(here) = lower.cell(at[0], at[1], at[2]) else { continue };
        for (d, along) in ["alpha", "phi", "delta"].into_iter().enumerate() {
            let mut next = at;
            next[d] += 1;
            if next[d] == lower.axes()[d].len() {
                continue;
            }
            let Some(there) = upper.cell(next[0], next[1], next[2]) else { continue };
            if there.k_net <= here.k_net {
                let (from, to) = (node(lower, at), node(lower, next));
                found.push(Violation { along, from, to, k_from: here.k_net, k_to: there.k_net });
            }
        }
    }
    found
}

/// Unfilled nodes at which a model could answer.
pub(super) fn empty_nodes(table: &PredictionTable) -> Vec<[f64; 3]> {
    places(table)
        .filter(|at| table.cell(at[0], at[1], at[2]).is_none())
        .map(|at| node(table, at))
        .filter(|[_, phi, delta]| delta <= phi)
        .collect()
}
