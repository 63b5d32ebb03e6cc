//! Logs: what is in them, and saving what can be saved.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use soilctl_bag::BagError;
use soilctl_columns::Kind;
use soilctl_motion::{Inspection, MotionError, inspect, table};
use soilctl_session::{Cell, SessionError, info_until, is_own, recover_until, table_rows};

use crate::array::shaped;
use crate::error::{Answer, Fail, file, file_at, input, no_answer};
use crate::interruptible::stoppable;

/// Columns of a table, each of one type.
enum Column {
    Floats(Vec<f64>),
    Integers(Vec<i64>),
    Flags(Vec<bool>),
    Texts(Vec<String>),
}

impl Column {
    /// An empty column for cells like this one.
    const fn like(cell: &Cell) -> Self {
        match cell {
            Cell::Float(_) => Self::Floats(Vec::new()),
            Cell::Integer(_) => Self::Integers(Vec::new()),
            Cell::Flag(_) => Self::Flags(Vec::new()),
            Cell::Text(_) | Cell::Missing => Self::Texts(Vec::new()),
        }
    }

    /// An empty column of a kind.
    const fn of(kind: Kind) -> Self {
        match kind {
            Kind::Float | Kind::Decimal | Kind::OptionalFloat | Kind::OptionalWhole => {
                Self::Floats(Vec::new())
            }
            Kind::Integer => Self::Integers(Vec::new()),
            Kind::Flag => Self::Flags(Vec::new()),
            Kind::Text => Self::Texts(Vec::new()),
        }
    }

    /// Whether the cell was of the column's type.
    fn push(&mut self, cell: &Cell) -> bool {
        match (self, cell) {
            (Self::Floats(column), &Cell::Float(value)) => column.push(value),
            (Self::Integers(column), &Cell::Integer(value)) => {
                let Ok(value) = i64::try_from(value) else { return false };
                column.push(value);
            }
            (Self::Flags(column), &Cell::Flag(value)) => column.push(value),
            (Self::Texts(column), Cell::Text(value)) => column.push(value.to_string()),
            _ => return false,
        }
        true
    }

    fn into_python(self, py: Python<'_>) -> Answer<Bound<'_, PyAny>> {
        match self {
            Self::Floats(values) => {
                let count = values.len();
                shaped(py, values, &[count])
            }
            Self::Integers(values) => Ok(PyArray1::from_vec(py, values).into_any()),
            Self::Flags(values) => Ok(PyArray1::from_vec(py, values).into_any()),
            Self::Texts(values) => Ok(PyList::new(py, values)?.into_any()),
        }
    }
}

/// The messages of a topic as a table, a row a message.
///
/// Args:
///     path: The log (.mcap), or a recording of any program (.mcap, .db3, .bag, or the folder of a bag).
///     topic: ``/controller/step``, ``/joint_states``, ``/motor_states``, ``/wrench``, ``/truth/joint_states`` or
///         ``/truth/soil``; of another program's recording any topic.
///
/// Returns:
///     A dict of columns by name, in order: first ``time_s``, the log time in s, then the fields of the message; elements of
///     arrays have columns of their own (``motor_counts_0`` ...). Numbers and flags are arrays of shape (n,), texts lists.
///     ``pandas.DataFrame`` takes it as it is. Of a damaged log, what can be read: ``log_info`` tells the damage. Times of another
///     program's recording count from its ``clock_origin_s`` in ``log_info``, as those of ``process``; what a message does not have
///     is NaN or an empty text.
///
/// Raises:
///     FileError: If it cannot be read, or is no log.
///     InputError: If there is no such table.
///     NoAnswerError: If the log has no message of the topic.
#[pyfunction]
#[pyo3(signature = (path, topic = "/controller/step"))]
pub(crate) fn log_table<'py>(py: Python<'py>, path: PathBuf, topic: &str) -> Answer<Bound<'py, PyDict>> {
    let table = stoppable(py, |stop| -> Answer<_> {
        if is_own(&path, stop) || !path.exists() {
            Ok(read_table(&path, topic, stop)?)
        } else {
            Ok(foreign_table(&path, topic, stop)?)
        }
    })?;
    let dict = PyDict::new(py);
    for (name, column) in table {
        dict.set_item(name, column.into_python(py)?)?;
    }
    Ok(dict)
}

