//! Other toolchains and targets, by rustup.

use crate::error::XtaskError;
use crate::run::Step;
use crate::workspace::{Workspace, on_path};

/// Builds the workspace with the Rust that `rust-version` names.
pub(crate) fn msrv(workspace: &Workspace) -> Result<(), XtaskError> {
    let version = rust_version(workspace)?;
    toolchain(&version)?;
    with(&version, "build with the oldest Rust")
        .args(["build", "--workspace", "--locked", "--target-dir"])
        .args([workspace.target().join("msrv")])
        .dir(workspace.root())
        .run()
}

/// Makes sure that a toolchain is there.
pub(crate) fn toolchain(name: &str) -> Result<(), XtaskError> {
    if !on_path("rustup") {
        return Err(XtaskError::Missing {
            step: "install Rust".into(),
            what: format!("Rust {name} is needed beside the one that runs this, and there is no rustup"),
            remedy: "install rustup (https://rustup.rs)".into(),
        });
    }
    if with(name, "try Rust").args(["--version"]).succeeds() {
        return Ok(());
    }
    let install = Step::new("install Rust", "rustup").args(["toolchain", "install", name]);
    install.args(["--profile", "minimal", "--no-self-update"]).run()
}

/// The cargo of a toolchain.
pub(crate) fn with(toolchain: &str, name: &str) -> Step {
    Step::new(name, "rustup").args(["run", toolchain, "cargo"])
}

/// Adds the standard library of a target; false, and a word about it, where it cannot be had.
pub(crate) fn add_target(target: &str) -> bool {
    let there =
        on_path("rustup") && Step::new("add a target", "rustup").args(["target", "add", target]).succeeds();
    if !there {
        eprintln!("== {target} is left out: rustup cannot add it here");
    }
    there
}

/// The system that the compiler is on.
pub(crate) fn host() -> Result<String, XtaskError> {
    let told = Step::new("ask the compiler", "rustc").args(["-vV"]).output()?;
    told.lines().find_map(|line| line.strip_prefix("host: ")).map(str::to_owned).ok_or_else(|| {
        XtaskError::Missing {
            step: "ask the compiler".into(),
            what: "rustc does not say on which system it is".into(),
            remedy: "see `rustc -vV`".into(),
        }
    })
}

fn rust_version(workspace: &Workspace) -> Result<String, XtaskError> {
    of_workspace(workspace, "rust-version")
}

/// A text that the top manifest states for all crates.
pub(crate) fn of_workspace(workspace: &Workspace, key: &str) -> Result<String, XtaskError> {
    let (step, file) = ("read the manifest", workspace.root().join("Cargo.toml"));
    let text = std::fs::read_to_string(&file).map_err(|problem| XtaskError::file(step, &file, problem))?;
    value(&text, key).ok_or_else(|| XtaskError::Missing {
        step: step.into(),
        what: format!("Cargo.toml has no {key}"),
        remedy: "state it under [workspace.package]".into(),
    })
}

fn value(manifest: &str, key: &str) -> Option<String> {
    let package = manifest.split("[workspace.package]").nth(1)?;
    let lines = package.lines().skip(1).take_while(|line| !line.starts_with('['));
    let mut values = lines.filter_map(|line| line.split_once('=').filter(|(word, _)| word.trim() == key));
    values.next()?.1.split('"').nth(1).map(str::to_owned)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_manifest_is_asked_for_the_workspace_only() {
        let text = "[a]\nversion = \"9\"\n[workspace.package]\nversion = \"1.2\" # it\n[b]\nother = \"3\"\n";
        assert_eq!(value(text, "version").as_deref(), Some("1.2"));
        assert_eq!(value(text, "other"), None);
    }
}
