//! Triangles or tetrahedra that fill a box, and the plate in it.
//!
//! *They tile the box.* Each simplex is proven to have a volume, so it can be taken as positively oriented. Each face
//! belongs to two simplices, on opposite sides of it, or to one and lies in a plane of the box. So the boundaries of
//! all simplices add up to a cycle in the boundary of the box. Any such cycle is a multiple of that boundary, and the
//! number of simplices over a point of the box is that multiple, the same everywhere but on faces. It is at least one
//! as there are simplices, and below two as their volumes add up to less than twice that of the box.
//!
//! *The plate is covered.* Its faces are those with all vertices on it. They are oriented alike. Each of their edges
//! is walked as often in one sense as in the other, or lies on the rim of the plate; so by the same argument they
//! cover it once if there are any, and their areas add up to less than twice that of the plate. No simplex reaches
//! through it then, since none reaches through a face.

use std::collections::BTreeMap;

use super::simplex::{Vector, between, dot, factorial, normal, up};
use crate::CertificateError;
use crate::interval::Interval;
use crate::problem::{exists, finite};

/// Most simplices of a field.
const MAX_CELLS: usize = 10_000;

/// A plane of the box.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Rim {
    pub(super) axis: usize,
    /// Whether it is the one where the coordinate is greatest.
    pub(super) high: bool,
}

/// A triangle or a tetrahedron.
#[derive(Debug)]
pub(super) struct Cell<const N: usize> {
    pub(super) corners: Vec<usize>,
    /// For each corner the face opposite.
    pub(super) faces: Vec<usize>,
    /// Whether the normals of these point out of it.
    pub(super) outwards: Vec<bool>,
    /// `N!` times the volume.
    pub(super) volume: Interval,
    /// Whether one of the faces is in the surface.
    pub(super) at_surface: bool,
}

/// An edge of triangles, or a face of tetrahedra.
#[derive(Debug)]
pub(super) struct Face<const N: usize> {
    /// In increasing order.
    pub(super) corners: Vec<usize>,
    pub(super) normal: Vector<N>,
    pub(super) rim: Option<Rim>,
    /// Its number among those on the plate, if it is one of them.
    pub(super) plate: Option<usize>,
}

/// What fills the box.
#[derive(Debug)]
pub(super) struct Complex<'a, const N: usize> {
    pub(super) places: &'a [[f64; N]],
    pub(super) cells: Vec<Cell<N>>,
    pub(super) faces: Vec<Face<N>>,
    /// Least and greatest coordinates.
    pub(super) low: [f64; N],
    pub(super) high: [f64; N],
    pub(super) words: &'static Words,
}

/// How parts are called in messages.
#[derive(Debug)]
pub(super) struct Words {
    pub(super) vertex: &'static str,
    pub(super) cell: &'static str,
    /// Of all together.
    pub(super) cells: &'static str,
    pub(super) face: &'static str,
}

fn bad<T>(place: String, problem: &'static str) -> Result<T, CertificateError> {
    Err(CertificateError::BadMesh { place, problem })
}

impl<'a, const N: usize> Complex<'a, N> {
    /// Proves that the simplices tile a box about the lower end of the plate, and that the plate is covered by faces.
    pub(super) fn new<const M: usize>(
        places: &'a [[f64; N]],
        corners: &[[usize; M]],
        words: &'static Words,
    ) -> Result<Self, CertificateError> {
        let (low, high) = check_box(places, words)?;
        if corners.len() > MAX_CELLS {
            let place = format!("{} {}", corners.len(), words.cells);
            return Err(CertificateError::NotCovered { place, what: "a field has at most 10000 of them" });
        }
        let mut numbers = BTreeMap::new();
        for (i, cell) in corners.iter().enumerate() {
            for (k, &corner) in cell.iter().enumerate() {
                exists(|| format!("{} {i}", words.cell), words.vertex, corner, places.len())?;
                if cell[..k].contains(&corner) {
                    return bad(format!("{} {i}", words.cell), "names a vertex twice");
                }
            }
            (0..=N).for_each(|k| _ = numbers.insert(opposite(cell, k), 0));
        }
        numbers.values_mut().enumerate().for_each(|(number, entry)| *entry = number);
        let mut faces: Vec<Face<N>> = numbers
            .keys()
            .map(|key: &Vec<usize>| {
                let at: Vec<[f64; N]> = key.iter().map(|&c| places[c]).collect();
                Face { corners: key.clone(), normal: normal(&at), rim: None, plate: None }
            })
            .collect();
        // For each face, the simplex that it points out of and the one that it points into.
        let mut owners = vec![[None; 2]; faces.len()];
        let mut cells = Vec::new();
        for (i, cell) in corners.iter().enumerate() {
            let place = || format!("{} {i}", words.cell);
            let mut built = Cell {
                corners: cell.to_vec(),
                faces: vec![],
                outwards: vec![],
                volume: Interval::ZERO,
                at_surface: false,
            };
            for k in 0..=N {
                let number = numbers[&opposite(cell, k)];
                let face = &faces[number];
                let volume = dot(&face.normal, &between(&places[face.corners[0]], &places[cell[k]]));
                if !volume.is_not_zero() {
                    return bad(place(), "is not proven to have a volume");
                }
                let outwards = volume.is_positive();
                built.volume = volume.abs();
                built.faces.push(number);
                built.outwards.push(outwards);
                if owners[number][usize::from(outwards)].replace(i).is_some() {
                    return bad(place(), "lies on the same side of a face as another");
                }
            }
            cells.push(built);
        }
        let mut plates = 0;
        for (number, face) in faces.iter_mut().enumerate() {
            let all = |axis: usize, value: f64| face.corners.iter().all(|&c| places[c][axis] == value);
            if let [Some(_), Some(_)] = owners[number] {
                if face.corners.iter().all(|&c| on_plate(&places[c])) {
                    face.plate = Some(plates);
                    plates += 1;
                }
                continue;
            }
            face.rim = (0..N)
                .flat_map(|axis| [Rim { axis, high: false }, Rim { axis, high: true }])
                .find(|rim| all(rim.axis, if rim.high { high[rim.axis] } else { low[rim.axis] }));
            let Some(rim) = face.rim else {
                let place = format!("{} {number}", words.face);
                return bad(place, "belongs to one simplex only, but is not in a plane of the box");
            };
            if rim == (Rim { axis: up::<N>(), high: true }) {
                owners[number].into_iter().flatten().for_each(|cell: usize| cells[cell].at_surface = true);
            }
        }
        let complex = Self { places, cells, faces, low, high, words };
        complex.check_volume()?;
        complex.check_plate()?;
        Ok(complex)
    }

