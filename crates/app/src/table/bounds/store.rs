//! A folder of solved cases that several runs fill at a time, shards on other machines among them: a store of Python's sweeps,
//! too.

use std::collections::BTreeMap;
use std::path::Path;

use soilctl_jobs::{Job, canonical};

use super::cases::{Node, key};
use super::journal::{Entry, Header};
use crate::AppError;

const FUNCTION: &str = "soilctl table build";

/// The cases of one version and one set of rules in a folder.
#[derive(Debug)]
pub(super) struct Store {
    store: soilctl_jobs::Store,
    version: String,
}

impl Store {
    pub(super) fn new(folder: &Path, header: &Header) -> Self {
        let rules = header.rules;
        let version = format!(
            "{} --max-gap {} --max-elements {}",
            header.program_version, rules.max_gap, rules.max_elements
        );
        Self { store: soilctl_jobs::Store::open(folder), version }
    }

    /// Cases of a run that are there already. A damaged one counts as missing, and is made again.
    pub(super) fn known(&self, cases: &[Node]) -> Result<Vec<Entry>, AppError> {
        let mut known = Vec::new();
        for node in cases {
            let found = self.store.known(&self.job(&cell(*node)?).key())?;
            let found = found.and_then(|found| serde_json::from_str(&found).ok());
            known.extend(found.map(|found| Entry { found, seconds: None }));
        }
        Ok(known)
    }

    /// Stores a case.
    pub(super) fn publish(&self, entry: &Entry) -> Result<(), AppError> {
        let result = serde_json::to_string(&entry.found)?;
        Ok(self.store.put(&self.job(&cell(entry.node())?), &result)?)
    }

    fn job<'a>(&'a self, cell: &'a str) -> Job<'a> {
        Job { function: FUNCTION, version: &self.version, cell }
    }
}

fn cell(node: Node) -> Result<String, AppError> {
    // As a grid counts its nodes, so that steps of 0.1 find those of another grid.
    let angles = key(node).map(|billionths| billionths as f64 / 1e9);
    let named: BTreeMap<_, _> = ["alpha_deg", "phi_deg", "delta_deg"].into_iter().zip(angles).collect();
    Ok(canonical(&named)?)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use soilctl_earth_pressure::table::BracketRules;

    use super::super::journal::Found;
    use super::*;

    fn store(folder: &Path, max_gap: f64) -> Store {
        let axes = [vec![80.0], vec![25.0], vec![0.0]];
        Store::new(folder, &Header::new(BracketRules { max_gap, max_elements: 1000 }, axes, None))
    }

    fn entry(alpha: f64) -> Entry {
        Entry { found: Found::Empty { node: [alpha, 25.0, 0.0], reason: "none".into() }, seconds: Some(0.1) }
    }

    #[test]
    fn a_case_is_found_by_what_was_asked_and_by_nothing_else() {
        let dir = tempfile::tempdir().unwrap();
        let ours = store(dir.path(), 0.01);
        assert_eq!(ours.known(&[[80.0, 25.0, 0.0]]).unwrap(), []);
        ours.publish(&entry(0.1 + 0.2)).unwrap();
        // The time that it took is no result.
        let found = Entry { seconds: None, ..entry(0.1 + 0.2) };
        assert_eq!(ours.known(&[[80.0, 25.0, 0.0], [0.3, 25.0, 0.0]]).unwrap(), [found]);
        assert_eq!(store(dir.path(), 0.02).known(&[[0.3, 25.0, 0.0]]).unwrap(), []);
    }
}
