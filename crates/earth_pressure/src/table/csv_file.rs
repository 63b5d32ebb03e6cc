use std::path::Path;

use serde::{Deserialize, Serialize};

use super::sidecar::{Sidecar, file_error};
use super::{Cell, CellStatus, PredictionTable};
use crate::EarthPressureError;

#[derive(Serialize, Deserialize)]
struct Row {
    alpha_deg: f64,
    phi_deg: f64,
    delta_deg: f64,
    k_net: f64,
    status: String,
}

/// Writes a table as CSV (`alpha_deg, phi_deg, delta_deg, k_net, status`) with its sidecar. Numbers are written
/// so that they read back to the same bits.
///
/// # Errors
/// [`EarthPressureError::File`] if a file cannot be written.
pub fn write_csv(table: &PredictionTable, source: &str, path: &Path) -> Result<(), EarthPressureError> {
    let mut writer = csv::Writer::from_path(path).map_err(|e| file_error(path, &e))?;
    for ([alpha_deg, phi_deg, delta_deg], cell) in table.filled() {
        let row = Row { alpha_deg, phi_deg, delta_deg, k_net: cell.k_net, status: cell.status.word().into() };
        writer.serialize(row).map_err(|e| file_error(path, &e))?;
    }
    writer.flush().map_err(|e| file_error(path, &e))?;
    Sidecar::of(table, source).write(path)
}

/// Reads a table and its sidecar.
///
/// # Errors
/// [`EarthPressureError::File`] if a file is missing or malformed (with the line),
/// [`EarthPressureError::BadTable`] if its content is wrong or another version's.
pub fn read_csv(path: &Path) -> Result<(PredictionTable, Sidecar), EarthPressureError> {
    let sidecar = Sidecar::read(path)?;
    let mut reader = csv::Reader::from_path(path).map_err(|e| file_error(path, &e))?;
    let mut cells = Vec::new();
    for (i, row) in reader.deserialize::<Row>().enumerate() {
        let row = row.map_err(|e| file_error(path, &e))?;
        let status = CellStatus::from_word(&row.status).ok_or_else(|| EarthPressureError::BadTable {
            table: format!("{}, line {}", path.display(), i + 2),
            problem: format!("status is {:?}; it must be \"solved\" or \"interpolated\"", row.status),
        })?;
        cells.push(([row.alpha_deg, row.phi_deg, row.delta_deg], Cell { k_net: row.k_net, status }));
    }
    sidecar.check_count(path, cells.len())?;
    Ok((PredictionTable::from_cells(&sidecar.name, sidecar.quantity, &cells)?, sidecar))
}
