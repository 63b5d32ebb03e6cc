use std::collections::HashMap;
use std::fs::File;
use std::io::{Read, Write};
use std::path::Path;

use soilctl_columns::{Cell, Columns, ColumnsError, Form, TableWriter};

use crate::cell::{CellPlace, shortened};
use crate::read::{Records, required};
use crate::stored::Stored;
use crate::{StrokeRow, StrokesError, TextColumn, header};

/// What the reader lets pass.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct ReadOptions {
    /// Whether `force_sd_n` may be 0, as in data made by a model.
    pub allow_zero_sd: bool,
}

/// Strokes of a campaign, checked against the range of every column.
///
/// Kept by column, so that a column that is not there costs nothing.
#[derive(Debug, Clone)]
pub struct StrokeTable {
    name: String,
    lines: Vec<usize>,
    columns: Vec<Stored>,
}

impl StrokeTable {
    /// Reads `strokes.csv`: a header, then one row a stroke, in UTF-8 with or without a byte-order mark, lines
    /// ended by LF or CRLF. The order of columns is free; an empty cell means not measured.
    ///
    /// # Errors
    /// [`StrokesError`] with the line, the column, the offending text and what is allowed.
    pub fn read(path: &Path, options: ReadOptions) -> Result<Self, StrokesError> {
        let name = path.display().to_string();
        let file = File::open(path).map_err(|problem| StrokesError::file(&name, &problem))?;
        Self::from_reader(file, &name, options)
    }

    /// As [`StrokeTable::read`], from any reader; `name` stands for the file in messages.
    ///
    /// # Errors
    /// As [`StrokeTable::read`].
    pub fn from_reader(input: impl Read, name: &str, options: ReadOptions) -> Result<Self, StrokesError> {
        let mut records = Records::new(input, name);
        let (line, first) = records.header(required::<StrokeRow>())?;
        let names = header::names(first, name, line)?;
        header::refuse_missing(&names, required::<StrokeRow>(), name)?;
        header::refuse_duplicates(&names, |_| true, name, line)?;
        let columns = names.into_iter().map(Stored::new).collect();
        let mut table = Self { name: name.into(), lines: Vec::new(), columns };
        while let Some(line) = records.row()? {
            for (place, column) in table.columns.iter_mut().enumerate() {
                column.read(records.cell(place), name, line, options)?;
            }
            table.lines.push(line);
        }
        table.checked()
    }

    /// A table from rows made by a program. Lines become those that the rows will have in the file; only columns
    /// that some row fills are written. `force_sd_n` may be 0.
    ///
    /// # Errors
    /// [`StrokesError`] if there are no rows, if a value is outside the range of its column, or if two have one name.
    pub fn new(name: &str, rows: &[StrokeRow]) -> Result<Self, StrokesError> {
        let mut columns = Vec::new();
        for column in StrokeRow::COLUMNS {
            for (row, line) in rows.iter().zip(2..) {
                if let Some(value) = (column.get)(row).number() {
                    let place = CellPlace { file: name, line, column: column.about.name };
                    place.check(value, &value, &column.about, true)?;
                }
            }
            if rows.iter().any(|row| (column.get)(row) != Cell::Missing) {
                let mut stored = Stored::new(column.about.name);
                rows.iter().for_each(|row| stored.push(row));
                columns.push(stored);
            }
        }
        Self { name: name.into(), lines: (2..rows.len() + 2).collect(), columns }.checked()
    }

    /// Refuses a table without strokes, and one in which two strokes have one name.
    fn checked(self) -> Result<Self, StrokesError> {
        if self.lines.is_empty() {
            return Err(StrokesError::NoRows { file: self.name });
        }
        let mut lines = HashMap::new();
        let Some(ids) = self.stroke_ids() else { return Ok(self) };
        for (row, &line) in self.lines.iter().enumerate() {
            let Some(id) = ids.cell(row).filter(|id| !id.is_empty()) else { continue };
            if let Some(first) = lines.insert(id, line) {
                let (file, stroke_id) = (self.name.clone(), shortened(id));
                return Err(StrokesError::SameName { file, stroke_id, first, second: line });
            }
        }
        Ok(self)
    }

    /// The same table with more columns, those of the rows of another kind that belong to the same strokes, as text. All
    /// of them are written, also those that no row fills.
    #[must_use]
    pub fn beside<R: Columns>(mut self, rows: &[R]) -> Self {
        for column in R::COLUMNS {
            let mut texts = TextColumn::new(column.about.name);
            for place in 0..self.len() {
                texts.push(&rows.get(place).map_or(Cell::Missing, column.get).to_string());
            }
            self.columns.push(Stored::Texts(None, texts));
        }
        self
    }

