//! Vertices are moved a little: in symmetric meshes whole families of stresses are as good as each other, and programs degenerate.

use super::region::{GRAIN, Region};
use super::simplices::Simplices;

/// By how much, over the shortest edge at the vertex.
const SHARE: f64 = 0.1;

/// Least volume of a tetrahedron over what it was.
const LEFT: f64 = 0.4;

/// Moves the vertices from a number on, each in the planes of box, plate and surface on which it lies.
pub(super) fn shake(mesh: &mut Simplices<3, 4>, region: &Region, from: usize) {
    let mut shortest = vec![f64::MAX; mesh.vertices.len()];
    for &[a, b] in mesh.edges() {
        let way: f64 = (0..3).map(|k| (mesh.vertices[a][k] - mesh.vertices[b][k]).powi(2)).sum();
        shortest[a] = shortest[a].min(way.sqrt());
        shortest[b] = shortest[b].min(way.sqrt());
    }
    let mut at = vec![Vec::new(); mesh.vertices.len()];
    for (i, cell) in mesh.cells.iter().enumerate() {
        cell.iter().for_each(|&c| at[c].push(i));
    }
    let mut random = Random(from as u64);
    for vertex in from..mesh.vertices.len() {
        let old = mesh.vertices[vertex];
        let before: Vec<f64> = at[vertex].iter().map(|&cell| volume(mesh, cell)).collect();
        let step: [f64; 3] = std::array::from_fn(|_| SHARE * shortest[vertex] * random.next());
        for share in [1.0, 0.5, 0.25, 0.0] {
            mesh.vertices[vertex] = std::array::from_fn(|k| {
                let moved = ((old[k] + share * step[k]) / GRAIN).round() * GRAIN;
                if region.holds(old, k) { old[k] } else { moved }
            });
            let mut after = at[vertex].iter().map(|&cell| volume(mesh, cell)).zip(&before);
            if after.all(|(after, before)| after / before > LEFT) {
                break;
            }
        }
    }
}

/// Six times the volume of a tetrahedron, with a sign.
pub(super) fn volume(mesh: &Simplices<3, 4>, cell: usize) -> f64 {
    let [o, a, b, c] = mesh.cells[cell].map(|vertex| mesh.vertices[vertex]);
    let [a, b, c]: [[f64; 3]; 3] = [a, b, c].map(|p| std::array::from_fn(|k| p[k] - o[k]));
    a[0] * (b[1] * c[2] - b[2] * c[1])
        + a[1] * (b[2] * c[0] - b[0] * c[2])
        + a[2] * (b[0] * c[1] - b[1] * c[0])
}

/// SplitMix64 (Steele, Lea & Flood 2014).
struct Random(u64);

impl Random {
    /// From -1 to 1.
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        let bits = (z ^ (z >> 31)) >> 11;
        bits as f64 / (1_u64 << 52) as f64 - 1.0
    }
}
