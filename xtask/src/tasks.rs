//! The tasks and their steps.

use std::path::{Path, PathBuf};

use crate::error::XtaskError;
use crate::python::Environment;
use crate::run::Step;
use crate::rust_tests::Built;
use crate::verify::Part;
use crate::workspace::Workspace;
use crate::{browser, chromium, dist, fuzz, rust, supply, systems, verify, wheel};

/// What xtask can be asked for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Task {
    Setup,
    Test,
    Lint,
    Verify(Vec<Part>),
    Rows,
    Pictures,
    Msrv,
    Targets,
    Windows,
    Deny,
    Audit,
    Fuzz(u32),
    /// For a target, or for this machine.
    Dist(Option<String>),
    /// The same.
    Wheels(Option<String>),
    Reproducible,
    Site,
    Workbench,
}

/// Word, further words, what it does.
const TASKS: [(&str, &str, &str); 17] = [
    (
        "setup",
        "",
        "make the two environments with the pinned Python packages, install chromium if there is none",
    ),
    (
        "test",
        "",
        "setup, then all tests: Rust, Python package, documentation, command line, report in the browser",
    ),
    ("lint", "", "format, clippy and documentation, warnings are errors"),
    ("verify", "[PART]...", "what takes long, whole or in the parts named after it"),
    ("rows", "", "write what docs/verification.md shows anew: published tables and exact solutions, minutes"),
    ("pictures", "", "make the pictures of pages in docs/images anew, in the browser"),
    ("msrv", "", "build with the oldest Rust that Cargo.toml promises"),
    ("targets", "", "check for Windows, macOS on Arm and WebAssembly"),
    ("windows", "", "build for Windows and test the program under wine, against the one built here"),
    ("deny", "", "licences, advisories, sources and second versions of the dependencies, by cargo-deny"),
    ("audit", "", "known weaknesses of the pinned Python packages, by pip-audit"),
    ("fuzz", "[SECONDS]", "run each target of fuzz/ so long, 60 s by default, with nightly Rust"),
    (
        "dist",
        "[TARGET]",
        "archive of the program with completions, man pages, notices, SBOM and checksums, in target/dist",
    ),
    (
        "wheels",
        "[TARGET]",
        "wheels of the Python package that others can install, tried if they are for this system, in target/dist",
    ),
    ("reproducible", "", "build the archive in two folders and compare the bytes"),
    (
        "site",
        "",
        "the documentation, with the notebooks' outputs and the workbench, for any static host, in target/site",
    ),
    ("workbench", "", "the workbench alone, solved in the browser, for any static host, in target/workbench"),
];

/// What to type.
pub(crate) fn usage() -> String {
    let tasks = TASKS.map(|(word, further, does)| format!("  {:<19}{does}", format!("{word} {further}")));
    let parts = verify::PARTS.map(|(_, word, does)| format!("  {word:<19}{does}"));
    format!("usage: cargo xtask <task>\n\n{}\n\nparts of verify\n\n{}", tasks.join("\n"), parts.join("\n"))
}

impl Task {
    /// The task of words.
    ///
    /// # Errors
    ///
    /// What is wrong with them.
    pub(crate) fn from_words(word: &str, further: &[String]) -> Result<Self, String> {
        let alone = |task: Self| match further {
            [] => Ok(task),
            _ => Err(format!("{word} takes no further arguments, but got {}", further.join(" "))),
        };
        let target = || match further {
            [] => Ok(None),
            [target] => Ok(Some(target.clone())),
            _ => Err(format!("{word} takes one target, but got {}", further.join(" "))),
        };
        match word {
            "setup" => alone(Self::Setup),
            "test" => alone(Self::Test),
            "lint" => alone(Self::Lint),
            "verify" => Ok(Self::Verify(Part::from_words(further)?)),
            "rows" => alone(Self::Rows),
            "pictures" => alone(Self::Pictures),
            "msrv" => alone(Self::Msrv),
            "targets" => alone(Self::Targets),
            "windows" => alone(Self::Windows),
            "deny" => alone(Self::Deny),
            "audit" => alone(Self::Audit),
            "fuzz" => Ok(Self::Fuzz(fuzz::seconds(further)?)),
            "dist" => Ok(Self::Dist(target()?)),
            "wheels" => Ok(Self::Wheels(target()?)),
            "reproducible" => alone(Self::Reproducible),
            "site" => alone(Self::Site),
            "workbench" => alone(Self::Workbench),
            _ => Err(format!("there is no task {word:?}")),
        }
    }

