//! Virtual environments of the Python tests.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use crate::apt;
use crate::error::XtaskError;
use crate::run::Step;
use crate::workspace::PYTHON;

/// Lives inside the environment; holds the requirements that are installed in it.
const STAMP: &str = "installed-requirements.txt";
/// Interpreters that are tried, best first; the last is Debian's own, should another one hide it.
const INTERPRETERS: [&str; 4] = ["python3.11", "python3", "python", "/usr/bin/python3"];
/// The pinned packages need this version, and a venv needs ensurepip.
const PROBE: &str = "import sys, venv, ensurepip; sys.exit(sys.version_info < (3, 11))";

/// A folder with an interpreter and packages of its own.
#[derive(Debug)]
pub(crate) struct Environment {
    folder: PathBuf,
}

impl Environment {
    /// The environment in a folder, whether it is there yet or not.
    pub(crate) const fn new(folder: PathBuf) -> Self {
        Self { folder }
    }

    /// Its Python.
    pub(crate) fn python(&self) -> PathBuf {
        self.folder.join(PYTHON)
    }

    /// `PATH` with its programs first, for those that look for others of it there.
    pub(crate) fn path(&self) -> OsString {
        let mut folders =
            self.python().parent().map_or_else(OsString::new, |folder| folder.as_os_str().to_owned());
        if let Some(rest) = std::env::var_os("PATH") {
            folders.push(if cfg!(windows) { ";" } else { ":" });
            folders.push(rest);
        }
        folders
    }

    /// A call of its pip.
    pub(crate) fn pip(&self, name: &str) -> Step {
        Step::new(name, self.python()).args(["-m", "pip", "--disable-pip-version-check", "--no-input"])
    }

    /// Makes it anew, empty.
    pub(crate) fn create(&self) -> Result<(), XtaskError> {
        let create = Step::new("create an environment", interpreter()?).args(["-m", "venv", "--clear"]);
        create.args([&self.folder]).run()
    }

    /// Makes sure that it holds the pinned requirements of a file, and no other ones.
    pub(crate) fn ensure(&self, file: &Path) -> Result<(), XtaskError> {
        let read = std::fs::read_to_string(file);
        let requirements =
            read.map_err(|problem| XtaskError::file("read the requirements", file, problem))?;
        let stamp = self.folder.join(STAMP);
        if up_to_date(&requirements, &stamp) && self.works() {
            return Ok(());
        }
        // Cleared first: a package that is no longer required must not stay, nor the stamp of a half-done install.
        self.create()?;
        // Every package is pinned, also those that others need, so nothing may be added to the list.
        self.pip("install the Python requirements")
            .args(["install", "--quiet", "--no-deps", "--requirement"])
            .args([file])
            .run()?;
        self.pip("check the Python requirements").args(["check"]).run()?;
        std::fs::write(&stamp, requirements)
            .map_err(|problem| XtaskError::file("stamp the environment", &stamp, problem))
    }

    /// Makes sure that it holds these packages, pinned as `name==version`, with what they need.
    pub(crate) fn ensure_tools(&self, packages: &[&str]) -> Result<(), XtaskError> {
        let stamp = self.folder.join(STAMP);
        let wanted = packages.join("\n");
        if up_to_date(&wanted, &stamp) {
            return Ok(());
        }
        self.create()?;
        self.pip("install tools").args(["install", "--quiet"]).args(packages).run()?;
        std::fs::write(&stamp, wanted).map_err(|problem| XtaskError::file("stamp the tools", &stamp, problem))
    }

    /// False if, for instance, the interpreter behind the environment was removed.
    fn works(&self) -> bool {
        Step::new("try the environment", self.python()).args(["-c", "import pytest"]).succeeds()
    }
}

fn up_to_date(requirements: &str, stamp: &Path) -> bool {
    std::fs::read_to_string(stamp).is_ok_and(|installed| installed == requirements)
}

pub(crate) fn interpreter() -> Result<&'static str, XtaskError> {
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
