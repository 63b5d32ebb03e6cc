//! A disk that is full: no file is changed, and nothing half-written is left. A limit on the size of files stands for it.
#![cfg(unix)]
#![allow(clippy::unwrap_used, reason = "tests")]

use std::path::{Path, PathBuf};
use std::process::Command;

use soilctl_jobs::{Beside, Job, Journal, Store, write_atomically};

const FOLDER: &str = "SOILCTL_JOBS_FULL_DISK";

#[test]
fn what_was_there_stays_and_nothing_is_left() {
    let Some(folder) = std::env::var_os(FOLDER).map(PathBuf::from) else { return limited() };
    let (long, path) = (vec![b'x'; 100_000], folder.join("file"));
    assert!(write_atomically(&path, &long).is_err());
    let beside = Beside::new(&path);
    assert!(std::fs::write(beside.path(), &long).is_err());
    drop(beside);
    let job = Job { function: "f", version: "", cell: "{}" };
    let text = String::from_utf8(long).unwrap();
    assert!(Store::open(&folder).put(&job, &format!("\"{text}\"")).is_err());
    // After an entry that did not fit others do.
    let mut journal = Journal::begin(&folder.join("journal"), &"h", &[1]).unwrap();
    assert!(journal.add(&text).is_err());
    journal.add(&2).unwrap();
}

/// Runs the test above with files of at most 32 KiB.
fn limited() {
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("file"), "old").unwrap();
    let script = "trap '' XFSZ; ulimit -f 64; exec \"$0\"";
    let test = std::env::current_exe().unwrap();
    // What the test prints goes through pipes: a file behind them may itself be longer than the limit.
    let done = Command::new("sh").args(["-c", script]).arg(test).env(FOLDER, dir.path()).output().unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stdout));
    assert_eq!(files(dir.path()), ["file: old", "journal: \"h\"\n1\n2\n"]);
}

fn files(folder: &Path) -> Vec<String> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            found.extend(files(&path));
        } else {
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            found.push(format!("{name}: {}", std::fs::read_to_string(&path).unwrap()));
        }
    }
    found.sort();
    found
}
