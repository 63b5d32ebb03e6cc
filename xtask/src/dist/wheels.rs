//! Wheels of the Python package for systems other than the one that builds them: old ones of Linux, both processors of a Mac, Windows.

use crate::error::XtaskError;
use crate::python::Environment;
use crate::run::Step;
use crate::rust;
use crate::systems::WINDOWS;
use crate::workspace::Workspace;

/// Of one ABI for all Pythons from 3.10 on. Without a target: on Linux for the oldest glibc that works and for musl, on a Mac for both
/// processors, on Windows for it.
pub(crate) fn run(workspace: &Workspace, target: Option<&str>) -> Result<(), XtaskError> {
    let host = rust::host()?;
    let targets = match target {
        Some(target) => vec![target.to_owned()],
        None if host.ends_with("linux-gnu") => vec![host.clone(), host.replace("gnu", "musl")],
        None if host.contains("apple") => vec!["universal2-apple-darwin".into()],
        None => vec![host.clone()],
    };
    if let Some(target) = targets.iter().find(|target| target.contains("apple") && !host.contains("apple")) {
        return Err(XtaskError::Missing {
            step: "build wheels".into(),
            what: format!("{target} cannot be built on {host}: what it links against is in Apple's SDK"),
            remedy: "build it on a Mac; the workflow `release` has one".into(),
        });
    }
    let environment = Environment::new(workspace.target().join("maturin-zig"));
    environment.ensure_tools(&["maturin==1.16.0", "ziglang==0.15.2", "auditwheel==6.8.2"])?;
    let folder = super::folder(workspace);
    for target in &targets {
        let parts = match target.as_str() {
            "universal2-apple-darwin" => vec!["aarch64-apple-darwin", "x86_64-apple-darwin"],
            one => vec![one],
        };
        if !parts.into_iter().all(rust::add_target) {
            return Err(XtaskError::Missing {
                step: "build wheels".into(),
                what: format!("there is no standard library for {target}"),
                remedy: "see `rustup target list`".into(),
            });
        }
        let compatibility: &[&str] = match target.as_str() {
            linux if linux.ends_with("linux-gnu") => &["--zig", "--compatibility", "manylinux2014"],
            linux if linux.ends_with("linux-musl") => &["--zig", "--compatibility", "musllinux_1_2"],
            _ => &[],
        };
        let step = super::same_bytes(workspace, Step::new("build wheels", environment.python()))
            .args(["-m", "maturin", "build", "--profile", super::PROFILE, "--locked", "--strip"])
            .args(["--manifest-path", "crates/py/Cargo.toml", "--target", target, "--out"])
            .args([&folder])
            .args(compatibility)
            // Where maturin looks for zig.
            .env("PATH", environment.path())
            .dir(workspace.root());
        if target == WINDOWS { step.env("PYO3_CROSS_PYTHON_VERSION", "3.10") } else { step }.run()?;
    }
    super::checksums(workspace)
}