    /// Runs its steps up to the first that fails.
    pub(crate) fn run(&self, workspace: &Workspace) -> Result<(), XtaskError> {
        match self {
            Self::Setup => setup(workspace),
            Self::Test => test(workspace),
            Self::Lint => lint(workspace),
            Self::Verify(parts) => verify::run(workspace, parts),
            Self::Rows => rows(workspace),
            Self::Pictures => pictures(workspace),
            Self::Msrv => rust::msrv(workspace),
            Self::Targets => systems::targets(workspace),
            Self::Windows => systems::windows(workspace),
            Self::Deny => supply::deny(workspace),
            Self::Audit => supply::audit(workspace),
            Self::Fuzz(seconds) => fuzz::run(workspace, *seconds),
            Self::Dist(target) => dist::run(workspace, target.as_deref()),
            Self::Wheels(target) => dist::wheels::run(workspace, target.as_deref()),
            Self::Reproducible => dist::reproducible::run(workspace),
            Self::Site => wheel::site(workspace),
            Self::Workbench => browser::make(workspace, &workspace.target().join("workbench")),
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
    // What is downloaded waits for networks, what is built for processors.
    let (ready, built) = std::thread::scope(|scope| {
        let ready = scope.spawn(|| setup(workspace));
        let built = Built::new(workspace);
        (ready.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)), built)
    });
    ready?;
    let built = built?;
    let soilctl = built.soilctl().to_path_buf();
    built.run(workspace)?;
    wheel::test(workspace)?;
    // Last, so that a log ends with pytest's summary.
    python_tests(workspace, "Python tests", &soilctl).run()
}

/// The tests of the program in Python but those that are marked as long.
pub(crate) fn python_tests(workspace: &Workspace, name: &str, soilctl: &Path) -> Step {
    Step::new(name, workspace.venv_python())
        .args(["-m", "pytest", "tests/python", "--ignore", "tests/python/wheel"])
        // It tests what takes minutes to build: see `verify`.
        .args(["--ignore", "tests/python/browser"])
        // Two at a time, whatever the machine; a file's fixtures are made once.
        .args(["--numprocesses", "2", "--dist", "loadfile"])
        .dir(workspace.root())
        .env("SOILCTL", soilctl)
}

/// Builds the command-line tool as the Rust tests do; with other arguments much would be compiled once more.
pub(crate) fn find_soilctl(workspace: &Workspace) -> Result<PathBuf, XtaskError> {
    Ok(Built::new(workspace)?.soilctl().to_path_buf())
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
    fn every_task_is_found_by_its_word() {
        for (word, ..) in TASKS {
            assert!(Task::from_words(word, &[]).is_ok(), "{word}");
        }
        let words = |words: &[&str]| words.iter().map(|word| (*word).to_owned()).collect::<Vec<_>>();
        assert!(Task::from_words("tests", &[]).unwrap_err().contains("\"tests\""));
        assert!(Task::from_words("lint", &words(&["all"])).unwrap_err().contains("all"));
        assert_eq!(Task::from_words("fuzz", &words(&["5"])), Ok(Task::Fuzz(5)));
        assert!(Task::from_words("fuzz", &words(&["long"])).unwrap_err().contains("long"));
        assert_eq!(Task::from_words("dist", &words(&["t"])), Ok(Task::Dist(Some("t".into()))));
        assert!(Task::from_words("dist", &words(&["t", "u"])).is_err());
    }
}
