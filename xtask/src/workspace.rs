//! Where things are.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use crate::error::XtaskError;

/// The interpreter in a virtual environment.
pub(crate) const PYTHON: &str = if cfg!(windows) { "Scripts/python.exe" } else { "bin/python" };

/// Folders and programs of this checkout.
#[derive(Debug)]
pub(crate) struct Workspace {
    root: PathBuf,
    cargo: OsString,
}

impl Workspace {
    /// The checkout that cargo runs this program from.
    pub(crate) fn find() -> Result<Self, XtaskError> {
        let missing = || XtaskError::Missing {
            step: "find the checkout".into(),
            what: "CARGO_MANIFEST_DIR is not set".into(),
            remedy: "run this program as `cargo xtask <task>`".into(),
        };
        // Asked at run time: a target folder may be shared between checkouts.
        let own = std::env::var_os("CARGO_MANIFEST_DIR").ok_or_else(missing)?;
        let root = Path::new(&own).parent().ok_or_else(missing)?.to_path_buf();
        Ok(Self { root, cargo: std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()) })
    }

    /// The top folder.
    pub(crate) fn root(&self) -> &Path {
        &self.root
    }

    /// The cargo that runs this program.
    pub(crate) fn cargo(&self) -> &OsString {
        &self.cargo
    }

    /// Where cargo builds, and we too.
    pub(crate) fn target(&self) -> PathBuf {
        let configured = std::env::var_os("CARGO_TARGET_DIR").map(PathBuf::from);
        self.root.join(configured.unwrap_or_else(|| "target".into()))
    }

    /// The virtual environment of the Python tests.
    pub(crate) fn venv(&self) -> PathBuf {
        self.root.join(".venv")
    }

    /// The Python of that environment.
    pub(crate) fn venv_python(&self) -> PathBuf {
        self.venv().join(PYTHON)
    }

    /// The pinned requirements of the Python tests.
    pub(crate) fn requirements(&self) -> PathBuf {
        self.root.join("tests/python/requirements.txt")
    }
}

/// Whether a program of this name can be found on `PATH`.
pub(crate) fn on_path(program: &str) -> bool {
    std::env::var_os("PATH").is_some_and(|path| in_folders(program, std::env::split_paths(&path)))
}

fn in_folders(program: &str, folders: impl IntoIterator<Item = PathBuf>) -> bool {
    folders
        .into_iter()
        .any(|folder| is_program(&folder.join(format!("{program}{}", std::env::consts::EXE_SUFFIX))))
}

#[cfg(unix)]
fn is_program(file: &Path) -> bool {
    use std::os::unix::fs::PermissionsExt;
    file.metadata().is_ok_and(|m| m.is_file() && m.permissions().mode() & 0o111 != 0)
}

#[cfg(not(unix))]
fn is_program(file: &Path) -> bool {
    file.is_file()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_executable_files_count_as_programs() {
        let own = std::env::current_exe().unwrap();
        let (folder, name) =
            (own.parent().unwrap().to_path_buf(), own.file_stem().unwrap().to_str().unwrap());
        assert!(in_folders(name, [folder.clone()]));
        assert!(!in_folders("no-such-program", [folder]));
        let sources = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
        assert!(!in_folders("Cargo.toml", [sources.clone()]));
        assert!(!in_folders("src", [sources]));
    }
}
