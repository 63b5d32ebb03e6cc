use std::fs::File;
use std::path::{Path, PathBuf};

use csv::Writer;

use super::Table;
use crate::SessionError;
use crate::fields::Cell;

/// A table as text.
pub(super) struct CsvTable {
    path: PathBuf,
    file: Writer<File>,
}

impl CsvTable {
    pub(super) fn create(path: &Path, first: &[(String, Cell)]) -> Result<Self, SessionError> {
        let failed = |error: csv::Error| SessionError::file(path, &error);
        let mut file = Writer::from_path(path).map_err(failed)?;
        file.write_record(first.iter().map(|(name, _)| name)).map_err(failed)?;
        Ok(Self { path: path.to_owned(), file })
    }
}

impl Table for CsvTable {
    fn row(&mut self, row: &[(String, Cell)]) -> Result<(), SessionError> {
        self.file
            .write_record(row.iter().map(|(_, cell)| cell.to_string()))
            .map_err(|error| SessionError::file(&self.path, &error))
    }

    fn finish(mut self: Box<Self>) -> Result<(), SessionError> {
        self.file.flush().map_err(|error| SessionError::file(&self.path, &error))
    }
}
