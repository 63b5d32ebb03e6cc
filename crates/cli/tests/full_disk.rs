//! A disk that is full: an error in words, once, and no half-written file. A limit on the size of files stands for it.
#![cfg(unix)]
#![allow(clippy::unwrap_used, reason = "tests")]

mod common;

use std::path::Path;
use std::process::{Command, Output};

/// Runs with files of at most `kib` KiB.
fn run_limited(folder: &Path, kib: u32, args: &[&str]) -> Output {
    let script = format!("trap '' XFSZ; ulimit -f {}; exec \"$0\" \"$@\"", 2 * kib);
    Command::new("sh")
        .args(["-c", &script, env!("CARGO_BIN_EXE_soilctl")])
        .args(args)
        .current_dir(folder)
        .output()
        .unwrap()
}

/// The same: exit code and stderr.
fn limited(folder: &Path, kib: u32, args: &[&str]) -> (Option<i32>, String) {
    let done = run_limited(folder, kib, args);
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

/// Bounds that took their time are not lost with a file, and other files are written all the same.
#[test]
fn bounds_are_printed_whatever_happens_to_files() {
    let wall = concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/problems/wall_passive.toml");
    let solve = ["solve", wall, "--max-gap", "0.5", "--max-elements", "1000"];
    let plate = ["bound", "--alpha", "90", "--phi", "30", "--delta", "15", "--max-gap", "0.5"];
    let written = ["save.json", "plot.svg", "field.vtu", "mesh.msh", "page.html", "figures/figure-1.svg"];
    let options = ["--save", "--plot", "--vtu", "--mesh", "--report", "--figures"];
    for args in [&solve[..], &plate] {
        let dir = tempfile::tempdir().unwrap();
        std::fs::create_dir(dir.path().join("figures")).unwrap();
        written.iter().for_each(|file| std::fs::write(dir.path().join(file), "old").unwrap());
        let files = options.iter().zip(written);
        let files = files.flat_map(|(option, file)| [*option, file.split('/').next().unwrap()]);
        let args: Vec<&str> = args.iter().copied().chain(files).collect();
        let done = run_limited(dir.path(), 1, &args);
        let [stdout, stderr] = [done.stdout, done.stderr].map(|text| String::from_utf8(text).unwrap());
        assert_eq!(done.status.code(), Some(2), "{stderr}");
        assert!(stdout.contains("lower  ") && stdout.contains("upper  "), "{stdout}");
        for file in written.iter().take(5) {
            assert_eq!(stderr.matches(file).count(), 1, "{file}: {stderr}");
            assert!(!stdout.contains(file), "{file}: {stdout}");
        }
        for file in written {
            assert_eq!(std::fs::read_to_string(dir.path().join(file)).unwrap(), "old", "{file}");
        }
        assert_eq!(names(dir.path()).len(), written.len(), "{:?}", names(dir.path()));
    }
    // Where no file can be, nothing is solved first.
    let dir = tempfile::tempdir().unwrap();
    for (option, file) in
        [("--save", "no/save.json"), ("--report", "no/page.html"), ("--vtu", "no/field.vtu")]
    {
        let begun = std::time::Instant::now();
        let (code, stderr) = limited(dir.path(), 1024, &[&solve[..2], &[option, file]].concat());
        assert!(code == Some(2) && stderr.contains(file), "{stderr}");
        assert!(begun.elapsed().as_secs_f64() < 5.0, "{option} is looked at after solving");
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
