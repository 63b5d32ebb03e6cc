//! The problem file that was given at the start: the only one that is ever read or written.

use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use soilctl_jobs::write_atomically;
use soilctl_limit_analysis::{Description, DescriptionError};

use crate::WorkbenchError;

/// Longest file in bytes, as of `soilctl solve`.
const MOST_BYTES: u64 = 1 << 20;

/// What the file is written in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Format {
    Toml,
    Json,
}

/// The file, and what it held when it was last read or written here.
#[derive(Debug)]
pub(crate) struct ProblemFile {
    path: PathBuf,
    format: Format,
    seen: Mutex<Seen>,
}

/// What the file held.
#[derive(Debug, PartialEq)]
enum Seen {
    /// There was no file.
    Nothing,
    /// A problem.
    Problem(String),
    /// Something else, which somebody may want to keep.
    Strange(String),
}

impl Seen {
    fn new(text: Option<String>, format: Format) -> Self {
        match text {
            None => Self::Nothing,
            Some(text) if format.read(&text).is_ok() => Self::Problem(text),
            Some(text) => Self::Strange(text),
        }
    }
}

impl Format {
    fn read(self, text: &str) -> Result<Description, DescriptionError> {
        match self {
            Self::Toml => Description::from_toml(text),
            Self::Json => Description::from_json(text),
        }
    }
}

impl ProblemFile {
    /// Takes a file that is there, or one that is still to be made.
    pub(crate) fn open(path: &Path) -> Result<Self, WorkbenchError> {
        let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
        let format = match ending.to_ascii_lowercase().as_str() {
            "toml" => Format::Toml,
            "json" => Format::Json,
            _ => return Err(WorkbenchError::Ending { path: path.to_owned() }),
        };
        // From here on the working directory does not matter.
        let path = std::path::absolute(path)
            .map_err(|e| WorkbenchError::Read { path: path.to_owned(), message: e.to_string() })?;
        let folder = path.parent().unwrap_or(Path::new("."));
        if !folder.is_dir() {
            let message = "there is no such folder; make it first".to_owned();
            return Err(WorkbenchError::Read { path, message });
        }
        let seen = Mutex::new(Seen::new(read(&path)?, format));
        Ok(Self { path, format, seen })
    }

    /// Its name without folders, which are no business of a page.
    pub(crate) fn name(&self) -> String {
        self.path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned())
    }

    /// Its text as TOML, read anew; none if there is no file yet. JSON that is a problem is converted.
    pub(crate) fn text(&self) -> Result<Option<String>, WorkbenchError> {
        let text = read(&self.path)?;
        *self.seen.lock().unwrap_or_else(PoisonError::into_inner) = Seen::new(text.clone(), self.format);
        match (text, self.format) {
            (Some(text), Format::Json) => Ok(Some(Description::from_json(&text)?.to_toml()?)),
            (text, _) => Ok(text),
        }
    }

    /// Writes a problem, given as TOML. Unless `anyway`, not over what another program wrote meanwhile.
    pub(crate) fn save(&self, toml: &str, anyway: bool) -> Result<(), WorkbenchError> {
        let description = Description::from_toml(toml)?;
        let text = match self.format {
            Format::Toml => toml.to_owned(),
            Format::Json => {
                let pretty = serde_json::to_string_pretty(&description);
                pretty.map_err(|problem| self.unwritten(&problem))? + "\n"
            }
        };
        let mut seen = self.seen.lock().unwrap_or_else(PoisonError::into_inner);
        // What cannot be read is not what was seen.
        let is_as_seen = read(&self.path).is_ok_and(|now| Seen::new(now, self.format) == *seen);
        match &*seen {
            _ if anyway => {}
            _ if !is_as_seen => return Err(WorkbenchError::Changed { name: self.name() }),
            Seen::Strange(_) => return Err(WorkbenchError::Strange { name: self.name() }),
            Seen::Nothing | Seen::Problem(_) => {}
        }
        write_atomically(&self.path, text.as_bytes()).map_err(|problem| self.unwritten(&problem))?;
        *seen = Seen::Problem(text);
        Ok(())
    }

    fn unwritten(&self, problem: &dyn std::fmt::Display) -> WorkbenchError {
        WorkbenchError::Write { name: self.name(), message: problem.to_string() }
    }
}

