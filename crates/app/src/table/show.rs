//! Shows a table.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

pub use super::Answer;
use super::brackets::{BracketCell, Gaps};
use super::{Head, Source, TableCell};
use crate::table_file::{AnyTable, find_table};
use crate::{AppError, Watch};

/// Prints a table.
#[derive(Debug, Clone, Default, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
pub struct Request {
    #[command(flatten)]
    #[serde(flatten)]
    #[allow(missing_docs)]
    pub source: Source,
}

/// Finds the table.
///
/// # Errors
/// [`AppError`] if there is no such table, or its file makes no sense.
pub fn run(request: &Request, _watch: &dyn Watch) -> Result<Answer, AppError> {
    let (table, source) = match find_table(&request.source.table)? {
        AnyTable::Brackets(table) => {
            let cells = table.rows().iter().map(BracketCell::of).collect();
            return Ok(Answer::ShowBrackets {
                table: Head::of_brackets(&table),
                gaps: Gaps::of(&table),
                cells,
            });
        }
        AnyTable::Points(table, source) => (table, source),
    };
    let cells = table
        .filled()
        .map(|([alpha_deg, phi_deg, delta_deg], cell)| TableCell {
            alpha_deg,
            phi_deg,
            delta_deg,
            k_net: cell.k_net,
            status: cell.status.word(),
        })
        .collect();
    Ok(Answer::Show { table: Head::of(&table, &source), cells })
}
