use std::borrow::Borrow;
use std::fmt::Write as _;
use std::io::Write;
use std::path::Path;

use crate::parquet_table::ParquetTable;
use crate::{Cell, ColumnsError, Kind};

/// Form of a table in a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// Text; numbers read back to the same bits.
    Csv,
    /// Parquet, compressed with Snappy.
    Parquet,
}

impl Form {
    /// The form that the ending of a file's name asks for, `.csv` or `.parquet`.
    #[must_use]
    pub fn of(path: &Path) -> Option<Self> {
        match path.extension()?.to_str()? {
            "csv" => Some(Self::Csv),
            "parquet" => Some(Self::Parquet),
            _ => None,
        }
    }
}

/// Writes a table, row by row.
pub struct TableWriter<W: Write + Send> {
    output: Output<W>,
    kinds: Vec<Kind>,
    rows: usize,
}

enum Output<W: Write + Send> {
    /// With the text of a cell, kept so that it is allocated once.
    Csv(Box<csv::Writer<W>>, String),
    Parquet(Box<ParquetTable<W>>),
}

impl<W: Write + Send> TableWriter<W> {
    /// Begins a table; `name` is that of the table within a Parquet file.
    ///
    /// # Errors
    /// [`ColumnsError`] if nothing can be written.
    pub fn new<N: AsRef<str>>(
        form: Form,
        output: W,
        name: &str,
        columns: impl IntoIterator<Item = (N, Kind)>,
    ) -> Result<Self, ColumnsError> {
        let (names, kinds): (Vec<N>, Vec<Kind>) = columns.into_iter().unzip();
        let names = names.iter().map(AsRef::as_ref);
        let output = match form {
            Form::Csv => {
                let mut writer = csv::Writer::from_writer(output);
                writer.write_record(names.map(str::as_bytes))?;
                Output::Csv(Box::new(writer), String::new())
            }
            Form::Parquet => Output::Parquet(Box::new(ParquetTable::new(output, name, names.zip(&kinds))?)),
        };
        Ok(Self { output, kinds, rows: 0 })
    }

    /// Goes on with a table in CSV of which the header is written elsewhere.
    #[must_use]
    pub fn continue_csv(output: W, kinds: impl IntoIterator<Item = Kind>) -> Self {
        let output = Output::Csv(Box::new(csv::Writer::from_writer(output)), String::new());
        Self { output, kinds: kinds.into_iter().collect(), rows: 0 }
    }

    /// Writes a row: a cell for each column, in their order.
    ///
    /// # Errors
    /// [`ColumnsError::Width`] if the row is too short or too long, [`ColumnsError::Cell`] if a cell is not of the kind of its
    /// column, others if it cannot be written.
    pub fn row<'c, C: Borrow<Cell<'c>>>(
        &mut self,
        cells: impl IntoIterator<Item = C>,
    ) -> Result<(), ColumnsError> {
        self.rows += 1;
        let mut found = 0;
        for cell in cells {
            let cell = cell.borrow();
            found += 1;
            let Some(&kind) = self.kinds.get(found - 1) else { continue };
            if !kind.takes(cell) {
                let found_text = cell.to_string();
                return Err(ColumnsError::Cell { row: self.rows, column: found, found: found_text, kind });
            }
            match &mut self.output {
                Output::Csv(writer, text) => {
                    text.clear();
                    // A String takes any text.
                    let _ = match (kind, cell) {
                        (Kind::Decimal, Cell::Float(value)) => write!(text, "{value:?}"),
                        _ => write!(text, "{cell}"),
                    };
                    writer.write_field(text.as_bytes())?;
                }
                Output::Parquet(table) => table.push(found - 1, cell),
            }
        }
        if found != self.kinds.len() {
            return Err(ColumnsError::Width { row: self.rows, found, expected: self.kinds.len() });
        }
        match &mut self.output {
            Output::Csv(writer, _) => Ok(writer.write_record(None::<&[u8]>)?),
            Output::Parquet(table) => Ok(table.end_row()?),
        }
    }

    /// Writes what waits, and gives the output back.
    ///
    /// # Errors
    /// [`ColumnsError`] if it cannot be written.
    pub fn finish(self) -> Result<W, ColumnsError> {
        match self.output {
            Output::Csv(writer, _) => {
                writer.into_inner().map_err(|problem| ColumnsError::Io(problem.into_error()))
            }
            Output::Parquet(table) => Ok(table.finish()?),
        }
    }
}
