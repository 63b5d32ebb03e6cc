//! What is handed to others, in target/dist: the program in an archive, the same bytes whoever builds it.

pub(crate) mod reproducible;
pub(crate) mod wheels;

use std::path::{Path, PathBuf};

use crate::error::XtaskError;
use crate::python::interpreter;
use crate::run::Step;
use crate::rust;
use crate::supply::tool;
use crate::systems::{WINDOWS, ensure_mingw};
use crate::tasks::cargo;
use crate::workspace::Workspace;

/// Cargo builds in a folder of this name.
pub(crate) const PROFILE: &str = "shipped";

/// The hour of whatever is built, in seconds of 1970: that of the files in the archives, 1980 being the first year a zip file can name.
const HOUR: &str = "315532800";

/// Folder of what is released.
pub(crate) fn folder(workspace: &Workspace) -> PathBuf {
    workspace.target().join("dist")
}

/// Builds the program for a target, this machine's by default, and packs it.
pub(crate) fn run(workspace: &Workspace, target: Option<&str>) -> Result<(), XtaskError> {
    let host = rust::host()?;
    let target = target.unwrap_or(&host);
    if target != host && target != WINDOWS {
        return Err(XtaskError::Missing {
            step: "build the release".into(),
            what: format!("{target} cannot be built on {host}"),
            remedy: format!(
                "take none, for {host}, or {WINDOWS}; the workflow `release` has a machine for each system"
            ),
        });
    }
    if target != host && !rust::add_target(target) {
        return Err(XtaskError::Missing {
            step: "build the release".into(),
            what: format!("there is no standard library for {target}"),
            remedy: format!("rustup target add {target}"),
        });
    }
    ensure_mingw("build the release", target)?;
    let built = build(workspace, target)?;
    let runs_here = if target == host { built.clone() } else { runs_here(workspace)? };
    archive(workspace, target, &built, &runs_here)?;
    let name = format!("soilctl-{}-{target}.cdx.json", rust::of_workspace(workspace, "version")?);
    write("bill of materials", &folder(workspace), &name, &bill_of_materials(workspace, "cli", target)?)?;
    checksums(workspace)
}

/// A program that tells the completions and man pages, which are the same for all systems, where the one for another system cannot.
/// Built as for tests: this costs less than a release, and nothing where it was built already.
fn runs_here(workspace: &Workspace) -> Result<PathBuf, XtaskError> {
    let name = "build what tells completions and man pages";
    cargo(workspace, name).args(["build", "--locked", "--package", "soilctl"]).run()?;
    Ok(workspace.target().join("debug").join(format!("soilctl{}", std::env::consts::EXE_SUFFIX)))
}

/// The program, with its symbols.
pub(crate) fn build(workspace: &Workspace, target: &str) -> Result<PathBuf, XtaskError> {
    same_bytes(workspace, cargo(workspace, "build the release"))
        .args(["build", "--locked", "--profile", PROFILE, "--package", "soilctl", "--target", target])
        .run()?;
    let program = if target.contains("windows") { "soilctl.exe" } else { "soilctl" };
    Ok(workspace.target().join(target).join(PROFILE).join(program))
}

/// A build whose bytes do not tell in which folders and when it was made.
fn same_bytes(workspace: &Workspace, step: Step) -> Step {
    let home = std::env::var_os("CARGO_HOME")
        .map(PathBuf::from)
        .or_else(|| Some(std::env::home_dir()?.join(".cargo")));
    let root = Some(workspace.root().to_path_buf());
    // The last that fits holds, and what is built may be elsewhere.
    let folders = [(root, "/soilctl"), (Some(workspace.target()), "/soilctl/target"), (home, "/cargo")];
    let folders = || folders.iter().filter_map(|(folder, name)| Some((folder.as_ref()?.display(), name)));
    let rust: Vec<String> = folders().map(|(from, to)| format!("--remap-path-prefix={from}={to}")).collect();
    let c: Vec<String> = folders().map(|(from, to)| format!("'-ffile-prefix-map={from}={to}'")).collect();
    // Separated, and quoted, so that a folder may have a blank in its name.
    let step = step.env("CARGO_ENCODED_RUSTFLAGS", rust.join("\u{1f}")).env("CARGO_INCREMENTAL", "0");
    // The linker writes the hour into programs for Windows.
    let step = step.env("SOURCE_DATE_EPOCH", HOUR);
    if cfg!(windows) { step } else { step.env("CFLAGS", c.join(" ")).env("CC_SHELL_ESCAPED_FLAGS", "1") }
}

