//! Where the file of a mesh is.

use std::path::{Component, Path, PathBuf};

use crate::MeshError;

/// Where meshes are looked for.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Sought {
    /// Folders that hold packages, or the files of one.
    pub roots: Vec<PathBuf>,
    /// The folder of the URDF, if it came from a file.
    pub urdf_folder: Option<PathBuf>,
}

/// Folders above the URDF's that are looked into for packages.
const MOST_ABOVE: usize = 4;

/// The file of a mesh by its name in a URDF.
///
/// `package://NAME/PATH` is `NAME/PATH`, or `PATH`, below a root, or below a folder up to four above the URDF's. `file://PATH`, and absolute
/// names, are taken only below these folders, or by their last parts, since recordings come from other machines. Other names are beside the
/// URDF or below a root.
///
/// # Errors
/// [`MeshError::Missing`] if it is not there, [`MeshError::Name`] if the name leads elsewhere or is on another machine.
pub fn find(name: &str, sought: &Sought) -> Result<PathBuf, MeshError> {
    let wrong = |reason| MeshError::Name { name: name.to_owned(), reason };
    let (rest, is_package) = match name.split_once("://") {
        Some(("package", rest)) => (rest, true),
        Some(("file", rest)) => (rest, false),
        Some(_) => return Err(wrong("only package:// and file:// are looked for")),
        None => (name, false),
    };
    let rest = rest.replace('\\', "/");
    let parts: Vec<&str> = rest.split('/').filter(|part| !part.is_empty() && *part != ".").collect();
    let is_plain = |part: &&str| {
        let mut components = Path::new(part).components();
        matches!((components.next(), components.next()), (Some(Component::Normal(_)), None))
            && !part.contains('\0')
    };
    // A name may climb out of the URDF's folder, as `../meshes/a.stl` does, but not further than packages are looked for.
    let climbs = parts.iter().take_while(|part| **part == "..").count();
    let plain = parts.get(climbs..).unwrap_or_default();
    if plain.is_empty() || !plain.iter().all(is_plain) || climbs > MOST_ABOVE {
        return Err(wrong("it has parts that are no names"));
    }
    let mut candidates: Vec<PathBuf> = Vec::new();
    let below =
        |folder: &Path, parts: &[&str]| parts.iter().fold(folder.to_owned(), |path, part| path.join(part));
    let above = |folder: &Path| -> Vec<PathBuf> {
        // So that a relative folder has others above it.
        let folder = folder.canonicalize().unwrap_or_else(|_| folder.to_owned());
        folder.ancestors().take(MOST_ABOVE + 1).map(Path::to_owned).collect()
    };
    if let Some(folder) = &sought.urdf_folder {
        let folders = above(folder);
        if !is_package && let Some(from) = folders.get(climbs) {
            candidates.push(below(from, plain));
        }
        if is_package {
            candidates.extend(folders.iter().map(|folder| below(folder, plain)));
            candidates.extend(folders.iter().map(|folder| below(folder, plain.get(1..).unwrap_or_default())));
        }
    }
    for root in &sought.roots {
        // The whole name, and without its first parts: of a package its name, of a path what is above the root.
        candidates.extend((0..plain.len()).map(|skip| below(root, plain.get(skip..).unwrap_or_default())));
    }
    candidates.retain(|path| path.is_file());
    candidates.into_iter().next().ok_or_else(|| MeshError::Missing { name: name.to_owned() })
}
