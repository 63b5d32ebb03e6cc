use std::collections::BTreeMap;

use soilctl_mesh::{Budget, Mesh, MeshError, Sought, load};
use soilctl_robot::{Geometry, Urdf};

/// Different files that are read for one robot.
const MOST_FILES: usize = 500;
/// Files of which it is said why they are not drawn.
const TOLD: usize = 5;

/// Reads the meshes that a URDF names, each once, and says of those that cannot be drawn why.
#[must_use]
pub fn meshes(urdf: &Urdf, sought: &Sought) -> (BTreeMap<String, Mesh>, Vec<String>) {
    let (mut found, mut missing, mut notes) = (BTreeMap::new(), Vec::new(), Vec::new());
    let mut budget = Budget::default();
    let mut names: Vec<&str> = Vec::new();
    for visual in urdf.links().iter().flat_map(|link| &link.visuals) {
        if let Geometry::Mesh { filename, .. } = &visual.geometry {
            names.push(filename);
        }
    }
    names.sort_unstable();
    names.dedup();
    let left_out = names.len().saturating_sub(MOST_FILES);
    for name in names.into_iter().take(MOST_FILES) {
        match load(name, sought, &mut budget) {
            Ok(mesh) => drop(found.insert(name.to_owned(), mesh)),
            Err(MeshError::Missing { .. }) => missing.push(name),
            Err(problem) => notes.push(problem.to_string()),
        }
    }
    let more = notes.len().saturating_sub(TOLD);
    notes.truncate(TOLD);
    if more > 0 {
        notes.push(format!("{more} more meshes cannot be drawn"));
    }
    if let Some(first) = missing.first() {
        let what = match missing.len() {
            1 => format!("the mesh {} is not at hand", cut(first)),
            count => format!("{count} meshes are not at hand, the first is {}", cut(first)),
        };
        notes.push(format!("{what}; such links are drawn as bones; give the folder with --mesh-root"));
    }
    if left_out > 0 {
        notes.push(format!("{left_out} meshes are left out, beside {MOST_FILES} others"));
    }
    (found, notes)
}

/// What a stranger's file calls something may be of any length.
fn cut(name: &str) -> String {
    name.chars().filter(|letter| !letter.is_control()).take(200).collect()
}
