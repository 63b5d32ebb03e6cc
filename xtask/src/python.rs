//! The virtual environment of the Python tests.

use std::path::Path;

use crate::apt;
use crate::error::XtaskError;
use crate::run::Step;
use crate::workspace::Workspace;

/// Lives inside the environment; holds the requirements that are installed in it.
const STAMP: &str = "installed-requirements.txt";
/// Interpreters that are tried, best first; the last is Debian's own, should another one hide it.
const INTERPRETERS: [&str; 3] = ["python3.11", "python3", "/usr/bin/python3"];
/// The pinned packages need this version, and a venv needs ensurepip.
const PROBE: &str = "import sys, venv, ensurepip; sys.exit(sys.version_info < (3, 11))";

/// Makes sure that `.venv` holds exactly the pinned requirements.
pub(crate) fn ensure(workspace: &Workspace) -> Result<(), XtaskError> {
    let file = workspace.requirements();
    let read = std::fs::read_to_string(&file);
    let requirements = read.map_err(|problem| file_error("read the requirements", &file, problem))?;
    let stamp = workspace.venv().join(STAMP);
    if up_to_date(&requirements, &stamp) && works(workspace) {
        return Ok(());
    }
    // Cleared first: a package that is no longer required must not stay, nor the stamp of a half-done install.
    let create = Step::new("create .venv", interpreter()?).args(["-m", "venv", "--clear"]);
    create.args([workspace.venv()]).run()?;
    let pip = |name: &str| {
        Step::new(name, workspace.venv_python()).args(["-m", "pip", "--disable-pip-version-check"])
    };
    // Every package is pinned, also those that others need, so nothing may be added to the list.
    pip("install the Python requirements")
        .args(["install", "--quiet", "--no-input", "--no-deps", "--requirement"])
        .args([&file])
        .run()?;
    pip("check the Python requirements").args(["check"]).run()?;
    std::fs::write(&stamp, requirements).map_err(|problem| file_error("stamp .venv", &stamp, problem))
}

fn up_to_date(requirements: &str, stamp: &Path) -> bool {
    std::fs::read_to_string(stamp).is_ok_and(|installed| installed == requirements)
}

/// False if, for instance, the interpreter behind the environment was removed.
fn works(workspace: &Workspace) -> bool {
    Step::new("try .venv", workspace.venv_python()).args(["-c", "import pytest"]).succeeds()
}

fn interpreter() -> Result<&'static str, XtaskError> {
    let usable = || {
        INTERPRETERS
            .into_iter()
            .find(|program| Step::new("try Python", program).args(["-c", PROBE]).succeeds())
    };
    if let Some(program) = usable() {
        return Ok(program);
    }
    apt::install(
        "install Python",
        "Python 3.11 or later with its venv module",
        &["python3", "python3-venv"],
    )?;
    usable().ok_or_else(|| XtaskError::Missing {
        step: "find Python".into(),
        what: "there is no Python 3.11 or later with its venv module".into(),
        remedy: "install one as python3.11 or python3".into(),
    })
}

fn file_error(step: &str, file: &Path, problem: std::io::Error) -> XtaskError {
    XtaskError::File { step: step.to_owned(), file: file.display().to_string(), problem }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_same_requirements_are_up_to_date() {
        let own = Path::new(env!("CARGO_MANIFEST_DIR")).join("Cargo.toml");
        let text = std::fs::read_to_string(&own).unwrap();
        assert!(up_to_date(&text, &own));
        assert!(!up_to_date(&format!("{text}pytest==1\n"), &own));
        assert!(!up_to_date("", Path::new("no-such-stamp")));
    }
}
