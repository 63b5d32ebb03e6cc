use std::fmt::Write as _;
use std::io::Write;
use std::path::Path;

use crate::columns::Column;
use crate::{StrokeTable, StrokesError};

impl StrokeTable {
    /// Writes the table as csv, columns in the order in which they were read. Numbers are written so that they
    /// read back to the same bits.
    ///
    /// # Errors
    /// [`StrokesError::File`] if the file cannot be written.
    pub fn write(&self, path: &Path) -> Result<(), StrokesError> {
        let failed = |problem: String| StrokesError::File { file: path.display().to_string(), problem };
        let mut bytes = Vec::new();
        self.to_writer(&mut bytes)
            .and_then(|()| soilctl_jobs::write_atomically(path, &bytes))
            .map_err(|problem| failed(problem.to_string()))
    }

    /// As [`StrokeTable::write`], to any writer.
    ///
    /// # Errors
    /// Whatever the writer says.
    pub fn to_writer(&self, output: impl Write) -> std::io::Result<()> {
        let mut writer = csv::Writer::from_writer(output);
        for column in &self.columns {
            writer.write_field(column.name())?;
        }
        writer.write_record(None::<&[u8]>)?;
        let mut number = String::new();
        for i in 0..self.len() {
            for column in &self.columns {
                match column {
                    Column::Number(_, values) => {
                        number.clear();
                        if !values[i].is_nan() {
                            // The shortest digits that read back to the same bits; a String takes any text.
                            let _ = write!(number, "{}", values[i]);
                        }
                        writer.write_field(&number)?;
                    }
                    Column::Text(text) => writer.write_field(text.cell(i).unwrap_or_default())?,
                }
            }
            writer.write_record(None::<&[u8]>)?;
        }
        writer.flush()
    }
}