fn read_table(path: &Path, topic: &str, stop: &AtomicBool) -> Result<Vec<(String, Column)>, SessionError> {
    let mut table: Vec<(String, Column)> = Vec::new();
    let mut number = 0;
    table_rows(path, topic, &mut |row| {
        if stop.load(Ordering::Relaxed) {
            return Err(SessionError::Stopped);
        }
        if table.is_empty() {
            table = row.iter().map(|(name, cell)| (name.clone(), Column::like(cell))).collect();
        }
        for ((name, column), (_, cell)) in table.iter_mut().zip(row) {
            if !column.push(cell) {
                let reason = format!("{name} is {cell}, which is no value like those before");
                return Err(SessionError::Message { topic: topic.to_owned(), number, reason });
            }
        }
        number += 1;
        Ok(())
    })?;
    Ok(table)
}

/// A topic of another program's recording.
fn foreign_table(path: &Path, topic: &str, stop: &AtomicBool) -> Result<Vec<(String, Column)>, MotionError> {
    let columns = std::cell::RefCell::new(Vec::new());
    table(
        path,
        topic,
        stop,
        &mut |header| {
            *columns.borrow_mut() =
                header.iter().map(|(name, kind)| (name.clone(), Column::of(*kind))).collect::<Vec<_>>();
            Ok(())
        },
        &mut |row| {
            for ((name, column), cell) in columns.borrow_mut().iter_mut().zip(row) {
                let taken = match cell {
                    Cell::Missing => column.push(&Cell::Text("".into())),
                    cell => column.push(cell),
                };
                if !taken {
                    let reason =
                        format!("{name} is {cell}, which does not fit into an array of 64-bit integers");
                    return Err(MotionError::Unreadable { topic: topic.to_owned(), reason });
                }
            }
            Ok(())
        },
    )?;
    Ok(columns.into_inner())
}

