//! Traces beside a stroke table.

use std::path::Path;

use soilctl_diagnosis::{Course, Data, courses};
use soilctl_strokes::{StrokeTable, TraceTable};

use crate::error::CliError;

/// Traces of a campaign.
pub(super) struct Recorded {
    table: TraceTable,
    /// When the soil failed on the clock of the traces, by stroke, where the table says it.
    failure_time_s: Vec<Option<f64>>,
    /// Strokes whose trace was used.
    pub(super) used: usize,
    /// Courses of the force, by stroke.
    pub(super) courses: Vec<Option<Course>>,
}

impl Recorded {
    /// Reads the traces that are named, or those in the folder; `None` if there are none.
    pub(super) fn read(
        named: Option<&Path>,
        dir: &Path,
        strokes: &StrokeTable,
    ) -> Result<Option<Self>, CliError> {
        let beside = dir.join("traces.csv");
        let path = match named {
            Some(path) => path,
            None if beside.is_file() => &beside,
            None => return Ok(None),
        };
        let table = TraceTable::read(path)?;
        let column = strokes.unknown_columns().find(|column| column.name() == "failure_time_s");
        let time = |i: usize| {
            let text = column?.cell(i)?.trim();
            text.parse().ok().filter(|value: &f64| value.is_finite())
        };
        let failure_time_s = (0..strokes.len()).map(time).collect();
        Ok(Some(Self { table, failure_time_s, used: 0, courses: Vec::new() }))
    }

    /// Puts what the traces say into the data.
    pub(super) fn added(mut self, data: &mut Data) -> Self {
        self.used = data.add_traces(&self.table, &self.failure_time_s);
        self.courses = courses(&data.rows, &self.table, &self.failure_time_s);
        self
    }
}
