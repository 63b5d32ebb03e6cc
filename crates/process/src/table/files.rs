use std::io::Write;

use soilctl_columns::{About, Cell, Columns, Form, Kind, TableWriter};
use soilctl_strokes::{StrokeRow, StrokeTable, TraceSample, TraceTable};

use super::{FailureRow, StrokeRecord};
use crate::ProcessError;
use crate::log::LogStroke;

/// Writes the stroke table. In CSV the columns that every verb knows come first, those of them that some stroke fills, and then
/// those of [`FailureRow`]; in Parquet there are all that logs tell, texts before numbers, which are null where nothing was
/// measured.
///
/// # Errors
/// [`ProcessError::Log`] if a value is outside the range of its column, without strokes, or if the writer fails.
pub fn write_table(
    form: Form,
    strokes: &[StrokeRecord],
    output: impl Write + Send,
) -> Result<(), ProcessError> {
    let failed = |error: &dyn std::fmt::Display| ProcessError::Log(format!("the stroke table: {error}"));
    match form {
        Form::Csv => {
            let (rows, found): (Vec<StrokeRow>, Vec<FailureRow>) =
                strokes.iter().map(|stroke| (stroke.row.clone(), stroke.failure.clone())).unzip();
            let table = StrokeTable::new("stroke table", &rows).map_err(|error| failed(&error))?;
            table.beside(&found).to_writer(output).map_err(|error| failed(&error))
        }
        Form::Parquet => {
            let pattern = StrokeRecord::default();
            let columns = cells(&pattern).into_iter().map(|(about, _)| match about.kind {
                Kind::Float => (about.name, Kind::OptionalFloat),
                kind => (about.name, kind),
            });
            let mut table =
                TableWriter::new(form, output, "strokes", columns).map_err(|error| failed(&error))?;
            for stroke in strokes {
                table.row(cells(stroke).into_iter().map(|(_, cell)| cell)).map_err(|error| failed(&error))?;
            }
            table.finish().map(|_| ()).map_err(|error| failed(&error))
        }
    }
}

/// What a stroke says in all columns that logs tell, texts first.
fn cells(stroke: &StrokeRecord) -> Vec<(&'static About, Cell<'_>)> {
    let row = StrokeRow::logged().map(|column| (&column.about, (column.get)(&stroke.row)));
    let found = FailureRow::COLUMNS.iter().map(|column| (&column.about, (column.get)(&stroke.failure)));
    let mut cells: Vec<_> = row.chain(found).collect();
    cells.sort_by_key(|(about, _)| about.kind != Kind::Text);
    cells
}

/// Writes a stroke's trace as lines of `traces.csv`, at most `rate_hz` samples a second, each as it was recorded.
///
/// Displacements are those of the two encoders without any compensation, so that stretch and free play can be seen; a
/// bag has only one, which then stands under `x_ext_m`.
///
/// # Errors
/// Whatever the writer says.
pub fn write_trace(
    stroke: &LogStroke,
    stroke_id: &str,
    rate_hz: f64,
    output: impl Write + Send,
) -> std::io::Result<()> {
    let trace = &stroke.evaluated.trace;
    let mut next_s = f64::NEG_INFINITY;
    let samples = trace.t_s().iter().enumerate().filter_map(|(i, &t_s)| {
        // Half a microsecond for what the sum of many steps is off.
        if t_s < next_s - 5e-7 {
            return None;
        }
        next_s = t_s.max(next_s) + 1.0 / rate_hz;
        let (x_ext_m, x_mtr_m) = match &stroke.course {
            Some(course) => (course.external_m[i], Some(course.motor_m[i])),
            None => (trace.displacement_m()[i], None),
        };
        Some(TraceSample {
            t_s,
            x_ext_m,
            x_mtr_m,
            force_n: trace.force_n()[i],
            friction_angle_deg: trace.channels().friction_angle_deg.as_ref().map(|values| values[i]),
            z_m: trace.channels().z_m.as_ref().map(|values| values[i]),
        })
    });
    TraceTable::write_lines(stroke_id, samples, output)
}
