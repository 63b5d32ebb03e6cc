//! What others wrote: may we use it, and is it known to be weak?

use std::path::PathBuf;

use crate::error::XtaskError;
use crate::python::Environment;
use crate::run::Step;
use crate::workspace::Workspace;

/// The workspace, and what is made of it with tools and locks of its own: what is fuzzed is handed to nobody.
const LOCKED: [&str; 2] = ["Cargo.toml", "crates/wasm/bindgen/Cargo.toml"];

/// Licences, sources and second versions need no network; advisories are fetched.
pub(crate) fn deny(workspace: &Workspace) -> Result<(), XtaskError> {
    let deny = tool(workspace, "cargo-deny", "0.20.2")?;
    let step = |name: &str| Step::new(name, &deny).dir(workspace.root());
    for manifest in LOCKED {
        step("licences, sources, versions")
            .args(["--locked", "--manifest-path", manifest, "--config", "deny.toml"])
            .args(["check", "licenses", "sources", "bans"])
            .run()?;
    }
    if !step("fetch advisories").args(["fetch", "db"]).attempt()? {
        eprintln!("== advisories were NOT checked: their database cannot be fetched from here");
        return Ok(());
    }
    for manifest in LOCKED {
        step("advisories")
            .args(["--locked", "--manifest-path", manifest, "--config", "deny.toml", "check", "advisories"])
            .run()?;
    }
    Ok(())
}

/// The pinned packages of both environments, against PyPI's advisories.
pub(crate) fn audit(workspace: &Workspace) -> Result<(), XtaskError> {
    let environment = Environment::new(workspace.target().join("pip-audit"));
    environment.ensure_tools(&["pip-audit==2.10.1"])?;
    let reach = "import urllib.request as r; r.urlopen('https://pypi.org/pypi/pip/24.0/json', timeout=20)";
    if !Step::new("reach the advisories", environment.python()).args(["-c", reach]).succeeds() {
        eprintln!("== Python packages were NOT checked: pypi.org/pypi cannot be reached from here");
        return Ok(());
    }
    for requirements in ["tests/python/requirements.txt", "tests/python/wheel/requirements.txt"] {
        Step::new("weaknesses of Python packages", environment.python())
            .args(["-m", "pip_audit", "--disable-pip", "--no-deps", "--requirement", requirements])
            .dir(workspace.root())
            .run()?;
    }
    Ok(())
}

/// Names the folder of the tools, for a checkout that takes those of another one.
pub(crate) const TOOLS: &str = "XTASK_TOOLS";

pub(crate) fn tools(workspace: &Workspace) -> PathBuf {
    std::env::var_os(TOOLS).map_or_else(|| workspace.target().join("tools"), PathBuf::from)
}

/// A program of crates.io in this version, built once.
pub(crate) fn tool(workspace: &Workspace, name: &str, version: &str) -> Result<PathBuf, XtaskError> {
    let root = tools(workspace);
    let program = root.join(format!("bin/{name}{}", std::env::consts::EXE_SUFFIX));
    // What cargo noted: not every program tells its version.
    let installed = std::fs::read_to_string(root.join(".crates.toml")).unwrap_or_default();
    if program.is_file() && installed.contains(&format!("\"{name} {version} ")) {
        return Ok(program);
    }
    Step::new("build a tool", workspace.cargo())
        .args(["install", "--locked", "--force", name, "--version", version, "--root"])
        .args([&root])
        // Elsewhere, the settings of this workspace would be those of the tool.
        .dir(&std::env::temp_dir())
        .run()?;
    Ok(program)
}
