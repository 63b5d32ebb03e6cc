//! Meshes as pages take them: numbers of the parts, then of each part its colour, its corners and its triangles, all of 4 bytes, the lowest
//! first.

use std::sync::Arc;

use soilctl_motion::Mesh;

/// A mesh in bytes. Each part has: red, green, blue, opacity (opacity -1: the file says nothing), how many corners, how many numbers of
/// corners; then position and normal of each corner, and the numbers.
pub(crate) fn packed(mesh: &Mesh) -> Arc<[u8]> {
    let mut bytes = Vec::new();
    let mut word = |four: [u8; 4]| bytes.extend(four);
    let count = |count: usize| u32::try_from(count).unwrap_or(u32::MAX).to_le_bytes();
    word(count(mesh.parts.len()));
    for part in &mesh.parts {
        part.colour.unwrap_or([0.7, 0.7, 0.7, -1.0]).iter().for_each(|share| word(share.to_le_bytes()));
        word(count(part.points.len()));
        word(count(3 * part.triangles.len()));
        for (point, normal) in part.points.iter().zip(&part.normals) {
            point.iter().chain(normal).for_each(|value| word(value.to_le_bytes()));
        }
        part.triangles.iter().flatten().for_each(|corner| word(corner.to_le_bytes()));
    }
    bytes.into()
}

#[cfg(test)]
mod tests {
    use soilctl_motion::Part;

    use super::*;

    #[test]
    fn a_page_finds_corners_and_triangles_where_it_looks_for_them() {
        let part = Part {
            points: vec![[1.0, 2.0, 3.0], [4.0; 3], [5.0; 3]],
            normals: vec![[0.0, 0.0, 1.0]; 3],
            triangles: vec![[0, 1, 2]],
            colour: None,
        };
        let bytes = packed(&Mesh { parts: vec![part] });
        assert_eq!(bytes.len(), 4 * (1 + 6 + 3 * 6 + 3));
        let word = |k: usize| <[u8; 4]>::try_from(&bytes[4 * k..4 * k + 4]).unwrap();
        assert_eq!((u32::from_le_bytes(word(5)), u32::from_le_bytes(word(6))), (3, 3));
        assert_eq!((f32::from_le_bytes(word(4)), f32::from_le_bytes(word(8))), (-1.0, 2.0));
        assert_eq!(u32::from_le_bytes(word(27)), 2);
    }
}
