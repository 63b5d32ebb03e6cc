//! The tasks and their steps.

use std::path::PathBuf;

use crate::error::XtaskError;
use crate::python::Environment;
use crate::run::Step;
use crate::workspace::Workspace;
use crate::{chromium, verify, wheel};

/// What xtask can be asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Task {
    Setup,
    Test,
    Lint,
    Verify,
    Rows,
    Pictures,
}

const TASKS: [(Task, &str, &str); 6] = [
    (
        Task::Setup,
        "setup",
        "make the two environments with the pinned Python packages, install chromium if there is none",
    ),
    (
        Task::Test,
        "test",
        "setup, then all tests: Rust, Python package, documentation, command line, report in the browser",
    ),
    (Task::Lint, "lint", "format, clippy and documentation, warnings are errors"),
    (Task::Verify, "verify", "what takes long, whole or in the parts named after it"),
    (
        Task::Rows,
        "rows",
        "write what docs/verification.md shows anew: published tables and exact solutions, minutes",
    ),
    (Task::Pictures, "pictures", "make the pictures of pages in docs/images anew, in the browser"),
];

/// What to type.
pub(crate) fn usage() -> String {
    let tasks = TASKS.map(|(_, word, does)| format!("  {word:<12}{does}"));
    let parts = verify::PARTS.map(|(_, word, does)| format!("  {word:<12}{does}"));
    format!(
        "usage: cargo xtask <task>\n\n{}\n\nparts of verify: cargo xtask verify [PART]...\n\n{}",
        tasks.join("\n"),
        parts.join("\n")
    )
}

impl Task {
    /// The task of a name.
    pub(crate) fn from_word(word: &str) -> Option<Self> {
        TASKS.into_iter().find(|(_, name, _)| *name == word).map(|(task, ..)| task)
    }

    /// Its name.
    pub(crate) fn word(self) -> &'static str {
        match self {
            Self::Setup => "setup",
            Self::Test => "test",
            Self::Lint => "lint",
            Self::Verify => "verify",
            Self::Rows => "rows",
            Self::Pictures => "pictures",
        }
    }

    /// Runs its steps up to the first that fails; `parts` are for [`Task::Verify`].
    pub(crate) fn run(self, workspace: &Workspace, parts: &[verify::Part]) -> Result<(), XtaskError> {
        match self {
            Self::Setup => setup(workspace),
            Self::Test => test(workspace),
            Self::Lint => lint(workspace),
            Self::Verify => verify::run(workspace, parts),
            Self::Rows => rows(workspace),
            Self::Pictures => pictures(workspace),
        }
    }
}

/// A step that runs the cargo that runs this program.
pub(crate) fn cargo(workspace: &Workspace, name: &str) -> Step {
    Step::new(name, workspace.cargo()).dir(workspace.root())
}

/// Makes what the Python tests need.
pub(crate) fn setup(workspace: &Workspace) -> Result<(), XtaskError> {
    Environment::new(workspace.venv()).ensure(&workspace.requirements())?;
    wheel::ensure(workspace)?;
    chromium::ensure()
}

fn test(workspace: &Workspace) -> Result<(), XtaskError> {
    setup(workspace)?;
    cargo(workspace, "Rust tests").args(["test", "--workspace", "--locked"]).run()?;
    let soilctl = find_soilctl(workspace)?;
    wheel::test(workspace)?;
    // Last, so that a log ends with pytest's summary.
    Step::new("Python tests", workspace.venv_python())
        .args(["-m", "pytest", "tests/python", "--ignore", "tests/python/wheel"])
        // Two at a time, whatever the machine; a file's fixtures are made once.
        .args(["--numprocesses", "2", "--dist", "loadfile"])
        .dir(workspace.root())
        .env("SOILCTL", soilctl)
        .run()
}

