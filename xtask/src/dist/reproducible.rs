//! The same source, the same bytes.

use crate::error::XtaskError;
use crate::run::Step;
use crate::supply::{TOOLS, tools};
use crate::workspace::Workspace;

/// Builds the release in two folders with nothing in common, and compares all that is handed to others.
pub(crate) fn run(workspace: &Workspace) -> Result<(), XtaskError> {
    let mut lists = Vec::new();
    let mut source = workspace.root().to_path_buf();
    for (name, target) in [("first", "target"), ("the second, elsewhere", "built/here")] {
        let copy = workspace.target().join("reproducible").join(name);
        if copy.exists() {
            std::fs::remove_dir_all(&copy)
                .map_err(|problem| XtaskError::file("begin anew", &copy, problem))?;
        }
        // What is committed, as anybody has it; the second time from the first copy, whatever was committed meanwhile.
        Step::new("a copy of the source", "git")
            .args(["clone".as_ref(), "--quiet".as_ref(), source.as_os_str(), copy.as_os_str()])
            .run()?;
        Step::new("build the release", workspace.cargo())
            .args(["--locked", "xtask", "dist"])
            .dir(&copy)
            .env("CARGO_TARGET_DIR", copy.join(target))
            // What makes the bill of materials is not what is compared.
            .env(TOOLS, tools(workspace))
            .run()?;
        let list = copy.join(target).join("dist/SHA256SUMS");
        let text = std::fs::read_to_string(&list);
        lists.push(text.map_err(|problem| XtaskError::file("read the checksums", &list, problem))?);
        source = copy;
    }
    let differ: Vec<&str> =
        lists[0].lines().filter(|line| !lists[1].lines().any(|other| other == *line)).collect();
    if differ.is_empty() && lists[0].lines().count() == lists[1].lines().count() {
        eprintln!("== both builds are the same bytes:\n{}", lists[0].trim_end());
        return Ok(());
    }
    Err(XtaskError::Missing {
        step: "compare the releases".into(),
        what: format!("two builds of the same source differ: {}", differ.join(", ")),
        remedy: "compare what is in them, in target/reproducible, with diffoscope".into(),
    })
}
