//! What holds for the program as a whole.

mod common;

use std::path::Path;
use std::process::{Command, Stdio};

use common::{refused, soilctl};

#[test]
fn help_and_version_are_answers() {
    for args in [&["--help"][..], &["--version"], &["predict", "--help"], &["help", "table"]] {
        let done = soilctl(args);
        assert_eq!(done.status.code(), Some(0), "{args:?}");
        assert!(done.stderr.is_empty() && !done.stdout.is_empty());
    }
}

#[test]
fn wrong_usage_is_exit_code_2_and_says_so_on_stderr() {
    for args in [&[][..], &["shovel"], &["predict", "--alpha"], &["--format", "xml", "completions", "bash"]] {
        assert!(refused(args).contains("error:"), "{args:?}");
    }
}

#[test]
fn the_name_alone_tells_three_lines_that_work() {
    let said = refused(&[]);
    let lines: Vec<_> = said.lines().filter_map(|line| line.strip_prefix("  soilctl ")).collect();
    assert_eq!(lines.len(), 3);
    let folder = tempfile::tempdir().unwrap();
    for line in lines {
        // No page pops up in a test.
        let words = line.split(' ').filter(|word| *word != "--open");
        let done = Command::new(env!("CARGO_BIN_EXE_soilctl"))
            .args(words)
            .current_dir(folder.path())
            .output()
            .unwrap();
        assert_eq!(done.status.code(), Some(0), "{line}: {}", String::from_utf8_lossy(&done.stderr));
    }
    assert!(folder.path().join("demo/ticino_rained/report.html").is_file());
}

#[test]
fn every_verb_has_a_man_page() {
    let folder = tempfile::tempdir().unwrap();
    assert_eq!(soilctl(&["man", folder.path().to_str().unwrap()]).status.code(), Some(0));
    let page = |name: &str| std::fs::read_to_string(folder.path().join(name)).unwrap();
    assert!(page("soilctl.1").starts_with(".ie") && page("soilctl.1").contains("soilctl\\-bound(1)"));
    assert!(page("soilctl-bound.1").contains("max\\-gap"));
    assert!(page("soilctl-table-build.1").contains("table build"));
}

#[test]
fn completion_scripts_know_the_verbs() {
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let script = String::from_utf8(soilctl(&["completions", shell]).stdout).unwrap();
        assert!(script.contains("predict") && script.contains("model-table"), "{shell}");
    }
}

#[test]
fn a_reader_that_goes_away_is_no_failure() {
    let mut child = Command::new(env!("CARGO_BIN_EXE_soilctl"))
        .args(["table", "show", "appendix-c-chen", "--format", "json"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let done = child.wait_with_output().unwrap();
    assert_eq!(done.status.code(), Some(0), "{}", String::from_utf8_lossy(&done.stderr));
    assert!(done.stderr.is_empty());
}

#[test]
fn the_schemas_in_the_documentation_are_those_of_the_code() {
    assert!(String::from_utf8(soilctl(&["--help"]).stdout).unwrap().contains("  schemas "));
    let dir = tempfile::tempdir().unwrap();
    assert_eq!(soilctl(&["schemas", dir.path().to_str().unwrap()]).status.code(), Some(0));
    let kept = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/schemas");
    let names = |folder: &Path| {
        let mut names: Vec<_> =
            std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name()).collect();
        names.sort();
        names
    };
    assert_eq!(names(dir.path()), names(&kept), "run `soilctl schemas docs/schemas`");
    for name in names(&kept) {
        let (new, old) =
            (std::fs::read_to_string(dir.path().join(&name)), std::fs::read_to_string(kept.join(&name)));
        assert_eq!(new.unwrap(), old.unwrap(), "{name:?}: run `soilctl schemas docs/schemas`");
    }
}

#[test]
fn doctor_finds_what_is_on_the_path() {
    let folder = tempfile::tempdir().unwrap();
    let look = || -> serde_json::Value {
        let done = Command::new(env!("CARGO_BIN_EXE_soilctl"))
            .args(["doctor", "--format", "json"])
            .env("PATH", folder.path())
            .output()
            .unwrap();
        assert_eq!(done.status.code(), Some(0));
        serde_json::from_slice(&done.stdout).unwrap()
    };
    let is_found = |answer: &serde_json::Value, what: &str| {
        let checks = answer["checks"].as_array().unwrap();
        checks.iter().find(|check| check["what"] == what).unwrap()["found"].as_bool().unwrap()
    };
    let answer = look();
    for what in ["browser", "viewer", "python-package"] {
        assert!(!is_found(&answer, what), "{answer}");
    }
    let name = format!("rerun{}", std::env::consts::EXE_SUFFIX);
    std::fs::write(folder.path().join(name), "").unwrap();
    assert!(is_found(&look(), "viewer"));
}