/// Asks cargo where the command-line tool is, which a configured target folder decides. It was built for the Rust tests; with
/// other arguments much would be compiled once more.
pub(crate) fn find_soilctl(workspace: &Workspace) -> Result<PathBuf, XtaskError> {
    let name = "find soilctl";
    let messages = cargo(workspace, name)
        .args(["test", "--workspace", "--locked", "--no-run", "--message-format=json-render-diagnostics"])
        .output()?;
    executable(&messages, "soilctl").ok_or_else(|| XtaskError::Missing {
        step: name.to_owned(),
        what: "cargo reported no executable called soilctl".into(),
        remedy: "see the package in crates/cli".into(),
    })
}

/// The file of a program, from cargo's messages (one JSON object a line); that of its own unit tests has the same name.
fn executable(messages: &str, program: &str) -> Option<PathBuf> {
    messages.lines().filter_map(|line| serde_json::from_str::<serde_json::Value>(line).ok()).find_map(
        |message| {
            let of_program = message["target"]["name"] == program && message["profile"]["test"] != true;
            message["executable"].as_str().filter(|_| of_program).map(PathBuf::from)
        },
    )
}

fn pictures(workspace: &Workspace) -> Result<(), XtaskError> {
    setup(workspace)?;
    Step::new("pictures", workspace.venv_python())
        .args(["book/pictures.py"])
        .dir(workspace.root())
        .env("SOILCTL", find_soilctl(workspace)?)
        .run()
}

fn lint(workspace: &Workspace) -> Result<(), XtaskError> {
    cargo(workspace, "format").args(["fmt", "--all", "--check"]).run()?;
    cargo(workspace, "clippy")
        .args(["clippy", "--workspace", "--all-targets", "--locked", "--", "-D", "warnings"])
        .run()?;
    cargo(workspace, "documentation")
        .args(["doc", "--no-deps", "--workspace", "--locked"])
        .env("RUSTDOCFLAGS", "-D warnings")
        .run()
}

/// A test that is ignored because what it asks for is not met yet; the others only take long.
const NOT_MET: &str = "exact_strip_at_40_degrees_on_3000_elements";

/// The tests that compare with the rows write them if they are told so. In the profile of the tests, so little is compiled.
fn rows(workspace: &Workspace) -> Result<(), XtaskError> {
    let exact = workspace.root().join("docs/verification/exact.json");
    std::fs::write(&exact, "[]\n").map_err(|problem| {
        let (step, file) = ("begin the rows anew".to_owned(), exact.display().to_string());
        XtaskError::File { step, file, problem }
    })?;
    for (name, arguments) in [
        (
            "published tables",
            &[
                "--test",
                "published_tables",
                "--test",
                "thesis_estimates",
                "--test",
                "strokes",
                "documentation",
            ][..],
        ),
        ("known collapse loads", &["--test", "exact", "--", "--include-ignored"]),
    ] {
        let words = ["test", "--workspace", "--locked"];
        let step = cargo(workspace, name).args(words).args(arguments).env("SOILCTL_ROWS", "write");
        if arguments.contains(&"--") { step.args(["--skip", NOT_MET]) } else { step }.run()?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_task_is_found_by_its_word_and_in_the_usage() {
        for (task, word, _) in TASKS {
            assert_eq!(Task::from_word(word), Some(task));
            assert_eq!(task.word(), word);
            assert!(usage().contains(word));
        }
        assert_eq!(Task::from_word("tests"), None);
    }

    #[test]
    fn the_executable_is_taken_from_the_right_message() {
        let messages = r#"{"reason":"compiler-artifact","target":{"name":"xtask"},"executable":"/t/xtask"}
not json
{"reason":"compiler-artifact","target":{"name":"soilctl"},"executable":null}
{"reason":"compiler-artifact","target":{"name":"soilctl"},"profile":{"test":true},"executable":"/t/debug/deps/soilctl-1"}
{"reason":"compiler-artifact","target":{"name":"soilctl"},"profile":{"test":false},"executable":"/t/debug/soilctl"}
{"reason":"build-finished","success":true}"#;
        assert_eq!(executable(messages, "soilctl"), Some(PathBuf::from("/t/debug/soilctl")));
        assert_eq!(executable(messages, "other"), None);
    }
}