    /// Proves that the simplices do not cover the box twice.
    fn check_volume(&self) -> Result<(), CertificateError> {
        let sum = self.cells.iter().fold(Interval::ZERO, |sum, cell| sum + cell.volume);
        let size =
            between(&self.high, &self.low).into_iter().fold(factorial::<N>(), |size, side| size * side);
        if !self.cells.is_empty() && (size + size - sum).is_positive() {
            return Ok(());
        }
        bad(self.words.cells.to_owned(), "must cover the box once")
    }

    /// Proves that faces cover the plate once.
    fn check_plate(&self) -> Result<(), CertificateError> {
        let mut rims: BTreeMap<Vec<usize>, i64> = BTreeMap::new();
        let mut area = Interval::ZERO;
        for (number, face) in self.plates() {
            let along = face.normal[0];
            if !along.is_not_zero() {
                return bad(format!("{} {number}", self.words.face), "is not proven to have an area");
            }
            area = area + along.abs();
            for k in 0..N {
                let sign = if (k % 2 == 0) == along.is_positive() { 1 } else { -1 };
                *rims.entry(opposite(&face.corners, k)).or_default() += sign;
            }
        }
        let on_rim = |corners: &[usize]| {
            let all = |axis: usize, value| corners.iter().all(|&c| self.places[c][axis] == value);
            let ends = all(up::<N>(), 0.0) || all(up::<N>(), -1.0);
            ends || N == 3 && (all(1, 0.0) || all(1, self.low[1]))
        };
        let closed = rims.iter().all(|(corners, count)| *count == 0 || on_rim(corners));
        let whole = if N == 3 { -Interval::point(2.0 * self.low[1]) } else { Interval::ONE };
        if closed && !rims.is_empty() && (whole + whole - area).is_positive() {
            return Ok(());
        }
        bad("the plate".into(), "must be covered once by faces between the soil ahead and behind")
    }

    /// Faces on the plate.
    pub(super) fn plates(&self) -> impl Iterator<Item = (usize, &Face<N>)> {
        self.faces.iter().enumerate().filter(|(_, face)| face.plate.is_some())
    }

    /// Depth of a vertex below the surface.
    pub(super) fn depth(&self, corner: usize) -> f64 {
        -self.places[corner][up::<N>()]
    }
}

/// All but one of the corners, in increasing order.
fn opposite(corners: &[usize], left_out: usize) -> Vec<usize> {
    let mut others: Vec<usize> =
        corners.iter().enumerate().filter(|(k, _)| *k != left_out).map(|(_, c)| *c).collect();
    others.sort_unstable();
    others
}

fn on_plate<const N: usize>(place: &[f64; N]) -> bool {
    place[0] == 0.0 && place[up::<N>()] >= -1.0 && (N == 2 || place[1] <= 0.0)
}

/// The box of all vertices: it must have the surface on top, and the plate's lower edge and end within it.
fn check_box<const N: usize>(
    places: &[[f64; N]],
    words: &Words,
) -> Result<([f64; N], [f64; N]), CertificateError> {
    for (i, place) in places.iter().enumerate() {
        for x in place {
            finite("coordinate", || format!("{} {i}", words.vertex), *x, "depth of the plate")?;
        }
    }
    let low = std::array::from_fn(|k| places.iter().fold(f64::MAX, |least, p| least.min(p[k])));
    let high: [f64; N] = std::array::from_fn(|k| places.iter().fold(f64::MIN, |most, p| most.max(p[k])));
    let across = (0..up::<N>()).all(|k| low[k] < 0.0 && high[k] > 0.0);
    if across && low[up::<N>()] < -1.0 && high[up::<N>()] == 0.0 {
        return Ok((low, high));
    }
    bad(
        "the box".into(),
        "must have the surface on top, and the lower edge and the end of the plate within it",
    )
}
