//! Wheels of the Python package for systems other than the one that builds them: old ones of Linux, both processors of a Mac, Windows.

use std::path::{Path, PathBuf};

use crate::error::XtaskError;
use crate::python::Environment;
use crate::run::Step;
use crate::rust;
use crate::systems::{WINDOWS, ensure_mingw};
use crate::wheel;
use crate::workspace::Workspace;

const STEP: &str = "build wheels";

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
            step: STEP.into(),
            what: format!("{target} cannot be built on {host}: what it links against is in Apple's SDK"),
            remedy: "build it on a Mac; the workflow `release` has one".into(),
        });
    }
    let environment = Environment::new(workspace.target().join("maturin-zig"));
    environment.ensure_tools(&["maturin==1.16.0", "ziglang==0.15.2", "auditwheel==6.8.2"])?;
    let folder = super::folder(workspace);
    let mut of_this_system = Vec::new();
    for target in &targets {
        let parts = match target.as_str() {
            "universal2-apple-darwin" => vec!["aarch64-apple-darwin", "x86_64-apple-darwin"],
            one => vec![one],
        };
        if !parts.iter().copied().all(rust::add_target) {
            return Err(XtaskError::Missing {
                step: STEP.into(),
                what: format!("there is no standard library for {target}"),
                remedy: "see `rustup target list`".into(),
            });
        }
        ensure_mingw(STEP, target)?;
        let compatibility: &[&str] = match target.as_str() {
            linux if linux.ends_with("linux-gnu") => &["--zig", "--compatibility", "manylinux2014"],
            linux if linux.ends_with("linux-musl") => &["--zig", "--compatibility", "musllinux_1_2"],
            _ => &[],
        };
        let bills = bills(workspace, &parts)?;
        let built = workspace.target().join("wheels-of").join(target);
        wheel::empty(STEP, &built)?;
        let step = super::same_bytes(workspace, Step::new(STEP, environment.python()))
            .args(["-m", "maturin", "build", "--profile", super::PROFILE, "--locked", "--strip"])
            .args(["--manifest-path", "crates/py/Cargo.toml", "--target", target, "--out"])
            .args([&built])
            .args(compatibility)
            // Maturin's own, switched off in pyproject.toml, would name the folder of the checkout.
            .args(bills.iter().flat_map(|bill| ["--sbom-include".as_ref(), bill.as_os_str()]))
            // Where maturin looks for zig.
            .env("PATH", environment.path())
            .dir(workspace.root());
        if target == WINDOWS { step.env("PYO3_CROSS_PYTHON_VERSION", "3.10") } else { step }.run()?;
        let kept = keep(&wheel::only_wheel(STEP, &built)?, &folder)?;
        if parts.contains(&host.as_str()) {
            of_this_system.push(kept);
        }
    }
    audit(&environment, &folder)?;
    of_this_system.iter().try_for_each(|built| wheel::try_out(workspace, built))?;
    super::checksums(workspace)
}

/// Puts a wheel where the release is.
fn keep(wheel: &Path, folder: &Path) -> Result<PathBuf, XtaskError> {
    let kept = folder.join(wheel.file_name().unwrap_or_default());
    std::fs::create_dir_all(folder)
        .and_then(|()| std::fs::copy(wheel, &kept))
        .map_err(|problem| XtaskError::file(STEP, &kept, problem))?;
    Ok(kept)
}

/// What is in a wheel, for each processor that it is for.
fn bills(workspace: &Workspace, targets: &[&str]) -> Result<Vec<PathBuf>, XtaskError> {
    let folder = workspace.target().join("bills");
    let bill = |target: &&str| {
        let text = super::bill_of_materials(workspace, "py", target)?;
        super::write("bill of materials", &folder, &format!("soilctl-{target}.cdx.json"), &text)
    };
    targets.iter().map(bill).collect()
}

