//! Faces of triangles or tetrahedra, and what they are: on the plate, in a plane of the box, beside the surface.
//!
//! Numbers, normals and orders are those of [`SpaceStress`](soilctl_certificate::SpaceStress).

use std::collections::BTreeMap;

use super::simplices::Simplices;

/// The coordinate that is the height.
pub(super) const fn up<const N: usize>() -> usize {
    N - 1
}

/// An edge of triangles or a face of tetrahedra.
#[derive(Debug)]
pub(super) struct Face<const N: usize> {
    /// Increasing.
    pub(super) corners: [usize; N],
    /// As long as the edge, or twice the area.
    pub(super) normal: [f64; N],
    /// Its length.
    pub(super) long: f64,
    /// The axis of the plane of the box in which it is.
    pub(super) rim: Option<usize>,
    /// Its number among those on the plate.
    pub(super) plate: Option<usize>,
}

/// A simplex.
#[derive(Debug)]
pub(super) struct Cell<const M: usize> {
    pub(super) corners: [usize; M],
    /// For each corner the face opposite, and whether its normal points out (1) or in (-1).
    pub(super) faces: [usize; M],
    pub(super) signs: [f64; M],
    /// For each of these the sheet that is on this side of it.
    pub(super) sheets: [usize; M],
    /// `N!` times the volume.
    pub(super) volume: f64,
    pub(super) at_surface: bool,
}

/// A mesh with its faces. Its *sheets* are the sides of faces that have tractions of their own: all faces, then once more, for
/// the soil behind, those on the plate.
#[derive(Debug)]
pub(super) struct Complex<const N: usize, const M: usize> {
    pub(super) places: Vec<[f64; N]>,
    pub(super) cells: Vec<Cell<M>>,
    pub(super) faces: Vec<Face<N>>,
    /// The face of each sheet.
    pub(super) sheets: Vec<usize>,
    /// Least coordinates of the box.
    pub(super) low: [f64; N],
}

impl<const N: usize, const M: usize> Complex<N, M> {
    pub(super) fn new(mesh: &Simplices<N, M>) -> Self {
        let places = mesh.vertices.clone();
        let low: [f64; N] = std::array::from_fn(|k| places.iter().map(|p| p[k]).fold(f64::MAX, f64::min));
        let high: [f64; N] = std::array::from_fn(|k| places.iter().map(|p| p[k]).fold(f64::MIN, f64::max));
        let mut owners: BTreeMap<[usize; N], usize> = BTreeMap::new();
        for cell in &mesh.cells {
            (0..M).for_each(|k| *owners.entry(opposite(cell, k)).or_default() += 1);
        }
        let mut numbers = BTreeMap::new();
        let mut faces = Vec::new();
        let mut plates = Vec::new();
        for (corners, count) in owners {
            let at = corners.map(|c| places[c]);
            let normal = normal(&at);
            let all = |axis: usize, value: f64| at.iter().all(|p| p[axis] == value);
            let inside = count == 2;
            let rim = (0..N).find(|&axis| all(axis, low[axis]) || all(axis, high[axis])).filter(|_| !inside);
            let on_plate = |p: &[f64; N]| p[0] == 0.0 && p[up::<N>()] >= -1.0 && (N == 2 || p[1] <= 0.0);
            let plate = (inside && at.iter().all(on_plate)).then(|| {
                plates.push(faces.len());
                plates.len() - 1
            });
            numbers.insert(corners, faces.len());
            faces.push(Face { corners, normal, long: dot(&normal, &normal).sqrt(), rim, plate });
        }
        let count = faces.len();
        let cells = mesh.cells.iter().map(|corners| {
            let own = std::array::from_fn(|k| numbers[&opposite(corners, k)]);
            let ways: [f64; M] = std::array::from_fn(|k| {
                let face: &Face<N> = &faces[own[k]];
                dot(&face.normal, &between(&places[face.corners[0]], &places[corners[k]]))
            });
            let behind = corners.iter().map(|&c| places[c][0]).sum::<f64>() < 0.0;
            let side = |face: usize| faces[face].plate.filter(|_| behind).map_or(face, |plate| count + plate);
            let is_top = |&face: &usize| {
                faces[face].rim == Some(up::<N>())
                    && places[faces[face].corners[0]][up::<N>()] == high[up::<N>()]
            };
            Cell {
                corners: *corners,
                faces: own,
                signs: ways.map(f64::signum),
                sheets: own.map(side),
                volume: ways[0].abs(),
                at_surface: own.iter().any(is_top),
            }
        });
        let cells = cells.collect();
        let sheets = (0..count).chain(plates).collect();
        Self { places, cells, faces, sheets, low }
    }

    /// Depth of a vertex.
    pub(super) fn depth(&self, corner: usize) -> f64 {
        -self.places[corner][up::<N>()]
    }

    /// For each face on the plate its sheets ahead and behind.
    pub(super) fn plates(&self) -> impl Iterator<Item = [usize; 2]> {
        self.faces.iter().enumerate().filter_map(|(i, face)| Some([i, self.faces.len() + face.plate?]))
    }
}

fn opposite<const N: usize, const M: usize>(cell: &[usize; M], k: usize) -> [usize; N] {
    let mut others = std::array::from_fn(|i| cell[if i < k { i } else { i + 1 }]);
    others.sort_unstable();
    others
}

pub(super) fn dot<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// `a - b`.
pub(super) fn between<const N: usize>(a: &[f64; N], b: &[f64; N]) -> [f64; N] {
    std::array::from_fn(|k| a[k] - b[k])
}

/// To the right of an edge; right-handed of a face.
fn normal<const N: usize>(at: &[[f64; N]; N]) -> [f64; N] {
    let a = between(&at[1], &at[0]);
    if N == 2 {
        return std::array::from_fn(|k| if k == 0 { a[1] } else { -a[0] });
    }
    let b = between(&at[2], &at[0]);
    std::array::from_fn(|k| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        a[i] * b[j] - a[j] * b[i]
    })
}