fn archive(workspace: &Workspace, target: &str, built: &Path, runs_here: &Path) -> Result<(), XtaskError> {
    let objcopy = objcopy()?;
    Step::new("pack the release", interpreter()?)
        .args(["packaging/archive.py", "--target", target, "--version"])
        .args([rust::of_workspace(workspace, "version")?])
        .args(["--program".as_ref(), built.as_os_str(), "--runs-here".as_ref(), runs_here.as_os_str()])
        .args(["--objcopy".as_ref(), objcopy.as_os_str(), "--out".as_ref(), folder(workspace).as_os_str()])
        .args(["--cargo"])
        .args([workspace.cargo()])
        .dir(workspace.root())
        .run()
}

/// It comes with the compiler.
fn objcopy() -> Result<PathBuf, XtaskError> {
    let libraries = Step::new("ask the compiler", "rustc").args(["--print", "target-libdir"]).output()?;
    let name = format!("rust-objcopy{}", std::env::consts::EXE_SUFFIX);
    Ok(Path::new(libraries.trim()).with_file_name("bin").join(name))
}

/// CycloneDX, by the tool of its own project: what a crate is made of, as text.
pub(crate) fn bill_of_materials(
    workspace: &Workspace,
    package: &str,
    target: &str,
) -> Result<String, XtaskError> {
    let step = "bill of materials";
    let cyclonedx = tool(workspace, "cargo-cyclonedx", "0.5.9")?;
    let name = format!("bill-of-{target}");
    Step::new(step, cyclonedx)
        .args(["cyclonedx", "--format", "json", "--spec-version", "1.5", "--target", target])
        .args(["--override-filename", &name, "--manifest-path"])
        .args([workspace.root().join("crates").join(package).join("Cargo.toml")])
        .dir(workspace.root())
        // It says when, otherwise.
        .env("SOURCE_DATE_EPOCH", "0")
        .run()?;
    let name = format!("{name}.json");
    let made = workspace.root().join("crates").join(package).join(&name);
    let text = std::fs::read_to_string(&made).map_err(|problem| XtaskError::file(step, &made, problem))?;
    // It wrote one beside the manifest of each crate.
    for crates in [workspace.root().to_path_buf(), workspace.root().join("crates")] {
        let entries =
            std::fs::read_dir(&crates).map_err(|problem| XtaskError::file(step, &crates, problem))?;
        for file in
            entries.filter_map(|entry| Some(entry.ok()?.path().join(&name))).filter(|file| file.is_file())
        {
            std::fs::remove_file(&file).map_err(|problem| XtaskError::file(step, &file, problem))?;
        }
    }
    Ok(anywhere(&text, workspace.root()))
}

/// Writes a file into a folder, which is made if there is none.
pub(crate) fn write(step: &str, folder: &Path, name: &str, text: &str) -> Result<PathBuf, XtaskError> {
    let file = folder.join(name);
    std::fs::create_dir_all(folder)
        .and_then(|()| std::fs::write(&file, text))
        .map_err(|problem| XtaskError::file(step, &file, problem))?;
    Ok(file)
}

/// The bill without the folder of the checkout, by which it names our own crates.
fn anywhere(bill: &str, root: &Path) -> String {
    let root = root.display().to_string().replace('\\', "/").replace(' ', "%20");
    bill.replace(&format!("file:///{}", root.trim_start_matches('/')), "file:///soilctl")
}

/// One list of all that lies there.
pub(crate) fn checksums(workspace: &Workspace) -> Result<(), XtaskError> {
    Step::new("checksums", interpreter()?)
        .args(["packaging/checksums.py".into(), folder(workspace)])
        .dir(workspace.root())
        .run()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bill_does_not_tell_where_it_was_made() {
        let told = |folder: &str| format!("\"path+file:///{folder}/crates/cli#soilctl@0.1.0\"");
        for (root, folder) in [("/a/b c", "a/b%20c"), ("C:\\a\\b", "C:/a/b")] {
            assert_eq!(anywhere(&told(folder), Path::new(root)), told("soilctl"));
        }
    }
}
