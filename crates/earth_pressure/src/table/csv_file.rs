use std::path::Path;

use csv::{ErrorKind, StringRecord};

use super::sidecar::{Sidecar, file_error};
use super::{COLUMNS, Cell, CellStatus, MAX_NODES, Placed, PredictionTable};
use crate::EarthPressureError;

/// Reads a table and its sidecar. The columns may stand in any order and among others.
///
/// # Errors
/// [`EarthPressureError::File`] if a file cannot be read, [`EarthPressureError::BadTable`] if its content is wrong
/// (with the line) or another version's, [`EarthPressureError::TooLarge`] if it has more than [`MAX_NODES`] rows.
pub fn read_csv(path: &Path) -> Result<(PredictionTable, Sidecar), EarthPressureError> {
    let sidecar = Sidecar::read(path)?;
    // Rows of another length are reported by what is missing in them.
    let mut reader =
        csv::ReaderBuilder::new().flexible(true).from_path(path).map_err(|e| file_error(path, &e))?;
    let places = places(reader.headers().map_err(|e| csv_error(path, &e))?)
        .map_err(|problem| bad_line(path, 1, problem))?;
    let (mut cells, mut lines) = (Vec::<Placed>::new(), Vec::new());
    let mut record = StringRecord::new();
    while reader.read_record(&mut record).map_err(|e| csv_error(path, &e))? {
        if cells.len() == MAX_NODES {
            return Err(EarthPressureError::TooLarge {
                table: path.display().to_string(),
                size: format!("more than {MAX_NODES} rows"),
                limit: MAX_NODES,
            });
        }
        let line = record.position().map_or(0, csv::Position::line);
        cells.push(cell(&record, places).map_err(|problem| bad_line(path, line, problem))?);
        lines.push(line);
    }
    sidecar.check_count(path, cells.len())?;
    let whence = |i: usize| at_line(path, lines[i]);
    Ok((PredictionTable::from_cells(&sidecar.name, sidecar.quantity, &cells, whence)?, sidecar))
}

/// Where each of [`COLUMNS`] stands.
fn places(headers: &StringRecord) -> Result<[usize; 5], String> {
    let mut places = [0; 5];
    for (place, column) in places.iter_mut().zip(COLUMNS) {
        let mut found = headers.iter().enumerate().filter(|(_, name)| name.trim() == column).map(|(i, _)| i);
        *place = found.next().ok_or_else(|| {
            format!("column {column} is missing; the first line must name {}", COLUMNS.join(", "))
        })?;
        if found.next().is_some() {
            return Err(format!("column {column} is given twice; remove or rename one of the two"));
        }
    }
    Ok(places)
}

fn cell(record: &StringRecord, places: [usize; 5]) -> Result<Placed, String> {
    let field = |i: usize| match record.get(places[i]) {
        Some(text) if !text.trim().is_empty() => Ok(text.trim()),
        _ => Err(format!("{} is missing; every row must have {}", COLUMNS[i], COLUMNS.join(", "))),
    };
    let number = |i: usize| {
        let text = field(i)?;
        text.parse::<f64>()
            .map_err(|_| format!("{} is {text:?}; it must be a number with a decimal point", COLUMNS[i]))
    };
    let node = [number(0)?, number(1)?, number(2)?];
    let (k_net, word) = (number(3)?, field(4)?);
    Ok((node, Cell { k_net, status: CellStatus::parse(word)? }))
}

fn at_line(path: &Path, line: u64) -> String {
    format!("{}, line {line}", path.display())
}

fn bad_line(path: &Path, line: u64, problem: String) -> EarthPressureError {
    EarthPressureError::BadTable { table: at_line(path, line), problem }
}

fn csv_error(path: &Path, error: &csv::Error) -> EarthPressureError {
    match (error.kind(), error.position()) {
        (ErrorKind::Utf8 { .. }, position) => {
            let line = position.map_or(1, csv::Position::line);
            bad_line(path, line, "the text is not UTF-8; save the file as UTF-8".into())
        }
        _ => file_error(path, error),
    }
}
