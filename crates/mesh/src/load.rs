use std::fs::File;
use std::io::Read;
use std::path::Path;

use crate::find::{Sought, find};
use crate::shape::{MOST_BYTES, MOST_TRIANGLES, Mesh};
use crate::{MeshError, gltf, stl};

/// What may still be read for one robot.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Budget {
    triangles: u64,
    bytes: u64,
}

impl Default for Budget {
    fn default() -> Self {
        Self { triangles: MOST_TRIANGLES, bytes: MOST_BYTES }
    }
}

/// Finds and reads a mesh: STL, binary or as text, glTF or GLB, by its first bytes whatever its name. What it takes comes off the
/// budget.
///
/// # Errors
/// A [`MeshError`] that says what is missing or wrong.
pub fn load(name: &str, sought: &Sought, budget: &mut Budget) -> Result<Mesh, MeshError> {
    let path = find(name, sought)?;
    let bytes = bytes(&path, budget)?;
    let file = || path.display().to_string();
    let most = budget.triangles;
    let read = if gltf::is_gltf(&bytes) {
        let mut beside = |name: &str| {
            let place = Sought { roots: Vec::new(), urdf_folder: path.parent().map(Path::to_owned) };
            let unescaped = name.replace("%20", " ");
            let other = find(&unescaped, &place).map_err(|error| error.to_string())?;
            // So that no name leads to where nobody looked for the mesh.
            if other.parent() != path.canonicalize().ok().as_deref().and_then(Path::parent) {
                return Err(format!("{name} is not beside it"));
            }
            self::bytes(&other, budget).map_err(|error| error.to_string())
        };
        gltf::read(&bytes, most, &mut beside)
    } else if stl::is_stl(&bytes) {
        stl::read(&bytes, most)
    } else {
        return Err(MeshError::Kind { file: file() });
    };
    let mesh = read.map_err(|fault| fault.named(&path, most))?;
    budget.triangles = budget.triangles.saturating_sub(mesh.triangles());
    Ok(mesh)
}

/// A whole file, if there is room for it.
fn bytes(path: &Path, budget: &mut Budget) -> Result<Vec<u8>, MeshError> {
    let failed = |error: std::io::Error| MeshError::File {
        file: path.display().to_string(),
        reason: error.to_string(),
    };
    let mut bytes = Vec::new();
    let file = File::open(path).map_err(failed)?;
    file.take(budget.bytes + 1).read_to_end(&mut bytes).map_err(failed)?;
    if bytes.len() as u64 > budget.bytes {
        let file = path.display().to_string();
        return Err(MeshError::TooLarge { file, what: "bytes, with the meshes before it", most: MOST_BYTES });
    }
    budget.bytes -= bytes.len() as u64;
    Ok(bytes)
}
