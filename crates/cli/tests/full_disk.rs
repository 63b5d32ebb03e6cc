//! A disk that is full: an error in words, once, and no half-written file. A limit on the size of files stands for it.
#![cfg(unix)]
#![allow(clippy::unwrap_used, reason = "tests")]

mod common;

use std::path::Path;
use std::process::Command;

/// Runs with files of at most `kib` KiB: exit code and stderr.
fn limited(folder: &Path, kib: u32, args: &[&str]) -> (Option<i32>, String) {
    let script = format!("trap '' XFSZ; ulimit -f {}; exec \"$0\" \"$@\"", 2 * kib);
    let done = Command::new("sh")
        .args(["-c", &script, env!("CARGO_BIN_EXE_soilctl")])
        .args(args)
        .current_dir(folder)
        .output()
        .unwrap();
    (done.status.code(), String::from_utf8(done.stderr).unwrap())
}

fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).unwrap();
    let mut names: Vec<_> =
        entries.map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

#[test]
fn old_files_stay_and_new_ones_leave_nothing() {
    let strokes = concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/soils/ticino_rained/strokes.csv");
    let plan = concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/plans/table_6_2.toml");
    let wall = concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/problems/wall_passive.toml");
    for (file, args) in [
        ("page.html", &["report", strokes, "--delta", "23", "--out", "page.html"][..]),
        ("figure.svg", &["solve", wall, "--check", "--plot", "figure.svg"]),
        ("t.csv", &["table", "build", "--model", "chen", "--out", "t.csv"]),
        ("t.parquet", &["table", "build", "--model", "chen", "--out", "t.parquet"]),
        ("campaign/batch_000.mcap", &["simulate", plan, "--out", "campaign", "--threads", "1", "--quiet"]),
    ] {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join(file);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(&path, "old").unwrap();
        let (code, stderr) = limited(dir.path(), if file.ends_with("mcap") { 512 } else { 1 }, args);
        assert_eq!(code, Some(2), "{args:?}: {stderr}");
        assert_eq!(stderr.matches("File too large").count(), 1, "{args:?}: {stderr}");
        assert_eq!(std::fs::read_to_string(&path).unwrap(), "old", "{args:?}");
        let left = names(path.parent().unwrap());
        assert!(left.iter().all(|name| !name.starts_with('.') && !name.ends_with(".part")), "{left:?}");
    }
}

#[test]
fn what_is_wrong_with_a_log_is_said_once() {
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("a.mcap"), "no log").unwrap();
    let (code, stderr) = limited(dir.path(), 1024, &["process", "a.mcap"]);
    assert_eq!((code, stderr.matches("a.mcap").count()), (Some(2), 1), "{stderr}");
    std::fs::write(dir.path().join("b.mcap"), "no log").unwrap();
    for (options, told) in [(&[][..], [1, 1]), (&["--quiet"], [1, 0])] {
        let args = [&["process", "a.mcap", "b.mcap"], options].concat();
        let (code, stderr) = limited(dir.path(), 1024, &args);
        assert_eq!(code, Some(2));
        assert_eq!(["a.mcap", "b.mcap"].map(|name| stderr.matches(name).count()), told, "{stderr}");
        assert!(stderr.contains("none of 2 logs can be used"), "{stderr}");
    }
}
