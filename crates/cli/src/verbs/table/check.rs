//! `table check`: what must hold for any table of net coefficients.

use soilctl_earth_pressure::table::PredictionTable;

use super::answer::{Head, TableAnswer, Violation};
use super::brackets::in_words;
use super::check_brackets;
use super::file::{AnyTable, find_table};
use crate::error::CliError;
use crate::text::number;

/// Findings of one kind listed in words.
pub(super) const LISTED: usize = 20;

pub(super) fn check(source: &str, against: &[String]) -> Result<TableAnswer, CliError> {
    let (table, source) = match find_table(source)? {
        AnyTable::Brackets(table) => return check_brackets::check(&table, against),
        AnyTable::Points(table, source) => (table, source),
    };
    if let Some(name) = against.first() {
        return Err(CliError::Usage(format!(
            "--against {name} needs a table of brackets to hold it against, and {} has one number a node",
            table.name()
        )));
    }
    let violations = violations(&table, &table);
    Ok(TableAnswer::Check {
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

pub(super) fn check_text(violations: &[Violation], empty_nodes: &[[f64; 3]]) -> String {
    let mut text = format!("empty nodes with delta up to phi: {}\n", empty_nodes.len());
    for at in empty_nodes.iter().take(LISTED) {
        text += &format!("  {}\n", in_words(*at));
    }
    text += &format!("places where k_net does not grow: {}\n", violations.len());
    for v in violations.iter().take(LISTED) {
        let (from, to) = (in_words(v.from), in_words(v.to));
        text += &format!(
            "  along {}: {} at {from}, then {} at {to}\n",
            v.along,
            number(v.k_from),
            number(v.k_to)
        );
    }
    if violations.len().max(empty_nodes.len()) > LISTED {
        text += &format!("(the first {LISTED} of each; --format json lists all)\n");
    }
    text
}
