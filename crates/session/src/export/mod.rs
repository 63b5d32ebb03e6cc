//! Topics of a log as tables.

mod csv_file;
mod parquet_file;
mod rows;

use std::path::{Path, PathBuf};

use crate::fields::Cell;
use crate::read::{Ending, Item, scan};
use crate::{SessionError, topics};

/// Topics that can be exported.
pub const TABLES: [&str; 6] = [
    topics::STEP,
    topics::JOINT_STATES,
    topics::MOTOR_STATES,
    topics::WRENCH,
    topics::TRUE_JOINTS,
    topics::TRUE_SOIL,
];

/// Form of a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TableForm {
    /// Text; numbers read back to the same bits.
    Csv,
    /// Parquet, compressed with Snappy.
    Parquet,
}

/// What was exported.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Export {
    /// Rows: messages of the topic.
    pub rows: u64,
    /// Columns.
    pub columns: usize,
    /// How the reading of the log ended.
    pub ending: Ending,
}

/// Something that takes rows, all of the same columns.
trait Table {
    fn row(&mut self, row: &[(String, Cell)]) -> Result<(), SessionError>;
    fn finish(self: Box<Self>) -> Result<(), SessionError>;
}

/// Writes the messages of `topic` as a table: one row a message, first its log time in s, then its fields.
///
/// # Errors
/// [`SessionError::NoTable`] for another topic, [`SessionError::Missing`] if the log has none of its messages,
/// [`SessionError::Message`] for a malformed message, [`SessionError::File`] if the table cannot be written, and those
/// of [`scan`]. After an error there is no table, and one that was there before is as it was.
pub fn export(path: &Path, topic: &str, out: &Path, form: TableForm) -> Result<Export, SessionError> {
    if !TABLES.contains(&topic) {
        return Err(SessionError::NoTable { topic: topic.to_owned(), known: TABLES.join(", ") });
    }
    let beside = Beside::new(out);
    let exported = write(path, topic, &beside.path, form)?;
    beside.keep()?;
    Ok(exported)
}

fn write(path: &Path, topic: &str, out: &Path, form: TableForm) -> Result<Export, SessionError> {
    let mut table: Option<Box<dyn Table>> = None;
    let (mut rows, mut columns) = (0, 0);
    let ending = scan(path, &mut |item| {
        let Item::Message(message) = item else { return Ok(()) };
        if message.channel.topic != topic {
            return Ok(());
        }
        let bad = |reason| SessionError::Message { topic: topic.to_owned(), number: rows, reason };
        let row = rows::row(topic, message.log_time_ns, message.data).map_err(bad)?;
        if table.is_none() {
            columns = row.len();
            table = Some(match form {
                TableForm::Csv => Box::new(csv_file::CsvTable::create(out, &row)?),
                TableForm::Parquet => Box::new(parquet_file::ParquetTable::create(out, &row)?),
            });
        }
        if row.len() != columns {
            return Err(bad(format!("it has {} numbers, the first message has {columns}", row.len())));
        }
        rows += 1;
        table.as_mut().map_or(Ok(()), |table| table.row(&row))
    })?;
    match table {
        Some(table) => table.finish()?,
        None => {
            return Err(SessionError::Missing {
                file: path.display().to_string(),
                what: format!("messages on {topic}"),
                advice: "`soilctl log info` lists its topics",
            });
        }
    }
    Ok(Export { rows, columns, ending })
}

/// A file in the making beside the one that it becomes; it goes away unless it is kept.
struct Beside<'a> {
    path: PathBuf,
    out: &'a Path,
}

impl<'a> Beside<'a> {
    /// A device or pipe is written to as it is.
    fn new(out: &'a Path) -> Self {
        let special = out.metadata().is_ok_and(|found| !found.is_file());
        let mut name = out.as_os_str().to_owned();
        if !special {
            name.push(".part");
        }
        Self { path: name.into(), out }
    }

    fn keep(&self) -> Result<(), SessionError> {
        if self.path == self.out {
            return Ok(());
        }
        std::fs::rename(&self.path, self.out).map_err(|error| SessionError::file(self.out, &error))
    }
}

impl Drop for Beside<'_> {
    fn drop(&mut self) {
        if self.path != self.out {
            // After `keep` there is nothing left to remove.
            let _ = std::fs::remove_file(&self.path);
        }
    }
}
