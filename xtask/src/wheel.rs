//! The Python package: built as a wheel, installed where nothing else is, and tested there; and the documentation, whose
//! reference is made from it.

use std::path::{Path, PathBuf};

use crate::browser;
use crate::error::XtaskError;
use crate::python::Environment;
use crate::run::Step;
use crate::tasks::setup;
use crate::workspace::Workspace;

/// What must work with the wheel and what it requires, and nothing else.
const BARE: &str =
    "import soilctl; soilctl.predict(tool_angle_deg=80, friction_angle_deg=40, interface_friction_deg=25)";

/// Makes sure that the packages that the tests of the wheel import are there.
pub(crate) fn ensure(workspace: &Workspace) -> Result<(), XtaskError> {
    environment(workspace).ensure(&requirements(workspace))
}

/// Builds the wheel and tests it.
pub(crate) fn test(workspace: &Workspace) -> Result<(), XtaskError> {
    let wheel = build(workspace)?;
    bare(workspace, &wheel)?;
    install(workspace, &wheel)?;
    tests(workspace).run()?;
    pages(workspace)
}

/// Tries a wheel that is released, on a system that it is for: alone in an empty environment, and on Linux with all tests but those of
/// the notebooks, which ask nothing else of a wheel.
pub(crate) fn try_out(workspace: &Workspace, wheel: &Path) -> Result<(), XtaskError> {
    bare(workspace, wheel)?;
    if !cfg!(target_os = "linux") {
        return Ok(());
    }
    ensure(workspace)?;
    install(workspace, wheel)?;
    tests(workspace).args(["--ignore", "tests/python/wheel/test_notebooks.py"]).run()
}

/// The documentation as a site, with what the notebooks say and the workbench.
pub(crate) fn site(workspace: &Workspace) -> Result<(), XtaskError> {
    setup(workspace)?;
    install(workspace, &build(workspace)?)?;
    // The tests keep what came of the notebooks.
    pytest(workspace, "notebooks").args(["tests/python/wheel/test_notebooks.py"]).run()?;
    pages(workspace)?;
    browser::make(workspace, &workspace.target().join("site/workbench"))
}

fn pages(workspace: &Workspace) -> Result<(), XtaskError> {
    // A warning, such as a link that leads nowhere, is an error.
    Step::new("documentation as a site", environment(workspace).python())
        .args(["-m", "mkdocs", "build", "--strict", "--config-file", "book/mkdocs.yml", "--site-dir"])
        .args([workspace.target().join("site")])
        .dir(workspace.root())
        .run()
}

/// The wheel where its tests find it.
fn install(workspace: &Workspace, wheel: &Path) -> Result<(), XtaskError> {
    environment(workspace)
        .pip("install the wheel")
        .args(["install", "--quiet", "--no-deps", "--force-reinstall"])
        .args([wheel])
        .run()
}

fn tests(workspace: &Workspace) -> Step {
    pytest(workspace, "Python tests of the wheel").args([
        "tests/python/wheel",
        "--numprocesses",
        "2",
        "--dist",
        "loadfile",
    ])
}

fn pytest(workspace: &Workspace, name: &str) -> Step {
    Step::new(name, environment(workspace).python()).args(["-m", "pytest"]).dir(workspace.root())
}

/// In the profile of the tests: a release build would compile everything once more.
fn build(workspace: &Workspace) -> Result<PathBuf, XtaskError> {
    let step = "build the wheel";
    let out = workspace.target().join("wheels");
    empty(step, &out)?;
    Step::new(step, workspace.venv_python())
        .args(["-m", "maturin", "build", "--profile", "dev", "--locked", "--compatibility", "linux"])
        .args(["--manifest-path", "crates/py/Cargo.toml", "--out"])
        .args([&out])
        .dir(workspace.root())
        .env("CARGO", workspace.cargo())
        .run()?;
    only_wheel(step, &out)
}

/// Removes a folder, so that there is one wheel in it afterwards.
pub(crate) fn empty(step: &str, folder: &Path) -> Result<(), XtaskError> {
    match std::fs::remove_dir_all(folder) {
        Err(problem) if problem.kind() != std::io::ErrorKind::NotFound => {
            Err(XtaskError::file(step, folder, problem))
        }
        _ => Ok(()),
    }
}

/// The wheel that was built into an empty folder.
pub(crate) fn only_wheel(step: &str, folder: &Path) -> Result<PathBuf, XtaskError> {
    let entries = std::fs::read_dir(folder).map_err(|problem| XtaskError::file(step, folder, problem))?;
    let mut files = entries.filter_map(|entry| Some(entry.ok()?.path()));
    let wheel = files.find(|path| path.extension().is_some_and(|ending| ending == "whl"));
    wheel.ok_or_else(|| XtaskError::Missing {
        step: step.to_owned(),
        what: format!("there is no wheel in {}", folder.display()),
        remedy: "see what maturin said above".into(),
    })
}

/// The wheel in an empty environment, with what it requires itself.
fn bare(workspace: &Workspace, wheel: &Path) -> Result<(), XtaskError> {
    let environment = Environment::new(workspace.target().join("wheel-bare"));
    environment.create()?;
    environment
        .pip("install the wheel alone")
        .args(["install", "--quiet", "--constraint"])
        .args([requirements(workspace).as_path(), wheel])
        .run()?;
    Step::new("import the package", environment.python()).args(["-c", BARE]).run()?;
    let command = environment.python().with_file_name("soilctl");
    Step::new("start the command", command).args(["--version"]).run()
}

fn environment(workspace: &Workspace) -> Environment {
    Environment::new(workspace.target().join("wheel-venv"))
}

fn requirements(workspace: &Workspace) -> PathBuf {
    workspace.root().join("tests/python/wheel/requirements.txt")
}