/// Whether each wheel for Linux runs with C libraries as old as its name promises, by auditwheel: maturin has checks of its own, and this
/// is the one that others use.
fn audit(environment: &Environment, folder: &Path) -> Result<(), XtaskError> {
    let step = "check the wheels";
    let entries = std::fs::read_dir(folder).map_err(|problem| XtaskError::file(step, folder, problem))?;
    let mut wheels: Vec<PathBuf> = entries.filter_map(|entry| Some(entry.ok()?.path())).collect();
    wheels.retain(|file| file.extension().is_some_and(|ending| ending == "whl"));
    wheels.sort();
    for wheel in wheels {
        let name = wheel.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let Some(promised) = c_library(&name) else { continue };
        // Only what the wheel names: among this system's own libraries may be a `libc.so` that is a script for linkers.
        let told = Step::new(step, environment.python()).args([
            "-m",
            "auditwheel",
            "show",
            "--json",
            "--ldpaths",
            "",
        ]);
        let told = told.args([&wheel]).output()?;
        let tag = serde_json::from_str::<serde_json::Value>(&told)
            .ok()
            .and_then(|told| tag(&told))
            .unwrap_or_default();
        if c_library(&tag).is_none_or(|needed| needed.0 != promised.0 || needed > promised) {
            return Err(XtaskError::Missing {
                step: step.into(),
                what: format!(
                    "{name} is of the tag {tag:?}, says auditwheel, which is not what its name promises"
                ),
                remedy: "see which library or symbol asks for more, with `auditwheel show --verbose`".into(),
            });
        }
        eprintln!("== {name}: auditwheel says {tag}");
    }
    Ok(())
}

/// The tag that auditwheel gives a wheel. It knows musl's C library by the name that Alpine gives it; what is linked with zig has musl's own
/// name for it, `libc.so`, which its loader takes for itself. So where nothing else is asked for, that of the symbols counts.
fn tag(told: &serde_json::Value) -> Option<String> {
    let is_musl = told["sym_tag"].as_str().is_some_and(|tag| tag.contains("musllinux"));
    let asks_for = told["external_libs"].as_object()?;
    let only_musl = is_musl && asks_for.keys().all(|library| library == "libc.so");
    told[if only_musl { "sym_tag" } else { "overall_tag" }].as_str().map(str::to_owned)
}

/// The C library and its version of a tag such as `manylinux_2_17_x86_64`, or of the first in a wheel's name.
fn c_library(tag: &str) -> Option<(&str, u32, u32)> {
    ["manylinux", "musllinux"].into_iter().find_map(|library| {
        let mut numbers = tag.split(&format!("{library}_")).nth(1)?.split('_');
        Some((library, numbers.next()?.parse().ok()?, numbers.next()?.parse().ok()?))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_library_of_its_own_is_no_dependency_of_musl() {
        let told = |libraries: serde_json::Value| {
            serde_json::json!({
                "overall_tag": "linux_x86_64", "sym_tag": "musllinux_1_2_x86_64", "external_libs": libraries
            })
        };
        let musl = serde_json::json!({ "libc.so": null });
        assert_eq!(tag(&told(musl)).as_deref(), Some("musllinux_1_2_x86_64"));
        let more = serde_json::json!({ "libc.so": null, "libgcc_s.so.1": null });
        assert_eq!(tag(&told(more)).as_deref(), Some("linux_x86_64"));
    }

    #[test]
    fn a_wheel_tells_its_c_library() {
        let wheel = "soilctl-0.1.0-cp310-abi3-manylinux2014_x86_64.manylinux_2_17_x86_64.whl";
        assert_eq!(c_library(wheel), Some(("manylinux", 2, 17)));
        assert_eq!(
            c_library("soilctl-0.1.0-cp310-abi3-musllinux_1_2_aarch64.whl"),
            Some(("musllinux", 1, 2))
        );
        assert_eq!(c_library("soilctl-0.1.0-cp310-abi3-win_amd64.whl"), None);
        assert_eq!(c_library("linux_x86_64"), None);
    }
}
