//! The Rust tests: one program more at once than there are processors, since some wait, each with one test at a time.
//!
//! `cargo test` runs one program after the other, and most of ours end with one long test: a second processor would idle.

use std::collections::VecDeque;
use std::num::NonZero;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};
use std::time::Instant;

use serde_json::Value;

use crate::error::XtaskError;
use crate::run::Step;
use crate::tasks::cargo;
use crate::workspace::Workspace;

/// Crates whose programs run longest, and so are begun first. Those of the first two wait for clocks.
const FIRST: [&str; 4] = ["monitor", "live", "limit_analysis", "cli"];

/// The seed of property tests: what passed here passes elsewhere. `cargo test` and `cargo xtask verify` draw anew each time.
const SEED: &str = "1";

/// What was built for the tests.
pub(crate) struct Built {
    programs: VecDeque<Program>,
    soilctl: PathBuf,
}

/// A program of tests.
#[derive(Debug, PartialEq, Eq)]
struct Program {
    file: PathBuf,
    /// Of its package; cargo runs it there.
    folder: PathBuf,
}

impl Built {
    /// Builds them.
    pub(crate) fn new(workspace: &Workspace) -> Result<Self, XtaskError> {
        let messages = cargo(workspace, "build the Rust tests")
            .args(["test", "--workspace", "--locked", "--no-run", "--message-format=json-render-diagnostics"])
            .output()?;
        Self::read(&messages)
    }

    /// From cargo's messages, one JSON object a line.
    fn read(messages: &str) -> Result<Self, XtaskError> {
        let artifacts: Vec<Value> =
            messages.lines().filter_map(|line| serde_json::from_str(line).ok()).collect();
        // The unit tests of a program have its name.
        let soilctl = artifacts.iter().find_map(|message| {
            let is_it = message["target"]["name"] == "soilctl" && message["profile"]["test"] != true;
            message["executable"].as_str().filter(|_| is_it).map(PathBuf::from)
        });
        let soilctl = soilctl.ok_or_else(|| XtaskError::Missing {
            step: "find soilctl".to_owned(),
            what: "cargo reported no executable called soilctl".into(),
            remedy: "see the package in crates/cli".into(),
        })?;
        let mut programs: Vec<Program> = artifacts.iter().filter_map(Program::read).collect();
        programs.sort_by_key(|program| {
            FIRST.iter().position(|&name| program.folder.ends_with(name)).unwrap_or(FIRST.len())
        });
        Ok(Self { programs: programs.into(), soilctl })
    }

    /// The command-line tool.
    pub(crate) fn soilctl(&self) -> &Path {
        &self.soilctl
    }

    /// Runs them all, also after one that fails, then the examples of the documentation.
    pub(crate) fn run(self, workspace: &Workspace) -> Result<(), XtaskError> {
        let workers = std::thread::available_parallelism().map_or(1, NonZero::get) + 1;
        let waiting = Mutex::new(self.programs);
        let failed = Mutex::new(Vec::new());
        std::thread::scope(|scope| {
            for _ in 0..workers {
                scope.spawn(|| {
                    while let Some(program) = next(&waiting) {
                        if let Err(problem) = program.run() {
                            failed.lock().unwrap_or_else(PoisonError::into_inner).push(problem);
                        }
                    }
                });
            }
        });
        let failed = failed.into_inner().unwrap_or_else(PoisonError::into_inner);
        for problem in &failed {
            eprintln!("{problem}");
        }
        failed.into_iter().next().map_or(Ok(()), Err)?;
        cargo(workspace, "examples of the documentation")
            .args(["test", "--workspace", "--locked", "--doc"])
            .run()
    }
}

/// The next program; the lock is let go before it runs.
fn next(waiting: &Mutex<VecDeque<Program>>) -> Option<Program> {
    waiting.lock().unwrap_or_else(PoisonError::into_inner).pop_front()
}

impl Program {
    fn read(message: &Value) -> Option<Self> {
        let file = message["executable"].as_str().filter(|_| message["profile"]["test"] == true)?;
        let folder = Path::new(message["manifest_path"].as_str()?).parent()?;
        Some(Self { file: file.into(), folder: folder.into() })
    }

    /// Runs it; what it printed is shown in one piece.
    fn run(&self) -> Result<(), XtaskError> {
        let begin = Instant::now();
        let name = format!("tests of {}", self.folder.file_name().unwrap_or_default().display());
        let step = Step::new(&name, &self.file)
            .args(["--test-threads", "1"])
            .dir(&self.folder)
            // As cargo does for those that look for their files when they run.
            .env("CARGO_MANIFEST_DIR", &self.folder)
            .env("PROPTEST_RNG_SEED", SEED);
        let result = step.run_in_one_piece();
        eprintln!("== {name}: {:.0} s", begin.elapsed().as_secs_f64());
        result
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MESSAGES: &str = r#"{"reason":"compiler-artifact","target":{"name":"xtask"},"executable":"/t/xtask"}
not json
{"reason":"compiler-artifact","target":{"name":"soilctl"},"executable":null}
{"reason":"compiler-artifact","manifest_path":"/r/a/Cargo.toml","target":{"name":"a"},"profile":{"test":true},"executable":"/t/debug/deps/a-1"}
{"reason":"compiler-artifact","manifest_path":"/r/cli/Cargo.toml","target":{"name":"soilctl"},"profile":{"test":true},"executable":"/t/debug/deps/soilctl-1"}
{"reason":"compiler-artifact","manifest_path":"/r/cli/Cargo.toml","target":{"name":"soilctl"},"profile":{"test":false},"executable":"/t/debug/soilctl"}
{"reason":"build-finished","success":true}"#;

    #[test]
    fn the_programs_are_taken_from_the_right_messages() {
        let built = Built::read(MESSAGES).unwrap();
        assert_eq!(built.soilctl(), Path::new("/t/debug/soilctl"));
        let files: Vec<_> = built.programs.iter().map(|program| program.file.to_str().unwrap()).collect();
        assert_eq!(files, ["/t/debug/deps/soilctl-1", "/t/debug/deps/a-1"], "those that run longest first");
        assert_eq!(built.programs[1].folder, Path::new("/r/a"));
        assert!(Built::read("").err().unwrap().to_string().contains("soilctl"));
    }

    #[cfg(unix)]
    #[test]
    fn a_program_that_fails_is_an_error() {
        let of = |file: &str| Program { file: file.into(), folder: std::env::temp_dir() };
        assert!(of("true").run().is_ok());
        assert!(of("false").run().is_err());
    }
}
