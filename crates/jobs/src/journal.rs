//! What a run has done so far, in a file: a header, then one line a piece of work.

use std::fs::{File, OpenOptions};
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::{JobsError, write_atomically};

/// What the results of a run depend on.
pub trait Inputs {
    /// Each input as people know it, with its value; differences are told in this order.
    fn inputs(&self) -> Vec<(&'static str, String)>;

    /// Refuses to go on with the work of another run. `self` is what its journal at `path` says.
    ///
    /// # Errors
    /// [`JobsError::OtherRun`] names the first input that differs.
    fn same_as(&self, wanted: &Self, path: &Path) -> Result<(), JobsError> {
        for ((what, found), (_, wanted)) in self.inputs().into_iter().zip(wanted.inputs()) {
            if found != wanted {
                return Err(JobsError::OtherRun { path: path.to_owned(), what, found, wanted });
            }
        }
        Ok(())
    }
}

/// A journal that is open for adding. Once [`Journal::add`] returns, nothing loses the entry.
#[derive(Debug)]
pub struct Journal {
    path: PathBuf,
    file: File,
    /// Bytes of whole lines.
    length: u64,
}

impl Journal {
    /// Header and entries of a journal; none if there is none. A line that a kill cut or something else damaged is left out,
    /// so that its work is done again.
    ///
    /// # Errors
    /// [`JobsError::File`] if it cannot be read, [`JobsError::NoJournal`] if it begins with another header.
    pub fn read<H: DeserializeOwned, E: DeserializeOwned>(
        path: &Path,
    ) -> Result<Option<(H, Vec<E>)>, JobsError> {
        let bytes = match std::fs::read(path) {
            Err(problem) if problem.kind() == ErrorKind::NotFound => return Ok(None),
            read => read.map_err(JobsError::file(path))?,
        };
        let mut lines = bytes.split_inclusive(|byte| *byte == b'\n').filter(|line| line.ends_with(b"\n"));
        let Some(first) = lines.next() else { return Ok(None) };
        let header = serde_json::from_slice(first)
            .map_err(|problem| JobsError::NoJournal { path: path.to_owned(), problem })?;
        Ok(Some((header, lines.filter_map(|line| serde_json::from_slice(line).ok()).collect())))
    }

    /// Writes a whole journal in one go.
    ///
    /// # Errors
    /// [`JobsError::File`] if it cannot be written; the old one is as it was then.
    pub fn write<'a, H: Serialize, E: Serialize + 'a>(
        path: &Path,
        header: &H,
        entries: impl IntoIterator<Item = &'a E>,
    ) -> Result<(), JobsError> {
        let mut text = line(path, header)?;
        for entry in entries {
            text += &line(path, entry)?;
        }
        write_atomically(path, text.as_bytes()).map_err(JobsError::file(path))
    }

    /// Writes the journal anew with what is known, and leaves it open for more.
    ///
    /// # Errors
    /// Those of [`Journal::write`].
    pub fn begin<'a, H: Serialize, E: Serialize + 'a>(
        path: &Path,
        header: &H,
        known: impl IntoIterator<Item = &'a E>,
    ) -> Result<Self, JobsError> {
        Self::write(path, header, known)?;
        let open = || {
            let file = OpenOptions::new().append(true).open(path)?;
            let length = file.metadata()?.len();
            Ok::<_, std::io::Error>(Self { path: path.to_owned(), file, length })
        };
        open().map_err(JobsError::file(path))
    }

    /// Adds a piece of work that is done.
    ///
    /// # Errors
    /// [`JobsError::File`] if it cannot be written; the journal is as it was then.
    pub fn add(&mut self, entry: &impl Serialize) -> Result<(), JobsError> {
        let line = line(&self.path, entry)?;
        let written = self.file.write_all(line.as_bytes()).and_then(|()| self.file.sync_data());
        if written.is_ok() {
            self.length += line.len() as u64;
        } else {
            // The next entry must not go on in the middle of this line.
            let _ = self.file.set_len(self.length);
        }
        written.map_err(JobsError::file(&self.path))
    }
}

fn line(path: &Path, value: &impl Serialize) -> Result<String, JobsError> {
    Ok(serde_json::to_string(value).map_err(JobsError::file(path))? + "\n")
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;

    type Read = Option<(String, Vec<f64>)>;

    fn read(path: &Path) -> Read {
        Journal::read(path).unwrap()
    }

    #[test]
    fn a_cut_line_is_left_out_and_overwritten() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("j.jsonl");
        assert_eq!(read(&path), None);
        let mut journal = Journal::begin(&path, &"h", &[0.1 + 0.2]).unwrap();
        journal.add(&1e300).unwrap();
        assert_eq!(read(&path), Some(("h".into(), vec![0.1 + 0.2, 1e300])));
        let whole = std::fs::read(&path).unwrap();
        // However much of the last line is missing, the first entry stays.
        for cut in 1..6 {
            std::fs::write(&path, &whole[..whole.len() - cut]).unwrap();
            assert_eq!(read(&path), Some(("h".into(), vec![0.1 + 0.2])), "{cut}");
        }
        let mut journal = Journal::begin(&path, &"h", &read(&path).unwrap().1).unwrap();
        journal.add(&1e300).unwrap();
        assert_eq!(std::fs::read(&path).unwrap(), whole);
        // Not even the header was written: nothing is known.
        std::fs::write(&path, &whole[..2]).unwrap();
        assert_eq!(read(&path), None);
        assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 1);
    }

    #[test]
    fn damage_in_the_middle_costs_its_line_only() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("j.jsonl");
        std::fs::write(&path, b"\"h\"\n1.5\n\xff2.5\n3.5\n").unwrap();
        assert_eq!(read(&path), Some(("h".into(), vec![1.5, 3.5])));
        std::fs::write(&path, "something else\n").unwrap();
        let message = Journal::read::<String, f64>(&path).unwrap_err().to_string();
        assert!(message.contains("delete the file"), "{message}");
    }

    struct Run(u32);

    impl Inputs for Run {
        fn inputs(&self) -> Vec<(&'static str, String)> {
            vec![("format", "f/1".into()), ("seed", self.0.to_string())]
        }
    }

    #[test]
    fn another_run_is_refused_by_what_differs() {
        assert!(Run(3).same_as(&Run(3), Path::new("j")).is_ok());
        let message = Run(3).same_as(&Run(4), Path::new("j")).unwrap_err().to_string();
        assert!(message.contains("j is of a run with another seed (3; this one: 4)"), "{message}");
    }
}
