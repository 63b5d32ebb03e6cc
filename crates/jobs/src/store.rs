//! A folder of results that any number of programs and machines fill at a time.

use std::path::{Path, PathBuf};

use serde::Deserialize;
use serde_json::Value;

use crate::canonical::sha256;
use crate::{JobsError, write_atomically};

/// Format of the files; also part of every address.
const FORMAT: &str = "soilctl.sweep/1";

/// What a result is the result of: a function of one version, applied to a cell.
#[derive(Debug, Clone, Copy)]
pub struct Job<'a> {
    /// Name of what computes it.
    pub function: &'a str,
    /// Of the function; another version has other results.
    pub version: &'a str,
    /// Its parameters in [canonical JSON](crate::canonical()).
    pub cell: &'a str,
}

impl Job<'_> {
    /// The address of the result: SHA-256 of the canonical JSON of all that the result depends on.
    #[must_use]
    pub fn key(&self) -> String {
        sha256(self.document([]).as_bytes())
    }

    /// The canonical JSON of the job and something more, which must be sorted as JSON sorts it.
    fn document<const N: usize>(&self, more: [(&str, &str); N]) -> String {
        let mut texts = vec![("format", FORMAT), ("function", self.function), ("version", self.version)];
        texts.extend(more);
        texts.sort_unstable();
        // The cell is JSON already, and `cell` comes before all others.
        let mut document = format!("{{\"cell\":{}", self.cell);
        for (name, text) in texts {
            document += &format!(",\"{name}\":{}", Value::from(text));
        }
        document + "}"
    }
}

/// What is read of a stored result; the rest is for people.
#[derive(Deserialize)]
struct Document {
    /// JSON of its own, so that its bytes can be checked.
    result: String,
    sha256: String,
}

/// A folder of results by what they are the result of. Results appear in one step and never change.
///
/// A result is in `results/ab/abcd….json`, where `abcd…` is [`Job::key`]. What failed is noted in `failed/`, for people, until
/// it succeeds.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Store {
    folder: PathBuf,
}

impl Store {
    /// The store in a folder, which is made with the first result.
    pub fn open(folder: impl Into<PathBuf>) -> Self {
        Self { folder: folder.into() }
    }

    /// Where the result of a key is, once it is there.
    #[must_use]
    pub fn path(&self, key: &str) -> PathBuf {
        self.folder.join("results").join(key.get(..2).unwrap_or(key)).join(format!("{key}.json"))
    }

    /// Where the error of a key is, if it failed last time.
    #[must_use]
    pub fn failure_path(&self, key: &str) -> PathBuf {
        self.folder.join("failed").join(format!("{key}.json"))
    }

    /// The result of a key, as it was put.
    ///
    /// # Errors
    /// [`JobsError::File`] if it cannot be read or is not there, [`JobsError::NoResult`] or [`JobsError::Damaged`] if it is not what
    /// was written.
    pub fn get(&self, key: &str) -> Result<String, JobsError> {
        let path = self.path(key);
        let bytes = std::fs::read(&path).map_err(JobsError::file(&path))?;
        match serde_json::from_slice::<Document>(&bytes) {
            Err(_) => Err(JobsError::NoResult { path }),
            Ok(found) if sha256(found.result.as_bytes()) != found.sha256 => Err(JobsError::Damaged { path }),
            Ok(found) => Ok(found.result),
        }
    }

    /// The result of a key if it is there and sound. One that is damaged counts as missing, and is made again.
    ///
    /// # Errors
    /// [`JobsError::File`] if it is there and cannot be read.
    pub fn known(&self, key: &str) -> Result<Option<String>, JobsError> {
        match self.get(key) {
            Ok(result) => Ok(Some(result)),
            Err(JobsError::NoResult { .. } | JobsError::Damaged { .. }) => Ok(None),
            Err(JobsError::File { problem, .. }) if problem.kind() == std::io::ErrorKind::NotFound => {
                Ok(None)
            }
            Err(problem) => Err(problem),
        }
    }

