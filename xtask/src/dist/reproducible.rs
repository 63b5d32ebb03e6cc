//! The same source, the same bytes.

use crate::error::XtaskError;
use crate::run::Step;
use crate::rust;
use crate::workspace::Workspace;

/// Builds the release in two folders with nothing in common, and compares the archives.
pub(crate) fn run(workspace: &Workspace) -> Result<(), XtaskError> {
    let host = rust::host()?;
    let mut archives = Vec::new();
    for name in ["first", "the second, elsewhere"] {
        let copy = workspace.target().join("reproducible").join(name);
        if copy.exists() {
            std::fs::remove_dir_all(&copy)
                .map_err(|problem| XtaskError::file("begin anew", &copy, problem))?;
        }
        // What is committed, as anybody has it.
        Step::new("a copy of the source", "git")
            .args(["clone".as_ref(), "--quiet".as_ref(), workspace.root().as_os_str(), copy.as_os_str()])
            .run()?;
        Step::new("build the release", workspace.cargo())
            .args(["--locked", "xtask", "dist"])
            .dir(&copy)
            .env("CARGO_TARGET_DIR", copy.join("target"))
            .run()?;
        let version = rust::of_workspace(workspace, "version")?;
        let archive = copy.join("target/dist").join(format!("soilctl-{version}-{host}.tar.gz"));
        let bytes = std::fs::read(&archive);
        archives.push(bytes.map_err(|problem| XtaskError::file("read the archive", &archive, problem))?);
    }
    if archives[0] == archives[1] {
        eprintln!("== both builds are the same {} bytes", archives[0].len());
        return Ok(());
    }
    Err(XtaskError::Missing {
        step: "compare the archives".into(),
        what: "two builds of the same source differ".into(),
        remedy: "compare what is in them, in target/reproducible, with diffoscope".into(),
    })
}
