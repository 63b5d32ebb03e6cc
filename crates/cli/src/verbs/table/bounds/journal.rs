//! What a run has found so far, in a file beside its output: a header, then one line a case, written as soon as the case
//! is solved. A run that is broken off goes on from there.

use std::fs::{File, OpenOptions};
use std::io::Write;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use soilctl_earth_pressure::table::{BracketRow, BracketRules};

use super::cases::Node;
use crate::error::CliError;

const SCHEMA: &str = "soilctl.table-journal/1";

/// What must be the same for a run to go on with the work of another.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Header {
    pub(super) schema: String,
    pub(super) program_version: String,
    pub(super) rules: BracketRules,
    pub(super) axes: [Vec<f64>; 3],
    pub(super) shard: Option<String>,
}

impl Header {
    pub(super) fn new(rules: BracketRules, axes: [Vec<f64>; 3], shard: Option<String>) -> Self {
        let program_version = env!("CARGO_PKG_VERSION").to_owned();
        Self { schema: SCHEMA.into(), program_version, rules, axes, shard }
    }

    /// In what this header differs from that of a run, in words.
    fn difference(&self, run: &Self) -> Option<String> {
        let differs = |what: &str, here: String, there: String| {
            (here != there).then(|| format!("{what} {here}, not {there}"))
        };
        let axis = |axis: &Vec<f64>| match axis[..] {
            [first, .., last] => format!("{first} to {last} deg in {} nodes", axis.len()),
            _ => format!("{axis:?}"),
        };
        let shard = |header: &Self| header.shard.clone().unwrap_or_else(|| "1/1".into());
        differs("format", self.schema.clone(), run.schema.clone())
            .or_else(|| differs("soilctl", self.program_version.clone(), run.program_version.clone()))
            .or_else(|| differs("--max-gap", self.rules.max_gap.to_string(), run.rules.max_gap.to_string()))
            .or_else(|| {
                let elements = |header: &Self| header.rules.max_elements.to_string();
                differs("--max-elements", elements(self), elements(run))
            })
            .or_else(|| differs("--shard", shard(self), shard(run)))
            .or_else(|| {
                let names = ["--alpha", "--phi", "--delta"];
                let pairs = names.iter().zip(self.axes.iter().zip(&run.axes));
                pairs
                    .filter(|(_, (here, there))| here != there)
                    .map(|(name, (here, there))| format!("{name} {}, not {}", axis(here), axis(there)))
                    .next()
            })
    }
}

/// What was found at a node.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum Found {
    Solved(BracketRow),
    Empty { node: Node, reason: String },
}

/// A case that is done.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Entry {
    pub(super) found: Found,
    /// Time it took; none if it was taken over from a finished table.
    pub(super) seconds: Option<f64>,
}

impl Entry {
    pub(super) const fn node(&self) -> Node {
        match &self.found {
            Found::Solved(row) => row.node(),
            Found::Empty { node, .. } => *node,
        }
    }
}

/// An open journal.
#[derive(Debug)]
pub(super) struct Journal {
    path: PathBuf,
    file: File,
}

/// The journal of an output file.
pub(super) fn journal_path(out: &Path) -> PathBuf {
    let mut name = out.as_os_str().to_owned();
    name.push(".partial.jsonl");
    name.into()
}

/// Entries of the journal of an output file; none if there is no journal.
pub(super) fn read(out: &Path, run: &Header) -> Result<Option<Vec<Entry>>, CliError> {
    let path = journal_path(out);
    let text = match std::fs::read(&path) {
        Ok(bytes) => String::from_utf8_lossy(&bytes).into_owned(),
        Err(problem) if problem.kind() == std::io::ErrorKind::NotFound => return Ok(None),
        Err(problem) => return Err(CliError::File { path: path.display().to_string(), problem }),
    };
    let damaged = |line: usize, problem: serde_json::Error| {
        CliError::Usage(format!(
            "{}, line {line}: {problem}; mend the line or, to start again, delete the file",
            path.display()
        ))
    };
    let mut lines = whole_lines(&text).lines().enumerate();
    let Some((_, first)) = lines.next() else { return Ok(None) };
    let header: Header = serde_json::from_str(first).map_err(|problem| damaged(1, problem))?;
    if let Some(difference) = header.difference(run) {
        return Err(CliError::Usage(format!(
            "{} is from a run with {difference}; to go on with that run give its options again, to start anew delete \
             the file or choose another --out",
            path.display()
        )));
    }
    lines
        .map(|(i, line)| serde_json::from_str(line).map_err(|problem| damaged(i + 1, problem)))
        .collect::<Result<_, _>>()
        .map(Some)
}

/// All but a last line that was being written when the program or the machine went down.
fn whole_lines(text: &str) -> &str {
    &text[..text.rfind('\n').map_or(0, |end| end + 1)]
}