    /// Stores the result of a job, JSON, and forgets an earlier failure.
    ///
    /// # Errors
    /// [`JobsError::File`] if it cannot be written; then nothing of it is there.
    pub fn put(&self, job: &Job<'_>, result: &str) -> Result<(), JobsError> {
        let key = job.key();
        let document = job.document([("result", result), ("sha256", &sha256(result.as_bytes()))]);
        write(&self.path(&key), &document)?;
        let failure = self.failure_path(&key);
        match std::fs::remove_file(&failure) {
            Err(problem) if problem.kind() != std::io::ErrorKind::NotFound => {
                Err(JobsError::File { path: failure, problem })
            }
            _ => Ok(()),
        }
    }

    /// Keeps the error of a job, for people; it is no reason not to try again.
    ///
    /// # Errors
    /// [`JobsError::File`] if it cannot be written.
    pub fn note_failure(&self, job: &Job<'_>, error: &str) -> Result<(), JobsError> {
        write(&self.failure_path(&job.key()), &job.document([("error", error)]))
    }
}

fn write(path: &Path, document: &str) -> Result<(), JobsError> {
    let folder = path.parent().unwrap_or(Path::new("."));
    std::fs::create_dir_all(folder).map_err(JobsError::file(folder))?;
    write_atomically(path, format!("{document}\n").as_bytes()).map_err(JobsError::file(path))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;

    const JOB: Job<'_> = Job { function: "f", version: "1", cell: r#"{"x":1.0}"# };

    fn files(folder: &Path) -> usize {
        std::fs::read_dir(folder).map_or(0, Iterator::count)
    }

    /// The address and the bytes are those that Python's `hashlib` and `json.dumps` give.
    #[test]
    fn a_document_is_canonical() {
        let text = r#"{"cell":{"x":1.0},"format":"soilctl.sweep/1","function":"f","version":"1"}"#;
        assert_eq!(JOB.document([]), text);
        let parsed: Value =
            serde_json::from_str(&JOB.document([("result", "\"a\""), ("sha256", "b")])).unwrap();
        assert_eq!(JOB.document([("result", "\"a\""), ("sha256", "b")]), crate::canonical(&parsed).unwrap());
    }

    #[test]
    fn a_result_is_found_by_what_was_asked_and_by_nothing_else() {
        let dir = tempfile::tempdir().unwrap();
        let store = Store::open(dir.path());
        assert_eq!(store.known(&JOB.key()).unwrap(), None);
        store.note_failure(&JOB, "no memory").unwrap();
        assert_eq!(files(&dir.path().join("failed")), 1);
        store.put(&JOB, "[1,2]").unwrap();
        assert_eq!(files(&dir.path().join("failed")), 0);
        assert_eq!(store.get(&JOB.key()).unwrap(), "[1,2]");
        for other in
            [Job { function: "g", ..JOB }, Job { version: "2", ..JOB }, Job { cell: r#"{"x":1}"#, ..JOB }]
        {
            assert_eq!(store.known(&other.key()).unwrap(), None);
        }
    }

    #[test]
    fn a_damaged_result_is_missing() {
        let dir = tempfile::tempdir().unwrap();
        let store = Store::open(dir.path());
        store.put(&JOB, "\"none\"").unwrap();
        let path = store.path(&JOB.key());
        let text = std::fs::read_to_string(&path).unwrap();
        for damaged in [text.replace("none", "nine"), text[..text.len() / 2].to_owned(), String::new()] {
            std::fs::write(&path, damaged).unwrap();
            assert_eq!(store.known(&JOB.key()).unwrap(), None);
            assert!(store.get(&JOB.key()).unwrap_err().to_string().contains("made again"));
        }
        store.put(&JOB, "\"none\"").unwrap();
        assert_eq!(std::fs::read_to_string(&path).unwrap(), text);
        assert_eq!(files(path.parent().unwrap()), 1);
    }
}
