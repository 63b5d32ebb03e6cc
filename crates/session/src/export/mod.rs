//! Topics of a log as tables.

mod rows;

use std::fs::File;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use soilctl_columns::{Cell, ColumnsError, Form, TableWriter};
use soilctl_jobs::Beside;

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

/// A row of a table: the cells with the names of their columns.
pub type Row = [(String, Cell<'static>)];

/// Writes the messages of `topic` as a table: one row a message, first its log time in s, then its fields.
///
/// # Errors
/// Those of [`table_rows`], and [`SessionError::File`] if the table cannot be written. After an error there is no table, and
/// one that was there before is as it was.
pub fn export(path: &Path, topic: &str, out: &Path, form: Form) -> Result<Export, SessionError> {
    export_until(path, topic, out, form, &AtomicBool::new(false))
}

/// [`export`] that ends when `stop` is set; then there is no table.
///
/// # Errors
/// [`SessionError::Stopped`], and those of [`export`].
pub fn export_until(
    path: &Path,
    topic: &str,
    out: &Path,
    form: Form,
    stop: &AtomicBool,
) -> Result<Export, SessionError> {
    known(topic)?;
    let beside = Beside::new(out);
    let exported = write(path, topic, beside.path(), form, stop)?;
    beside.keep().map_err(|error| SessionError::file(out, &error))?;
    Ok(exported)
}

/// Shows the messages of `topic` to `visit` as rows of a table: first the log time in s, then the fields. All rows have the
/// same columns.
///
/// # Errors
/// [`SessionError::NoTable`] for another topic, [`SessionError::Missing`] if the log has none of its messages,
/// [`SessionError::Message`] for a malformed message, those of [`scan`], and what `visit` returns.
pub fn table_rows<E: From<SessionError>>(
    path: &Path,
    topic: &str,
    visit: &mut dyn FnMut(&Row) -> Result<(), E>,
) -> Result<Export, E> {
    known(topic)?;
    let (mut rows, mut columns) = (0, 0);
    let ending = scan(path, &mut |item| -> Result<(), E> {
        let Item::Message(message) = item else { return Ok(()) };
        if message.channel.topic != topic {
            return Ok(());
        }
        let bad = |reason| SessionError::Message { topic: topic.to_owned(), number: rows, reason };
        let row = rows::row(topic, message.log_time_ns, message.data).map_err(bad)?;
        if rows == 0 {
            columns = row.len();
        }
        if row.len() != columns {
            let reason = format!("it has {} numbers, the first message has {columns}", row.len());
            return Err(bad(reason).into());
        }
        rows += 1;
        visit(&row)
    })?;
    if rows == 0 {
        let missing = SessionError::Missing {
            file: path.display().to_string(),
            what: format!("messages on {topic}"),
            advice: "`soilctl log info` lists its topics",
        };
        return Err(missing.into());
    }
    Ok(Export { rows, columns, ending })
}

fn known(topic: &str) -> Result<(), SessionError> {
    if TABLES.contains(&topic) {
        return Ok(());
    }
    Err(SessionError::NoTable { topic: topic.to_owned(), known: TABLES.join(", ") })
}

fn write(
    path: &Path,
    topic: &str,
    out: &Path,
    form: Form,
    stop: &AtomicBool,
) -> Result<Export, SessionError> {
    let failed = |problem: ColumnsError| SessionError::file(out, &problem);
    let mut table: Option<TableWriter<File>> = None;
    let exported = table_rows(path, topic, &mut |row| -> Result<(), SessionError> {
        if stop.load(Ordering::Relaxed) {
            return Err(SessionError::Stopped);
        }
        let table = match &mut table {
            Some(table) => table,
            None => {
                let file = File::create(out).map_err(|problem| failed(problem.into()))?;
                let columns = row.iter().map(|(name, cell)| (name, cell.kind()));
                table.insert(TableWriter::new(form, file, "log", columns).map_err(failed)?)
            }
        };
        table.row(row.iter().map(|(_, cell)| cell)).map_err(failed)
    })?;
    // There is none only if there were no rows, which is an error already.
    table.map_or(Ok(()), |table| table.finish().map(|_| ()).map_err(failed))?;
    Ok(exported)
}
