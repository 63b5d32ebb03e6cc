//! The targets of fuzz/: compiled as ordinary programs here, run by cargo-fuzz with nightly Rust.

use crate::error::XtaskError;
use crate::rust;
use crate::supply::tool;
use crate::tasks::cargo;
use crate::workspace::Workspace;

const TARGETS: [&str; 4] = ["recording", "urdf", "mesh", "heights"];

/// How long each target runs.
///
/// # Errors
///
/// Words that are no number of seconds.
pub(crate) fn seconds(words: &[String]) -> Result<u32, String> {
    match words {
        [] => Ok(60),
        [word] => word.parse().map_err(|_| format!("fuzz takes whole seconds, but got {word}")),
        _ => Err(format!("fuzz takes one number, but got {}", words.join(" "))),
    }
}

/// Whether they compile.
pub(crate) fn check(workspace: &Workspace) -> Result<(), XtaskError> {
    // A workspace of its own: its instrumentation is not for the others.
    cargo(workspace, "fuzz targets").args(["check", "--locked", "--manifest-path", "fuzz/Cargo.toml"]).run()
}

/// Runs each; what it finds is left in fuzz/artifacts.
pub(crate) fn run(workspace: &Workspace, seconds: u32) -> Result<(), XtaskError> {
    let fuzz = tool(workspace, "cargo-fuzz", "0.13.2")?;
    rust::toolchain("nightly")?;
    for target in TARGETS {
        crate::run::Step::new(target, "rustup")
            .args(["run".as_ref(), "nightly".as_ref(), fuzz.as_os_str()])
            .args(["run", target, "--", "-timeout=60", "-rss_limit_mb=4096"])
            .args([format!("-max_total_time={seconds}")])
            .dir(workspace.root())
            .run()?;
    }
    Ok(())
}