impl Journal {
    /// Writes the journal of an output file anew with what is known, and leaves it open for more.
    pub(super) fn open(out: &Path, header: &Header, known: &[Entry]) -> Result<Self, CliError> {
        let path = journal_path(out);
        let mut text = serde_json::to_string(header)? + "\n";
        for entry in known {
            text += &(serde_json::to_string(entry)? + "\n");
        }
        let temporary = path.with_extension("tmp");
        let write = || {
            let mut file = File::create(&temporary)?;
            file.write_all(text.as_bytes())?;
            file.sync_all()?;
            std::fs::rename(&temporary, &path)?;
            OpenOptions::new().append(true).open(&path)
        };
        match write() {
            Ok(file) => Ok(Self { path, file }),
            Err(problem) => Err(CliError::File { path: path.display().to_string(), problem }),
        }
    }

    /// Adds a case; once this returns, nothing loses it.
    pub(super) fn add(&mut self, entry: &Entry) -> Result<(), CliError> {
        let line = serde_json::to_string(entry)? + "\n";
        let written = self.file.write_all(line.as_bytes()).and_then(|()| self.file.sync_data());
        written.map_err(|problem| CliError::File { path: self.path.display().to_string(), problem })
    }
}

/// Removes the journal, if there is one, of an output file that holds all of it.
pub(super) fn remove(out: &Path) -> Result<(), CliError> {
    let path = journal_path(out);
    match std::fs::remove_file(&path) {
        Err(problem) if problem.kind() != std::io::ErrorKind::NotFound => {
            Err(CliError::File { path: path.display().to_string(), problem })
        }
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn header() -> Header {
        let axes = [vec![80.0, 90.0], vec![25.0, 30.0], vec![0.0, 5.0]];
        Header::new(BracketRules { max_gap: 0.01, max_elements: 12_000 }, axes, None)
    }

    fn entry(alpha: f64) -> Entry {
        let reason = "no pair of bounds".to_owned();
        Entry { found: Found::Empty { node: [alpha, 25.0, 0.1 + 0.2], reason }, seconds: Some(0.1) }
    }

    #[test]
    fn a_torn_line_is_dropped_and_the_next_run_overwrites_it() {
        let dir = tempfile::tempdir().unwrap();
        let out = dir.path().join("t.csv");
        assert_eq!(read(&out, &header()).unwrap(), None);
        let mut journal = Journal::open(&out, &header(), &[entry(80.0)]).unwrap();
        journal.add(&entry(90.0)).unwrap();
        let both = vec![entry(80.0), entry(90.0)];
        assert_eq!(read(&out, &header()).unwrap(), Some(both.clone()));
        let path = journal_path(&out);
        let whole = std::fs::read(&path).unwrap();
        // However much of the last line is missing, the first case stays.
        for cut in 1..60 {
            std::fs::write(&path, &whole[..whole.len() - cut]).unwrap();
            assert_eq!(read(&out, &header()).unwrap(), Some(vec![entry(80.0)]), "{cut}");
        }
        let mut journal = Journal::open(&out, &header(), &[entry(80.0)]).unwrap();
        journal.add(&entry(90.0)).unwrap();
        assert_eq!(std::fs::read(&path).unwrap(), whole);
        // Not even the header was written: nothing is known.
        std::fs::write(&path, &whole[..20]).unwrap();
        assert_eq!(read(&out, &header()).unwrap(), None);
        remove(&out).unwrap();
        assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 0);
    }

    #[test]
    fn other_options_are_refused_by_name() {
        let dir = tempfile::tempdir().unwrap();
        let out = dir.path().join("t.csv");
        Journal::open(&out, &header(), &[]).unwrap();
        let mut others = [header(), header(), header(), header(), header()];
        others[0].rules.max_gap = 0.02;
        others[1].rules.max_elements = 3000;
        others[2].axes[1] = vec![25.0, 35.0];
        others[3].shard = Some("1/2".into());
        others[4].program_version = "9.9.9".into();
        let words = [
            "--max-gap 0.01, not 0.02",
            "--max-elements 12000, not 3000",
            "--phi 25 to 30 deg in 2 nodes, not 25 to 35 deg in 2 nodes",
            "--shard 1/1, not 1/2",
            "not 9.9.9",
        ];
        for (other, words) in others.iter().zip(words) {
            let message = read(&out, other).unwrap_err().to_string();
            assert!(message.contains(words) && message.contains("delete the file"), "{message}");
        }
    }

    #[test]
    fn damage_in_the_middle_is_named_with_its_line() {
        let dir = tempfile::tempdir().unwrap();
        let out = dir.path().join("t.csv");
        Journal::open(&out, &header(), &[entry(80.0), entry(90.0)]).unwrap();
        let text = std::fs::read_to_string(journal_path(&out)).unwrap();
        std::fs::write(journal_path(&out), text.replacen("empty", "mpty", 1)).unwrap();
        let message = read(&out, &header()).unwrap_err().to_string();
        assert!(message.contains("line 2") && message.contains("mpty"), "{message}");
    }
}
