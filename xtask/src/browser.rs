//! The workbench for any static host: the page of `soilctl workbench`, solved by the same program as a module for browsers.

use std::path::{Path, PathBuf};

use crate::error::XtaskError;
use crate::rust;
use crate::systems::WASM;
use crate::tasks::cargo;
use crate::wheel::empty;
use crate::workspace::Workspace;

const STEP: &str = "the workbench in a browser";

/// How the page begins, and how it does where it has no server: it is told so, and what it may load, which a server tells in a header.
const HEAD: &str = "<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n";
const INSIDE: &str = "<html lang=\"en\" data-solver=\"inside\">\n<head>\n<meta charset=\"utf-8\">\n\
    <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; \
    style-src 'self'; connect-src 'self'; worker-src 'self' blob:; img-src data: blob:; base-uri 'none'; form-action 'none'\">\n";

/// Makes it in a folder of its own, which is emptied first.
pub(crate) fn make(workspace: &Workspace, folder: &Path) -> Result<(), XtaskError> {
    if !rust::add_target(WASM) {
        return Err(XtaskError::Missing {
            step: STEP.into(),
            what: format!("there is no standard library for {WASM}"),
            remedy: format!("install rustup (https://rustup.rs), or let it run `rustup target add {WASM}`"),
        });
    }
    let module = module(workspace)?;
    empty(STEP, folder)?;
    let page = workspace.root().join("crates/workbench/page");
    let own = workspace.root().join("crates/wasm/page");
    let mut files = vec!["./".to_owned()];
    for entry in std::fs::read_dir(&page).map_err(|problem| XtaskError::file(STEP, &page, problem))? {
        let path = entry.map_err(|problem| XtaskError::file(STEP, &page, problem))?.path();
        let name = path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
        if name.ends_with(".html") {
            let own = if name == "page.html" { "index.html" } else { &name };
            write(&folder.join(own), inside(&read(&path)?)?.as_bytes())?;
        } else {
            write(&folder.join(&name), read(&path)?.as_bytes())?;
        }
        // The first page is what the folder itself answers with.
        if name != "page.html" {
            files.push(name);
        }
    }
    // Script and worker are one file, so that workers need no network.
    let script = read(&module.join("engine.js"))? + &read(&own.join("worker.js"))?;
    write(&folder.join("engine.js"), script.as_bytes())?;
    let bytes = module.join("engine_bg.wasm");
    let bytes = std::fs::read(&bytes).map_err(|problem| XtaskError::file(STEP, &bytes, problem))?;
    write(&folder.join("engine.wasm"), &bytes)?;
    files.extend(["engine.js".to_owned(), "engine.wasm".to_owned()]);
    // Folders are listed in no order.
    files.sort();
    let list = format!("const FILES = {files:?};\n");
    write(&folder.join("offline.js"), (list + &read(&own.join("offline.js"))?).as_bytes())
}

/// The module and the script that loads it, in a folder.
fn module(workspace: &Workspace) -> Result<PathBuf, XtaskError> {
    cargo(workspace, "the module")
        .args(["build", "--locked", "--profile", "wasm", "--target", WASM, "--package", "soilctl-wasm"])
        .run()?;
    let built = workspace.target().join(WASM).join("wasm/soilctl_wasm.wasm");
    let folder = workspace.target().join("wasm-bindgen");
    cargo(workspace, "the module's script")
        .args([
            "run",
            "--locked",
            "--quiet",
            "--manifest-path",
            "crates/wasm/bindgen/Cargo.toml",
            "--target-dir",
        ])
        .args([folder.join("program").into_os_string(), "--".into(), built.into()])
        .args([folder.join("module")])
        .run()?;
    Ok(folder.join("module"))
}

fn inside(page: &str) -> Result<String, XtaskError> {
    if page.contains(HEAD) {
        return Ok(page.replacen(HEAD, INSIDE, 1));
    }
    Err(XtaskError::Missing {
        step: STEP.into(),
        what: format!("the page does not begin with {HEAD:?}"),
        remedy: "see crates/workbench/page/page.html, and this constant in xtask/src/browser.rs".into(),
    })
}

fn read(path: &Path) -> Result<String, XtaskError> {
    std::fs::read_to_string(path).map_err(|problem| XtaskError::file(STEP, path, problem))
}

fn write(path: &Path, bytes: &[u8]) -> Result<(), XtaskError> {
    let made = path.parent().map_or(Ok(()), std::fs::create_dir_all);
    made.and_then(|()| std::fs::write(path, bytes)).map_err(|problem| XtaskError::file(STEP, path, problem))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_page_is_told_that_it_has_no_server() {
        for name in ["page.html", "plate.html"] {
            let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../crates/workbench/page").join(name);
            let page = inside(&std::fs::read_to_string(file).unwrap()).unwrap();
            assert!(page.contains("data-solver=\"inside\"") && page.contains("wasm-unsafe-eval"));
        }
        assert!(inside("<html>").is_err());
    }

    #[test]
    fn module_and_script_are_of_one_version() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let version = |file: &str, before: &str| {
            let text = std::fs::read_to_string(root.join(file)).unwrap();
            text.split(before).nth(1).unwrap().split('"').next().unwrap().to_owned()
        };
        assert_eq!(
            version("Cargo.toml", "\nwasm-bindgen = \"="),
            version("crates/wasm/bindgen/Cargo.toml", "wasm-bindgen-cli-support = \"=")
        );
    }
}
