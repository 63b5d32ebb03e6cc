//! Checks what must hold for any table of net coefficients.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

pub use super::Answer;
use super::growth::{empty_nodes, violations};
use super::{Head, Source, check_brackets};
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
