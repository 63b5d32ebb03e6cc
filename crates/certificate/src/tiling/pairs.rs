use super::after;
use crate::CertificateError;
use crate::mesh::{Mesh, Side};

/// For each triangle edge, the edge with the same vertices in the opposite sense. Each directed edge occurs once.
pub(super) fn across(mesh: &Mesh) -> Result<Vec<[Option<Side>; 3]>, CertificateError> {
    let mut edges: Vec<([usize; 2], Side)> = Vec::with_capacity(3 * mesh.triangles.len());
    for (triangle, t) in mesh.triangles.iter().enumerate() {
        for corner in 0..3 {
            let ends = [t.corners[after(corner, 1)], t.corners[after(corner, 2)]];
            edges.push((ends, Side { triangle, corner }));
        }
    }
    edges.sort_unstable();
    if let Some(pair) = edges.windows(2).find(|w| w[0].0 == w[1].0) {
        let place = format!("{} and {}", pair[0].1, pair[1].1);
        return Err(CertificateError::BadMesh { place, problem: "the same edge in the same sense" });
    }
    let mut across = vec![[None; 3]; mesh.triangles.len()];
    for ([a, b], side) in &edges {
        let other = edges.binary_search_by_key(&[*b, *a], |e| e.0).ok();
        across[side.triangle][side.corner] = other.map(|i| edges[i].1);
    }
    Ok(across)
}
