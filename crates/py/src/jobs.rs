//! Stores of results; `python/soilctl/_store.py` makes a class of these.

use std::path::PathBuf;

use pyo3::prelude::*;
use soilctl_jobs::{Job, JobsError, Store};

use crate::error::{Answer, Fail, file, file_at};

/// The address of the result of a function of this name and version for a cell, given in canonical JSON.
#[pyfunction]
pub(crate) fn store_key(name: &str, version: &str, cell: &str) -> String {
    Job { function: name, version, cell }.key()
}

/// Where the result of a key is, and where its error is noted.
#[pyfunction]
pub(crate) fn store_paths(folder: PathBuf, key: &str) -> (PathBuf, PathBuf) {
    let store = Store::open(folder);
    (store.path(key), store.failure_path(key))
}

/// Whether there is a sound result of a key.
#[pyfunction]
pub(crate) fn store_has(py: Python<'_>, folder: PathBuf, key: &str) -> bool {
    py.detach(|| Store::open(folder).get(key)).is_ok()
}

/// The canonical JSON of the result of a key.
///
/// Raises:
///     FileError: If it is not there, or not what was written.
#[pyfunction]
pub(crate) fn store_read(py: Python<'_>, folder: PathBuf, key: &str) -> Answer<String> {
    Ok(py.detach(|| Store::open(folder).get(key))?)
}

/// Stores the canonical JSON of a result.
///
/// Raises:
///     FileError: If it cannot be written.
#[pyfunction]
pub(crate) fn store_publish(
    py: Python<'_>,
    folder: PathBuf,
    name: &str,
    version: &str,
    cell: &str,
    result: &str,
) -> Answer<()> {
    Ok(py.detach(|| Store::open(folder).put(&Job { function: name, version, cell }, result))?)
}

/// Notes the error of a cell.
///
/// Raises:
///     FileError: If it cannot be written.
#[pyfunction]
pub(crate) fn store_note_failure(
    py: Python<'_>,
    folder: PathBuf,
    name: &str,
    version: &str,
    cell: &str,
    error: &str,
) -> Answer<()> {
    Ok(py.detach(|| Store::open(folder).note_failure(&Job { function: name, version, cell }, error))?)
}

impl From<JobsError> for Fail {
    fn from(problem: JobsError) -> Self {
        match &problem {
            JobsError::File { path, .. } | JobsError::NoResult { path } | JobsError::Damaged { path } => {
                file_at(&problem, path)
            }
            _ => file(problem),
        }
    }
}
