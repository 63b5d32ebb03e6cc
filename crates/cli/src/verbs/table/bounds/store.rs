//! A folder of solved cases that several runs fill at a time, shards on other machines among them. It is a store of the Python
//! package's sweeps: each case is a file under the SHA-256 of what was asked, which appears in one step and never changes.

use std::collections::BTreeMap;
use std::io::Write;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use serde_json::Value;
use sha2::{Digest, Sha256};

use super::cases::{Node, key};
use super::journal::{Entry, Found, Header};
use crate::error::CliError;

const FORMAT: &str = "soilctl.sweep/1";
const FUNCTION: &str = "soilctl table build";

/// A result as it is stored; keys in the order of their names, as in what is asked.
#[derive(Debug, Serialize, Deserialize)]
struct Document {
    cell: BTreeMap<String, f64>,
    format: String,
    function: String,
    /// JSON of its own, so that its bytes can be checked.
    result: String,
    sha256: String,
    version: String,
}

/// The cases of one version and one set of rules in a folder.
#[derive(Debug)]
pub(super) struct Store {
    folder: PathBuf,
    version: String,
}

impl Store {
    pub(super) fn new(folder: &Path, header: &Header) -> Self {
        let rules = header.rules;
        let version = format!(
            "{} --max-gap {} --max-elements {}",
            header.program_version, rules.max_gap, rules.max_elements
        );
        Self { folder: folder.to_owned(), version }
    }

    /// Cases of a run that are there already. A damaged file counts as missing, and is made again.
    pub(super) fn known(&self, cases: &[Node]) -> Result<Vec<Entry>, CliError> {
        let found = cases.iter().map(|node| self.read(*node)).filter_map(Result::transpose);
        found.map(|found| Ok(Entry { found: found?, seconds: None })).collect()
    }

    fn read(&self, node: Node) -> Result<Option<Found>, CliError> {
        let path = self.path(node)?;
        let bytes = match std::fs::read(&path) {
            Ok(bytes) => bytes,
            Err(problem) if problem.kind() == std::io::ErrorKind::NotFound => return Ok(None),
            Err(problem) => return Err(CliError::File { path: path.display().to_string(), problem }),
        };
        let sound = |document: &Document| hash(document.result.as_bytes()) == document.sha256;
        let document = serde_json::from_slice::<Document>(&bytes).ok().filter(sound);
        Ok(document.and_then(|document| serde_json::from_str(&document.result).ok()))
    }

    /// Stores a case.
    pub(super) fn publish(&self, entry: &Entry) -> Result<(), CliError> {
        let node = entry.node();
        let result = serde_json::to_string(&entry.found)?;
        let document = Document {
            cell: cell(node),
            format: FORMAT.into(),
            function: FUNCTION.into(),
            sha256: hash(result.as_bytes()),
            result,
            version: self.version.clone(),
        };
        let text = serde_json::to_string(&document)? + "\n";
        let path = self.path(node)?;
        write(&path, text.as_bytes())
            .map_err(|problem| CliError::File { path: path.display().to_string(), problem })
    }

    fn path(&self, node: Node) -> Result<PathBuf, CliError> {
        let asked = BTreeMap::from([
            ("cell", serde_json::to_value(cell(node))?),
            ("format", Value::from(FORMAT)),
            ("function", Value::from(FUNCTION)),
            ("version", Value::from(self.version.as_str())),
        ]);
        let key = hash(serde_json::to_string(&asked)?.as_bytes());
        Ok(self.folder.join("results").join(&key[..2]).join(format!("{key}.json")))
    }
}

fn cell(node: Node) -> BTreeMap<String, f64> {
    // As a grid counts its nodes, so that steps of 0.1 find those of another grid.
    let [alpha, phi, delta] = key(node).map(|billionths| billionths as f64 / 1e9);
    [("alpha_deg", alpha), ("phi_deg", phi), ("delta_deg", delta)]
        .map(|(name, angle)| (name.into(), angle))
        .into()
}

fn hash(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}

/// Beside its place first, under a name that nobody else has: whoever sees the file sees all of it.
fn write(path: &Path, bytes: &[u8]) -> std::io::Result<()> {
    use std::os::unix::fs::PermissionsExt;
    let folder = path.parent().unwrap_or(Path::new("."));
    std::fs::create_dir_all(folder)?;
    // As any new file, not for its owner only: others may go on with the work.
    let permissions = std::fs::Permissions::from_mode(0o666);
    let mut file = tempfile::Builder::new().prefix(".").permissions(permissions).tempfile_in(folder)?;
    file.write_all(bytes)?;
    file.as_file().sync_all()?;
    file.persist(path).map_err(|problem| problem.error)?;
    Ok(())
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use soilctl_earth_pressure::table::BracketRules;

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

    #[test]
    fn a_damaged_case_is_missing() {
        let dir = tempfile::tempdir().unwrap();
        let store = store(dir.path(), 0.01);
        store.publish(&entry(80.0)).unwrap();
        let path = store.path([80.0, 25.0, 0.0]).unwrap();
        let text = std::fs::read_to_string(&path).unwrap();
        for damaged in [text.replace("none", "nine"), text[..text.len() / 2].to_owned(), String::new()] {
            std::fs::write(&path, damaged).unwrap();
            assert_eq!(store.known(&[[80.0, 25.0, 0.0]]).unwrap(), []);
        }
        store.publish(&entry(80.0)).unwrap();
        assert_eq!(std::fs::read_to_string(&path).unwrap(), text);
        assert_eq!(std::fs::read_dir(path.parent().unwrap()).unwrap().count(), 1);
    }
}
