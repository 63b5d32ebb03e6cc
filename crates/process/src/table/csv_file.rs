use std::io::Write;

use soilctl_strokes::StrokeTable;

use super::StrokeRecord;
use crate::ProcessError;

/// Writes the stroke table as `strokes.csv`: the columns that every verb knows, then those that only this one fills.
///
/// # Errors
/// [`ProcessError::Log`] if a value is outside the range of its column, without strokes, or if the writer fails.
pub fn write_csv(strokes: &[StrokeRecord], output: impl Write) -> Result<(), ProcessError> {
    let failed = |error: &dyn std::fmt::Display| ProcessError::Log(format!("the stroke table: {error}"));
    let rows: Vec<_> = strokes.iter().map(StrokeRecord::row).collect();
    let table = StrokeTable::new("stroke table", &rows).map_err(|error| failed(&error))?;
    let mut known = Vec::new();
    table.to_writer(&mut known).map_err(|error| failed(&error))?;
    let mut reader = csv::ReaderBuilder::new().has_headers(false).from_reader(known.as_slice());
    let mut writer = csv::Writer::from_writer(output);
    let numbers =
        ["failure_time_s", "turned_deg", "lift_deg", "lift_sd_deg", "two_lines_force_n", "mobilised"];
    let texts = ["method", "failure", "flags", "log"];
    for (line, record) in reader.records().enumerate() {
        let mut record = record.map_err(|error| failed(&error))?;
        match line.checked_sub(1).and_then(|place| strokes.get(place)) {
            None => numbers.iter().chain(&texts).for_each(|name| record.push_field(name)),
            Some(stroke) => {
                for wanted in numbers {
                    let value = stroke.numbers().into_iter().find(|(name, _)| *name == wanted);
                    let text = value.and_then(|(_, value)| value).map(|value| value.to_string());
                    record.push_field(&text.unwrap_or_default());
                }
                for wanted in texts {
                    let text = stroke.texts().into_iter().find(|(name, _)| *name == wanted);
                    record.push_field(text.map_or("", |(_, text)| text));
                }
            }
        }
        writer.write_record(&record).map_err(|error| failed(&error))?;
    }
    writer.flush().map_err(|error| failed(&error))
}