/// The text of a file; none if there is none.
fn read(path: &Path) -> Result<Option<String>, WorkbenchError> {
    let failed = |e: std::io::Error| WorkbenchError::Read { path: path.to_owned(), message: e.to_string() };
    let file = match File::open(path) {
        Ok(file) => file,
        Err(problem) if problem.kind() == std::io::ErrorKind::NotFound => return Ok(None),
        Err(problem) => return Err(failed(problem)),
    };
    let mut text = String::new();
    // Some files have no length, or grow.
    file.take(MOST_BYTES + 1).read_to_string(&mut text).map_err(failed)?;
    if text.len() as u64 > MOST_BYTES {
        return Err(WorkbenchError::TooLarge { path: path.to_owned(), limit: MOST_BYTES });
    }
    Ok(Some(text))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::*;

    const PROBLEM: &str = "# kept\ntitle = \"t\"\n[objective]\nkind = \"load\"\n";

    #[test]
    fn a_file_is_written_whole_and_not_over_what_others_wrote() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("new.toml");
        let file = ProblemFile::open(&path).unwrap();
        assert_eq!(file.text().unwrap(), None);
        assert!(matches!(file.save("nonsense = 1", false), Err(WorkbenchError::Format(_))));
        assert!(!path.exists());
        file.save(PROBLEM, false).unwrap();
        assert_eq!(std::fs::read_to_string(&path).unwrap(), PROBLEM);
        file.save(PROBLEM, false).unwrap();
        std::fs::write(&path, "title = \"theirs\"\n").unwrap();
        assert!(matches!(file.save(PROBLEM, false), Err(WorkbenchError::Changed { .. })));
        file.save(PROBLEM, true).unwrap();
        assert_eq!(file.text().unwrap().as_deref(), Some(PROBLEM));
        assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 1);
    }

    #[test]
    fn what_is_no_problem_is_not_written_over_unasked() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("draft.toml");
        let draft = "title = \"half a file\nsoil = ";
        std::fs::write(&path, draft).unwrap();
        let file = ProblemFile::open(&path).unwrap();
        assert_eq!(file.text().unwrap().as_deref(), Some(draft));
        assert!(matches!(file.save(PROBLEM, false), Err(WorkbenchError::Strange { .. })));
        assert_eq!(std::fs::read_to_string(&path).unwrap(), draft);
        file.save(PROBLEM, true).unwrap();
        file.save(PROBLEM, false).unwrap();
    }

    #[test]
    fn json_stays_json() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("it.json");
        std::fs::write(&path, "{\"title\": \"t\", \"objective\": {\"kind\": \"load\"}}").unwrap();
        let file = ProblemFile::open(&path).unwrap();
        let toml = file.text().unwrap().unwrap();
        assert!(toml.contains("title = \"t\""), "{toml}");
        file.save(&toml, false).unwrap();
        assert_eq!(Description::read(&path).unwrap().title.as_deref(), Some("t"));
    }

    #[test]
    fn what_is_no_problem_file_is_refused_at_once() {
        let dir = tempfile::tempdir().unwrap();
        for name in ["a.txt", "toml", "missing/a.toml"] {
            assert!(ProblemFile::open(&dir.path().join(name)).is_err(), "{name}");
        }
        std::fs::create_dir(dir.path().join("folder.toml")).unwrap();
        assert!(ProblemFile::open(&dir.path().join("folder.toml")).is_err());
        std::fs::write(dir.path().join("long.toml"), vec![b'#'; (1 << 20) + 1]).unwrap();
        assert!(matches!(
            ProblemFile::open(&dir.path().join("long.toml")),
            Err(WorkbenchError::TooLarge { .. })
        ));
    }
}
