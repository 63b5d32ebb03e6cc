//! Systems other than this one: what compiles for them, and the program for Windows at work.

use std::path::{Path, PathBuf};

use crate::apt;
use crate::error::XtaskError;
use crate::python::Environment;
use crate::run::Step;
use crate::rust;
use crate::tasks::{cargo, find_soilctl, setup};
use crate::workspace::{Workspace, on_path};

pub(crate) const WINDOWS: &str = "x86_64-pc-windows-gnu";
const MAC: &str = "aarch64-apple-darwin";
pub(crate) const WASM: &str = "wasm32-unknown-unknown";
const MINGW: &str = "x86_64-w64-mingw32-gcc";

/// What needs no system.
const PURE: [&str; 10] = [
    "soil",
    "earth-pressure",
    "certificate",
    "conic",
    "limit-analysis",
    "estimator",
    "diagnosis",
    "figure",
    "workbench",
    "wasm",
];

/// Checks every crate for Windows and macOS, and what needs no system for WebAssembly. What cannot be had is left out, and said.
pub(crate) fn targets(workspace: &Workspace) -> Result<(), XtaskError> {
    let check = |target: &str| {
        cargo(workspace, target)
            .args(["check", "--locked", "--target", target])
            .env("CARGO_PROFILE_DEV_DEBUG", "false")
    };
    if rust::add_target(WASM) {
        let packages = PURE.iter().flat_map(|name| ["--package".into(), format!("soilctl-{name}")]);
        check(WASM).args(packages).run()?;
    }
    if rust::add_target(WINDOWS) && has_mingw() {
        check(WINDOWS).args(["--workspace"]).run()?;
    }
    if rust::add_target(MAC) {
        let step = check(MAC).args(["--workspace"]);
        if cfg!(target_os = "macos") {
            step.run()?
        } else {
            zig(workspace, step, MAC, "aarch64-macos")?.run()?
        }
    }
    Ok(())
}

/// Builds for Windows, and tests what was built under wine: the tests of the command line, and answers, proofs and logs against those of
/// the program that was built for this system.
pub(crate) fn windows(workspace: &Workspace) -> Result<(), XtaskError> {
    if !(rust::add_target(WINDOWS) && has_mingw() && has_wine()) {
        eprintln!("== Windows was NOT tested: it needs the target, Debian's gcc-mingw-w64-x86-64 and wine64");
        return Ok(());
    }
    setup(workspace)?;
    let here = find_soilctl(workspace)?;
    cargo(workspace, "build for Windows")
        .args(["build", "--locked", "--package", "soilctl", "--target", WINDOWS])
        .run()?;
    let folder = workspace.target().join(WINDOWS).join("debug");
    let there = folder.join("soilctl.exe");
    Step::new("a library that wine lacks", MINGW)
        .args(["-shared", "-O2", "tests/windows/bcryptprimitives.c", "-ladvapi32", "-o"])
        .args([folder.join("bcryptprimitives.dll")])
        .dir(workspace.root())
        .run()?;
    Step::new("the same answers on Windows", workspace.venv_python())
        .args(["-m", "pytest", "tests/windows"])
        .dir(workspace.root())
        .env("SOILCTL", here)
        .env("SOILCTL_WINDOWS", there)
        .env("WINEDEBUG", "-all")
        .run()?;
    cargo(workspace, "command line on Windows")
        .args(["test", "--locked", "--package", "soilctl", "--target", WINDOWS])
        .env("CARGO_TARGET_X86_64_PC_WINDOWS_GNU_RUNNER", WINE)
        .env("WINEPATH", folder)
        .env("WINEDEBUG", "-all")
        .run()
}

/// Debian hides it: `wine` on the path wants the 32-bit one as well.
const WINE: &str = "/usr/lib/wine/wine64";

fn has_wine() -> bool {
    Path::new(WINE).is_file() || installed("run Windows programs", "wine64", || Path::new(WINE).is_file())
}

fn has_mingw() -> bool {
    cfg!(windows)
        || on_path(MINGW)
        || installed("build for Windows", "gcc-mingw-w64-x86-64", || on_path(MINGW))
}

/// Makes sure that there is what compiles and links C for a target, if that is Windows and this is not.
pub(crate) fn ensure_mingw(step: &str, target: &str) -> Result<(), XtaskError> {
    if target != WINDOWS || has_mingw() {
        return Ok(());
    }
    Err(XtaskError::Missing {
        step: step.into(),
        what: format!("there is no {MINGW}, which compiles and links for {target}"),
        remedy: "install it (Debian: `apt-get install gcc-mingw-w64-x86-64`)".into(),
    })
}

fn installed(step: &str, package: &str, there: impl Fn() -> bool) -> bool {
    match apt::install(step, package, &[package]) {
        Ok(()) => there(),
        Err(problem) => {
            eprintln!("== {problem}");
            false
        }
    }
}

/// A step of cargo that compiles C for another system with zig, which has the headers of all of them.
pub(crate) fn zig(workspace: &Workspace, step: Step, target: &str, triple: &str) -> Result<Step, XtaskError> {
    let environment = Environment::new(workspace.target().join("zig"));
    environment.ensure_tools(&["ziglang==0.15.2"])?;
    let folder = workspace.target().join("zig/compilers");
    let compiler =
        script(&folder.join(format!("{target}-cc")), &environment.python(), &format!("cc -target {triple}"))?;
    let archiver = script(&folder.join(format!("{target}-ar")), &environment.python(), "ar")?;
    let variable = target.replace('-', "_");
    Ok(step
        .env(&format!("CC_{variable}"), compiler)
        .env(&format!("AR_{variable}"), archiver)
        // Otherwise the SDK is looked for with a program of macOS.
        .env("SDKROOT", "/"))
}

/// What cargo's build scripts call as a compiler. They name target and SDK in words that zig does not know, and it has its own.
fn script(file: &Path, python: &Path, words: &str) -> Result<PathBuf, XtaskError> {
    let text = format!(
        "#!/bin/sh\nfor word do\n  shift\n  case $word in\n    --target=*|-isysroot|/|-mmacosx-version-min=*) ;;\n    \
         *) set -- \"$@\" \"$word\" ;;\n  esac\ndone\nexec '{}' -m ziglang {words} \"$@\"\n",
        python.display()
    );
    let write = || {
        std::fs::create_dir_all(file.parent().unwrap_or(file))?;
        std::fs::write(file, text)?;
        executable(file)
    };
    write().map_err(|problem| XtaskError::file("write a compiler's name", file, problem))?;
    Ok(file.to_path_buf())
}

#[cfg(unix)]
fn executable(file: &Path) -> std::io::Result<()> {
    use std::os::unix::fs::PermissionsExt;
    std::fs::set_permissions(file, std::fs::Permissions::from_mode(0o755))
}

#[cfg(not(unix))]
fn executable(_: &Path) -> std::io::Result<()> {
    Ok(())
}