/// What is in a log, or in a recording of any program (.mcap, .db3, .bag, or the folder of a bag): topics, times, strokes, problems.
/// Ctrl-C ends the reading.
///
/// Returns:
///     A dict with ``topics`` (messages and type by name), ``start_ns``, ``end_ns``, ``steps``, ``missing_steps``,
///     ``keyframes``, ``session``, ``strokes``, ``attachments``, ``problems`` and ``damage``. Of another program's recording
///     ``problems`` are gaps, clocks and units; topics also have ``kind``, ``start_s``, ``end_s``, ``rate_hz``, ``gaps`` and
///     ``longest_gaps``, and there are ``container``, ``compression``, ``clock_origin_s``, from which times in s count, and ``has_urdf``.
///
/// Raises:
///     FileError: If it cannot be read, or is no log.
#[pyfunction]
pub(crate) fn log_info(py: Python<'_>, path: PathBuf) -> Answer<Bound<'_, PyDict>> {
    let found = stoppable(py, |stop| -> Answer<_> {
        if is_own(&path, stop) || !path.exists() {
            Ok(Ok(info_until(&path, stop)?))
        } else {
            Ok(Err(inspect(&path, stop)?))
        }
    })?;
    let found = match found {
        Ok(own) => own,
        Err(foreign) => return foreign_info(py, &foreign),
    };
    let topics = PyDict::new(py);
    for (name, topic) in &found.topics {
        let entry = PyDict::new(py);
        entry.set_item("type", &topic.message_type)?;
        entry.set_item("messages", topic.messages)?;
        topics.set_item(name, entry)?;
    }
    let dict = PyDict::new(py);
    dict.set_item("topics", topics)?;
    dict.set_item("start_ns", found.start_ns)?;
    dict.set_item("end_ns", found.end_ns)?;
    dict.set_item("steps", found.steps)?;
    dict.set_item("missing_steps", found.missing_steps)?;
    dict.set_item("keyframes", found.keyframes)?;
    dict.set_item("session", found.session)?;
    dict.set_item("strokes", found.strokes)?;
    dict.set_item("attachments", found.attachments)?;
    dict.set_item("problems", found.problems)?;
    dict.set_item("damage", found.ending.damage)?;
    Ok(dict)
}

fn foreign_info<'py>(py: Python<'py>, found: &Inspection) -> Answer<Bound<'py, PyDict>> {
    let topics = PyDict::new(py);
    for (name, topic) in &found.topics {
        let entry = PyDict::new(py);
        entry.set_item("type", &topic.message_type)?;
        entry.set_item("messages", topic.messages)?;
        entry.set_item("kind", topic.kind.map(soilctl_bag::Kind::word))?;
        entry.set_item("start_s", topic.span_s[0])?;
        entry.set_item("end_s", topic.span_s[1])?;
        entry.set_item("rate_hz", topic.rate_hz)?;
        entry.set_item("gaps", topic.gaps)?;
        entry.set_item("longest_gaps", &topic.longest_gaps)?;
        entry.set_item("problem", &topic.problem)?;
        topics.set_item(name, entry)?;
    }
    let dict = PyDict::new(py);
    let [start_ns, end_ns] = found.span_s.map(|t_s| found.clock.ns(t_s));
    dict.set_item("topics", topics)?;
    dict.set_item("start_ns", start_ns)?;
    dict.set_item("end_ns", end_ns)?;
    for zero in ["steps", "missing_steps", "keyframes"] {
        dict.set_item(zero, 0)?;
    }
    dict.set_item("session", PyDict::new(py))?;
    dict.set_item("strokes", PyList::empty(py))?;
    dict.set_item("attachments", &found.attachments)?;
    dict.set_item("problems", found.problems())?;
    dict.set_item("damage", &found.ending.damage)?;
    dict.set_item("container", found.container.to_string())?;
    dict.set_item("compression", found.ending.compressions.iter().collect::<Vec<_>>())?;
    dict.set_item("clock_origin_s", found.clock.origin_s)?;
    dict.set_item("has_urdf", found.has_urdf)?;
    Ok(dict)
}

/// Copies what can be read of a damaged log into a new, whole one. After Ctrl-C there is no new one.
///
/// Returns:
///     A dict with ``messages`` and ``steps`` that were saved, and ``damage``, empty if nothing is lost.
///
/// Raises:
///     FileError: If nothing can be read, or the new file cannot be written.
///     InputError: If both names are of the same file.
#[pyfunction]
#[pyo3(signature = (path, *, out))]
pub(crate) fn log_recover(py: Python<'_>, path: PathBuf, out: PathBuf) -> Answer<Bound<'_, PyDict>> {
    if let (Ok(from), Ok(to)) = (path.canonicalize(), out.canonicalize())
        && from == to
    {
        return Err(input(format!("out is {}, the log itself; give another name", out.display())));
    }
    let saved = stoppable(py, |stop| recover_until(&path, &out, stop))?;
    let dict = PyDict::new(py);
    dict.set_item("messages", saved.messages)?;
    dict.set_item("steps", saved.steps)?;
    dict.set_item("damage", saved.ending.damage)?;
    Ok(dict)
}

impl From<SessionError> for Fail {
    fn from(problem: SessionError) -> Self {
        match problem {
            SessionError::File { ref path, .. } => file_at(&problem, path),
            SessionError::Write { .. } | SessionError::NotALog { .. } => file(problem),
            SessionError::Missing { .. } | SessionError::NoKeyframe { .. } => no_answer(problem),
            _ => input(problem),
        }
    }
}

impl From<MotionError> for Fail {
    fn from(problem: MotionError) -> Self {
        match problem {
            MotionError::Bag(
                BagError::File { .. } | BagError::NotARecording { .. } | BagError::TooLarge { .. },
            )
            | MotionError::Write { .. } => file(problem),
            MotionError::Empty | MotionError::Unreadable { .. } => no_answer(problem),
            _ => input(problem),
        }
    }
}
