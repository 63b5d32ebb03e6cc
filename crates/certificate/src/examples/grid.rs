use crate::{Mesh, Place, Triangle, Vertex};

/// A mesh of `columns` by `rows` cells, each cut in two. Vertex `(i, j)` is the `i`th from the left in the `j`th row from
/// above; `turned(i)` says whether the cells of a column are cut from their upper right to their lower left.
pub(super) fn grid(
    columns: usize,
    rows: usize,
    vertex: impl Fn(usize, usize) -> ([f64; 2], Place),
    turned: impl Fn(usize) -> bool,
) -> Mesh {
    let index = |i: usize, j: usize| i + j * (columns + 1);
    let mut mesh = Mesh::default();
    for j in 0..=rows {
        for i in 0..=columns {
            let (position, place) = vertex(i, j);
            mesh.vertices.push(Vertex { position, place });
        }
    }
    for j in 0..rows {
        for i in 0..columns {
            let (ul, ur) = (index(i, j), index(i + 1, j));
            let (ll, lr) = (index(i, j + 1), index(i + 1, j + 1));
            let halves = if turned(i) { [[ul, ll, ur], [ll, lr, ur]] } else { [[ul, ll, lr], [ul, lr, ur]] };
            mesh.triangles.extend(halves.map(|corners| Triangle { corners, region: 0 }));
        }
    }
    mesh
}
