//! What a run has found so far, in a file beside its output: a header, then one line a case, written as soon as the case
//! is solved. A run that is broken off goes on from there.

use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use soilctl_earth_pressure::table::{BracketRow, BracketRules};
use soilctl_jobs::{Inputs, Journal};

use super::cases::Node;
use crate::AppError;

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
}

impl Inputs for Header {
    fn inputs(&self) -> Vec<(&'static str, String)> {
        // Every node, since the nodes between the first and the last may differ, too.
        let [alpha, phi, delta] = self.axes.each_ref().map(|axis| format!("{axis:?} deg"));
        vec![
            ("format", self.schema.clone()),
            ("version of soilctl", self.program_version.clone()),
            ("--max-gap", self.rules.max_gap.to_string()),
            ("--max-elements", self.rules.max_elements.to_string()),
            ("--shard", self.shard.clone().unwrap_or_else(|| "1/1".into())),
            ("--alpha", alpha),
            ("--phi", phi),
            ("--delta", delta),
        ]
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

/// The journal of an output file.
pub(super) fn journal_path(out: &Path) -> PathBuf {
    let mut name = out.as_os_str().to_owned();
    name.push(".partial.jsonl");
    name.into()
}

/// Entries of the journal of an output file; none if there is no journal.
pub(super) fn read(out: &Path, run: &Header) -> Result<Option<Vec<Entry>>, AppError> {
    let path = journal_path(out);
    let Some((header, entries)) = Journal::read::<Header, _>(&path)? else { return Ok(None) };
    header.same_as(run, &path)?;
    Ok(Some(entries))
}

/// Removes the journal, if there is one, of an output file that holds all of it.
pub(super) fn remove(out: &Path) -> Result<(), AppError> {
    let path = journal_path(out);
    match std::fs::remove_file(&path) {
        Err(problem) if problem.kind() != std::io::ErrorKind::NotFound => {
            Err(AppError::File { path: path.display().to_string(), problem })
        }
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn other_options_are_refused_by_name() {
        let axes = [vec![80.0, 90.0], vec![25.0, 30.0], vec![0.0, 5.0]];
        let header = || Header::new(BracketRules { max_gap: 0.01, max_elements: 12_000 }, axes.clone(), None);
        let dir = tempfile::tempdir().unwrap();
        let out = dir.path().join("t.csv");
        let reason = "no pair of bounds".to_owned();
        let entry =
            Entry { found: Found::Empty { node: [80.0, 25.0, 0.1 + 0.2], reason }, seconds: Some(0.1) };
        Journal::begin(&journal_path(&out), &header(), [&entry]).unwrap();
        assert_eq!(read(&out, &header()).unwrap(), Some(vec![entry]));
        let mut others = [header(), header(), header(), header(), header()];
        others[0].rules.max_gap = 0.02;
        others[1].rules.max_elements = 3000;
        others[2].axes[1] = vec![25.0, 35.0];
        others[3].shard = Some("1/2".into());
        others[4].program_version = "9.9.9".into();
        let words = [
            "--max-gap (0.01; this one: 0.02)",
            "--max-elements (12000; this one: 3000)",
            "--phi ([25.0, 30.0] deg; this one: [25.0, 35.0] deg)",
            "--shard (1/1; this one: 1/2)",
            "this one: 9.9.9",
        ];
        for (other, words) in others.iter().zip(words) {
            let message = read(&out, other).unwrap_err().to_string();
            assert!(message.contains(words) && message.contains("delete the file"), "{message}");
        }
        remove(&out).unwrap();
        assert_eq!(read(&out, &header()).unwrap(), None);
    }
}
