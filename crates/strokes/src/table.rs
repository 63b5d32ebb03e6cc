use std::fs::File;
use std::io::Read;
use std::path::Path;

use crate::cell::CellPlace;
use crate::columns::{Column, NUMBERS, TEXTS};
use crate::read::read_columns;
use crate::{ReadOptions, StrokeRow, StrokesError, TextColumn};

/// Strokes of a campaign, checked against the range of every column.
///
/// Kept by column, so that a column that is not there costs nothing.
#[derive(Debug, Clone)]
pub struct StrokeTable {
    name: String,
    lines: Vec<usize>,
    pub(crate) columns: Vec<Column>,
}

impl StrokeTable {
    /// Reads `strokes.csv`: a header, then one row a stroke, in UTF-8 with or without a byte-order mark, lines
    /// ended by LF or CRLF. The order of columns is free; an empty cell means not measured.
    ///
    /// # Errors
    /// [`StrokesError`] with the line, the column, the offending text and what is allowed.
    pub fn read(path: &Path, options: ReadOptions) -> Result<Self, StrokesError> {
        let name = path.display().to_string();
        let file = File::open(path)
            .map_err(|problem| StrokesError::File { file: name.clone(), problem: problem.to_string() })?;
        Self::from_reader(file, &name, options)
    }

    /// As [`StrokeTable::read`], from any reader; `name` stands for the file in messages.
    ///
    /// # Errors
    /// As [`StrokeTable::read`].
    pub fn from_reader(input: impl Read, name: &str, options: ReadOptions) -> Result<Self, StrokesError> {
        let (columns, lines) = read_columns(input, name, options)?;
        Ok(Self { name: name.into(), lines, columns })
    }

    /// A table from rows made by a program. Lines become those that the rows will have in the file; only columns
    /// that some row fills are written. `force_sd_n` may be 0.
    ///
    /// # Errors
    /// [`StrokesError::NoRows`] without rows, [`StrokesError::OutOfRange`] if a value is outside the range of its
    /// column or not finite, [`StrokesError::ZeroUncertainty`] if `force_sd_n` is negative.
    pub fn new(name: &str, rows: &[StrokeRow]) -> Result<Self, StrokesError> {
        if rows.is_empty() {
            return Err(StrokesError::NoRows { file: name.into() });
        }
        let lines: Vec<usize> = (2..rows.len() + 2).collect();
        let mut columns = Vec::new();
        for text_name in TEXTS {
            if rows.iter().any(|row| row.text(text_name).is_some()) {
                let mut column = TextColumn::new(text_name);
                rows.iter().for_each(|row| column.push(row.text(text_name).unwrap_or_default()));
                columns.push(Column::Text(column));
            }
        }
        for (index, column) in NUMBERS.iter().enumerate() {
            let cells: Vec<Option<f64>> = rows.iter().map(column.get).collect();
            for (value, &line) in cells.iter().zip(&lines) {
                if let Some(value) = value {
                    let place = CellPlace { file: name, line, column: column.name };
                    place.check(*value, &value.to_string(), index, true)?;
                }
            }
            if cells.iter().any(Option::is_some) {
                let values = cells.into_iter().map(|value| value.unwrap_or(f64::NAN)).collect();
                columns.push(Column::Number(index, values));
            }
        }
        Ok(Self { name: name.into(), lines, columns })
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
        (0..self.len()).map(|i| self.row(i))
    }

    /// Columns without a meaning here, kept to be written back.
    pub fn unknown_columns(&self) -> impl Iterator<Item = &TextColumn> {
        self.texts().filter(|column| !TEXTS.contains(&column.name()))
    }

    /// The cells of a number column, NaN where nothing was measured; `None` if the table has no such column.
    pub(crate) fn numbers(&self, name: &str) -> Option<&[f64]> {
        self.columns.iter().find_map(|column| match column {
            Column::Number(index, values) if NUMBERS[*index].name == name => Some(values.as_slice()),
            _ => None,
        })
    }

    /// The column of stroke names.
    pub(crate) fn stroke_ids(&self) -> Option<&TextColumn> {
        self.texts().find(|column| column.name() == "stroke_id")
    }

    /// The line of each stroke.
    pub(crate) fn lines(&self) -> &[usize] {
        &self.lines
    }

    fn texts(&self) -> impl Iterator<Item = &TextColumn> {
        self.columns.iter().filter_map(|column| match column {
            Column::Text(text) => Some(text),
            Column::Number(..) => None,
        })
    }

    fn row(&self, i: usize) -> StrokeRow {
        let mut row = StrokeRow { line: self.lines[i], ..StrokeRow::default() };
        for column in &self.columns {
            match column {
                Column::Number(index, values) if !values[i].is_nan() => {
                    (NUMBERS[*index].set)(&mut row, values[i]);
                }
                Column::Number(..) => {}
                Column::Text(column) => {
                    row.set_text(column.name(), column.cell(i).filter(|text| !text.is_empty()));
                }
            }
        }
        row
    }
}
