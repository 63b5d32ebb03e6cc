//! When strokes begin and end, as somebody has read it off.

use crate::request::finite;
use crate::{AppError, TableSource};

/// Begin and end of strokes in s from a table with these two columns.
pub(super) fn windows(table: &TableSource) -> Result<Vec<[f64; 2]>, AppError> {
    let wrong =
        |line: u64, problem: String| AppError::Request(format!("{}, line {line}: {problem}", table.name()));
    let text = table.text()?;
    let text = text.trim_start_matches('\u{feff}');
    let mut reader =
        csv::ReaderBuilder::new().flexible(true).trim(csv::Trim::All).from_reader(text.as_bytes());
    let unreadable = |problem: csv::Error| wrong(1, problem.to_string());
    let header = reader.headers().map_err(unreadable)?.clone();
    let place = |wanted: &str| header.iter().position(|name| name == wanted);
    let (Some(start), Some(end)) = (place("start"), place("end")) else {
        let header = text.lines().next().unwrap_or("");
        return Err(wrong(1, format!("the header is {header:?}; it must have the columns start and end")));
    };
    let mut found = Vec::new();
    for record in reader.records() {
        let record = record.map_err(unreadable)?;
        let line = record.position().map_or(0, csv::Position::line);
        if record.iter().all(str::is_empty) {
            continue;
        }
        let cell = |column: usize, name: &str| {
            let text = record.get(column).unwrap_or("");
            finite(text).map_err(|problem| wrong(line, format!("{name} is {text:?}; {problem}")))
        };
        let window = [cell(start, "start")?, cell(end, "end")?];
        if window[1] <= window[0] {
            return Err(wrong(line, format!("end is {} s, not after start, {} s", window[1], window[0])));
        }
        found.push(window);
    }
    if found.is_empty() {
        return Err(wrong(2, "there is no stroke; give one a line, or leave --strokes out".into()));
    }
    Ok(found)
}
