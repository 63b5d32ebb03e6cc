use std::path::Path;

use soilctl_columns::{Cell, ColumnsError, Form, Kind, TableWriter};

use super::sidecar::{Sidecar, file_error, write_both};
use super::{COLUMNS, PredictionTable};
use crate::EarthPressureError;

/// Kinds of [`COLUMNS`].
const KINDS: [Kind; 5] = [Kind::Decimal, Kind::Decimal, Kind::Decimal, Kind::Decimal, Kind::Text];

/// Writes a table (`alpha_deg, phi_deg, delta_deg, k_net, status`) with its sidecar. Numbers are written so that they read back
/// to the same bits.
///
/// # Errors
/// [`EarthPressureError::File`] if a file cannot be written.
pub fn write_table(
    form: Form,
    table: &PredictionTable,
    source: &str,
    path: &Path,
) -> Result<(), EarthPressureError> {
    let rows = rows(form, table).map_err(|e| file_error(path, &e))?;
    write_both(path, &rows, &Sidecar::of(table, source))
}

fn rows(form: Form, table: &PredictionTable) -> Result<Vec<u8>, ColumnsError> {
    let columns = COLUMNS.into_iter().zip(KINDS);
    let mut writer = TableWriter::new(form, Vec::new(), "prediction_table", columns)?;
    for (node, cell) in table.filled() {
        let numbers = node.into_iter().chain([cell.k_net]).map(Cell::Float);
        writer.row(numbers.chain([Cell::Text(cell.status.word().into())]))?;
    }
    writer.finish()
}
