//! `table show`.

use soilctl_earth_pressure::table::CellStatus;

use super::answer::{Head, TableAnswer, TableCell};
use super::brackets;
use super::file::{AnyTable, find_table};
use crate::error::CliError;
use crate::text::{columns, number};

pub(super) fn show(source: &str) -> Result<TableAnswer, CliError> {
    let (table, source) = match find_table(source)? {
        AnyTable::Brackets(table) => return Ok(brackets::show(&table)),
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
    Ok(TableAnswer::Show { table: Head::of(&table, &source), cells })
}

/// One block for each tool angle, friction angles down and interface friction angles across.
pub(super) fn show_text(table: &Head, cells: &[TableCell]) -> String {
    let interpolated = CellStatus::Interpolated.word();
    let mut text = String::from("k_net per slant length; * marks an interpolated cell\n");
    let mut cells = cells.iter().peekable();
    for alpha in &table.alpha_deg {
        text += &format!("\nalpha {} deg\n", number(*alpha));
        let deltas = table.delta_deg.iter().map(|delta| format!("delta {}", number(*delta)));
        let mut rows: Vec<Vec<String>> = vec![std::iter::once("phi".to_owned()).chain(deltas).collect()];
        for phi in &table.phi_deg {
            let mut row = vec![number(*phi)];
            for delta in &table.delta_deg {
                let here = |cell: &&TableCell| {
                    [cell.alpha_deg, cell.phi_deg, cell.delta_deg] == [*alpha, *phi, *delta]
                };
                row.push(match cells.next_if(here) {
                    Some(cell) if cell.status == interpolated => number(cell.k_net) + "*",
                    // A space below the mark, so that digits stay aligned.
                    Some(cell) => number(cell.k_net) + " ",
                    None => "- ".into(),
                });
            }
            rows.push(row);
        }
        text += &columns(&rows);
    }
    text
}
