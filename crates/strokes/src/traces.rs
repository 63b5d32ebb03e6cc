use std::collections::BTreeMap;
use std::fs::File;
use std::io::{Read, Write};
use std::iter::once;
use std::path::Path;

use soilctl_columns::{Cell, Columns, Kind, Range, TableWriter, columns};

use crate::cell::CellPlace;
use crate::read::{Records, required};
use crate::{StrokesError, header};

columns! {
    /// One sample of a recorded stroke. `None` means not recorded.
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    pub struct TraceSample {} columns {
        t_s: f64, "s", Range::Signed,
            "Time, on any clock; grows within a stroke", [diagnose], Logs;
        x_ext_m: f64, "m", Range::Signed,
            "Displacement along the stroke by the external encoders, without compensation", [diagnose], Logs;
        x_mtr_m: Option<f64>, "m", Range::Signed,
            "The same by the motors' encoders", [diagnose], Logs;
        force_n: f64, "N", Range::Signed,
            "Magnitude of the force in the plane of travel, tare removed", [diagnose], Logs;
        friction_angle_deg: Option<f64>, "deg", Range::Signed,
            "Inclination of the force to the plate's normal", [diagnose], Logs;
        z_m: Option<f64>, "m", Range::Signed,
            "Height of the plate's lower edge, up positive, from any datum", [diagnose], Logs;
    }
}

/// The column before those of [`TraceSample`].
const ID: &str = "stroke_id";

/// Traces of strokes, `traces.csv`, by the name of the stroke.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TraceTable {
    strokes: BTreeMap<String, Vec<TraceSample>>,
}

impl TraceTable {
    /// Reads `traces.csv`: a header, then one row a sample, those of a stroke in the order of time. The order of columns is
    /// free, and columns that are not known are left out.
    ///
    /// # Errors
    /// [`StrokesError`] with the line, the column, the offending text and what is allowed.
    pub fn read(path: &Path) -> Result<Self, StrokesError> {
        let name = path.display().to_string();
        let file = File::open(path).map_err(|problem| StrokesError::file(&name, &problem))?;
        Self::from_reader(file, &name)
    }

    /// As [`TraceTable::read`], from any reader; `name` stands for the file in messages.
    ///
    /// # Errors
    /// As [`TraceTable::read`].
    pub fn from_reader(input: impl Read, name: &str) -> Result<Self, StrokesError> {
        let needed = || once(ID).chain(required::<TraceSample>());
        let mut records = Records::new(input, name);
        let (line, first) = records.header(needed())?;
        let names = header::names(first, name, line)?;
        header::refuse_missing(&names, needed(), name)?;
        let known = |column: &str| column == ID || TraceSample::column(column).is_some();
        header::refuse_duplicates(&names, known, name, line)?;
        let place = |wanted: &str| names.iter().position(|name| *name == wanted);
        let id_place = place(ID).unwrap_or_default();
        let places: Vec<_> = TraceSample::COLUMNS
            .iter()
            .filter_map(|column| Some((column, place(column.about.name)?)))
            .collect();
        let mut strokes: BTreeMap<String, Vec<TraceSample>> = BTreeMap::new();
        while let Some(line) = records.row()? {
            let at = |column| CellPlace { file: name, line, column };
            let id = at(ID).text(records.cell(id_place))?.trim();
            if id.is_empty() {
                let allowed = "the stroke_id of the stroke table".into();
                return Err(StrokesError::EmptyCell { place: at(ID).owned(), allowed });
            }
            let mut sample = TraceSample::default();
            for (column, place) in &places {
                let value = at(column.about.name).number(records.cell(*place), &column.about, false)?;
                (column.set)(&mut sample, value.map_or(Cell::Missing, Cell::Float));
            }
            let Some(samples) = strokes.get_mut(id) else {
                strokes.insert(id.to_owned(), vec![sample]);
                continue;
            };
            if let Some(before) = samples.last().filter(|before| sample.t_s <= before.t_s) {
                return Err(StrokesError::OutOfRange {
                    place: at("t_s").owned(),
                    text: sample.t_s.to_string(),
                    allowed: format!("above the {} s of the sample before it in this stroke", before.t_s),
                });
            }
            samples.push(sample);
        }
        Ok(Self { strokes })
    }

    /// Traces made by a program, by name of the stroke, each in the order of time.
    #[must_use]
    pub const fn new(strokes: BTreeMap<String, Vec<TraceSample>>) -> Self {
        Self { strokes }
    }

    /// The first line of `traces.csv`.
    #[must_use]
    pub fn header() -> String {
        let names: Vec<&str> = TraceSample::COLUMNS.iter().map(|column| column.about.name).collect();
        format!("{ID},{}\n", names.join(","))
    }

    /// Writes samples of a stroke as lines of `traces.csv`, below [`TraceTable::header`].
    ///
    /// # Errors
    /// Whatever the writer says.
    pub fn write_lines(
        stroke_id: &str,
        samples: impl IntoIterator<Item = TraceSample>,
        output: impl Write + Send,
    ) -> std::io::Result<()> {
        let kinds = once(Kind::Text).chain(TraceSample::COLUMNS.iter().map(|column| column.about.kind));
        let mut lines = TableWriter::continue_csv(output, kinds);
        for sample in samples {
            let cells = TraceSample::COLUMNS.iter().map(|column| (column.get)(&sample));
            lines.row(once(Cell::Text(stroke_id.into())).chain(cells))?;
        }
        lines.finish()?.flush()
    }

    /// The samples of a stroke in the order of time; `None` if it has none.
    #[must_use]
    pub fn get(&self, stroke_id: &str) -> Option<&[TraceSample]> {
        self.strokes.get(stroke_id).map(Vec::as_slice)
    }

    /// Number of strokes.
    #[must_use]
    pub fn len(&self) -> usize {
        self.strokes.len()
    }

    /// Whether there is no stroke.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.strokes.is_empty()
    }
}