    /// The same table with other numbers in a row, counted from 0, by the names of their columns, which are added where they are not there.
    ///
    /// # Errors
    /// [`StrokesError`] if a number is outside the range of its column. A name that is no column of numbers changes nothing, nor does a row that
    /// is not there.
    pub fn with_numbers(mut self, row: usize, numbers: &[(&str, f64)]) -> Result<Self, StrokesError> {
        for (name, value) in numbers {
            let Stored::Numbers(known, _) = Stored::new(name) else { continue };
            let Some(&line) = self.lines.get(row) else { continue };
            let place = CellPlace { file: &self.name, line, column: known.about.name };
            place.check(*value, value, &known.about, false)?;
            if !self.columns.iter().any(|column| column.name() == *name) {
                self.columns.push(Stored::Numbers(known, vec![f64::NAN; self.lines.len()]));
            }
            for column in &mut self.columns {
                if let Stored::Numbers(of, values) = column
                    && of.about.name == *name
                    && let Some(cell) = values.get_mut(row)
                {
                    *cell = *value;
                }
            }
        }
        Ok(self)
    }

    /// Writes the table as csv in one go, columns in the order in which they were read. Numbers are written so that they
    /// read back to the same bits.
    ///
    /// # Errors
    /// [`StrokesError::File`] if the file cannot be written.
    pub fn write(&self, path: &Path) -> Result<(), StrokesError> {
        let name = path.display().to_string();
        let mut bytes = Vec::new();
        self.write_csv(&mut bytes).map_err(|problem| StrokesError::file(&name, &problem))?;
        soilctl_jobs::write_atomically(path, &bytes).map_err(|problem| StrokesError::file(&name, &problem))
    }

    /// As [`StrokeTable::write`], to any writer.
    ///
    /// # Errors
    /// [`StrokesError::File`] with what the writer says.
    pub fn to_writer(&self, output: impl Write + Send) -> Result<(), StrokesError> {
        self.write_csv(output).map_err(|problem| StrokesError::file(&self.name, &problem))
    }

    fn write_csv(&self, output: impl Write + Send) -> Result<(), ColumnsError> {
        let columns = self.columns.iter().map(|column| (column.name(), column.kind()));
        let mut writer = TableWriter::new(Form::Csv, output, "strokes", columns)?;
        for row in 0..self.len() {
            writer.row(self.columns.iter().map(|column| column.cell(row)))?;
        }
        writer.finish()?.flush()?;
        Ok(())
    }

    /// Name of the file, for messages.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Number of strokes; at least 1.
    #[must_use]
    #[expect(clippy::len_without_is_empty, reason = "a table is never empty")]
    pub fn len(&self) -> usize {
        self.lines.len()
    }

    /// The strokes in the order of the file.
    pub fn rows(&self) -> impl ExactSizeIterator<Item = StrokeRow> + '_ {
        self.lines.iter().enumerate().map(|(row, &line)| {
            let mut stroke = StrokeRow { line, ..StrokeRow::default() };
            self.columns.iter().for_each(|column| column.put(row, &mut stroke));
            stroke
        })
    }

    /// Columns without a meaning here, kept to be written back.
    pub fn unknown_columns(&self) -> impl Iterator<Item = &TextColumn> {
        self.columns.iter().filter_map(|column| match column {
            Stored::Texts(None, texts) => Some(texts),
            Stored::Texts(Some(_), _) | Stored::Numbers(..) => None,
        })
    }

    /// The cells of a number column, NaN where nothing was measured; `None` if the table has no such column.
    pub(crate) fn numbers(&self, name: &str) -> Option<&[f64]> {
        self.columns.iter().find_map(|column| match column {
            Stored::Numbers(known, values) if known.about.name == name => Some(values.as_slice()),
            Stored::Numbers(..) | Stored::Texts(..) => None,
        })
    }

    /// The column of stroke names.
    pub(crate) fn stroke_ids(&self) -> Option<&TextColumn> {
        self.columns.iter().find_map(|column| match column {
            Stored::Texts(Some(known), texts) if known.about.name == "stroke_id" => Some(texts),
            Stored::Numbers(..) | Stored::Texts(..) => None,
        })
    }

    /// The line of each stroke.
    pub(crate) fn lines(&self) -> &[usize] {
        &self.lines
    }
}
