use std::path::Path;

use soilctl_strokes::{StrokeTable, StrokesError, TraceTable};

use super::{Course, courses};
use crate::Data;

/// Traces beside a stroke table.
#[derive(Debug, Clone)]
pub struct RecordedTraces {
    table: TraceTable,
    /// When the soil failed on the clock of the traces, by stroke, where the table says it.
    failure_time_s: Vec<Option<f64>>,
}

/// What traces have added to the data of a campaign.
#[derive(Debug, Clone)]
pub struct AddedTraces {
    /// Strokes whose trace was used.
    pub used: usize,
    /// Courses of the force, by stroke.
    pub courses: Vec<Option<Course>>,
}

impl RecordedTraces {
    /// Reads traces of the strokes of a table.
    ///
    /// # Errors
    /// [`StrokesError`] if the file cannot be read or makes no sense.
    pub fn read(path: &Path, strokes: &StrokeTable) -> Result<Self, StrokesError> {
        let table = TraceTable::read(path)?;
        let column = strokes.unknown_columns().find(|column| column.name() == "failure_time_s");
        let time = |i: usize| {
            let text = column?.cell(i)?.trim();
            text.parse().ok().filter(|value: &f64| value.is_finite())
        };
        Ok(Self { table, failure_time_s: (0..strokes.len()).map(time).collect() })
    }

    /// Puts what the traces say into the data.
    #[must_use]
    pub fn add_to(&self, data: &mut Data) -> AddedTraces {
        let used = data.add_traces(&self.table, &self.failure_time_s);
        AddedTraces { used, courses: courses(&data.rows, &self.table, &self.failure_time_s) }
    }
}
