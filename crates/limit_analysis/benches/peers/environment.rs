//! An environment of Python for what benchmarks compare with.

use std::path::{Path, PathBuf};
use std::process::Command;

/// Its interpreter, with the packages that `requirements.txt` in a folder pins.
pub(crate) fn python(folder: &Path) -> PathBuf {
    let environment =
        PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(concat!(env!("CARGO_CRATE_NAME"), "-venv"));
    let python = environment.join("bin/python");
    let run = |command: &mut Command| assert!(command.status().unwrap().success(), "{command:?}");
    if !python.exists() {
        run(Command::new("python3").args(["-m", "venv"]).arg(&environment));
    }
    let requirements = folder.join("requirements.txt");
    run(Command::new(&python).args(["-m", "pip", "install", "--quiet", "-r"]).arg(requirements));
    python
}
