//! Balances and stresses of one simplex, as functions of what presses on its faces.
//!
//! A simplex with `M` vertices is cut at its centroid in `M` parts, in each of which the stress is linear (in the plane Johnson &
//! Mercier 1978, in space Krizek 1982). What presses on the faces at their vertices tells the stress at the vertices, part by
//! part; the mean of the stress, which follows from it too, that at the centroid. If forces and moments balance, with the
//! weight, it is in equilibrium: [`soilctl_certificate`] has the argument and proves fields of this kind.

use super::complex::{Cell, Complex, between, dot, up};

/// What presses on the faces opposite all vertices, out of the simplex, at all vertices; nothing at the one opposite.
pub(super) type Pressing<const N: usize, const M: usize> = [[[f64; N]; M]; M];

/// A stress.
pub(super) type Stress<const N: usize> = [[f64; N]; N];

/// The geometry of a simplex.
#[derive(Debug)]
pub(super) struct Element<const N: usize, const M: usize> {
    places: [[f64; N]; M],
    normals: [[f64; N]; M],
    volume: f64,
    at_surface: bool,
}

/// Places where a stress is needed, so that it is known everywhere.
#[derive(Debug, Clone, Copy)]
pub(super) enum Point {
    /// A vertex, by its number in the simplex.
    Vertex(usize),
    Centroid,
}

impl<const N: usize, const M: usize> Element<N, M> {
    pub(super) fn new(complex: &Complex<N, M>, cell: &Cell<M>) -> Self {
        let normal = |k: usize| complex.faces[cell.faces[k]].normal.map(|n| n * cell.signs[k]);
        Self {
            places: cell.corners.map(|corner| complex.places[corner]),
            normals: std::array::from_fn(normal),
            volume: cell.volume,
            at_surface: cell.at_surface,
        }
    }

    /// The points of [`stresses`](Self::stresses), in its order.
    pub(super) fn points() -> impl Iterator<Item = Point> {
        (0..M).flat_map(|at| (0..N).map(move |_| Point::Vertex(at))).chain([Point::Centroid])
    }

    /// Forces along the axes, without the weight, and moments. At the surface those that hold by what is known are left out.
    pub(super) fn resultants(&self, pressing: &Pressing<N, M>) -> Vec<f64> {
        let live = |axis: &usize| !(self.at_surface && *axis == up::<N>());
        let all = || (0..M).flat_map(|f| (0..M).map(move |j| (f, j))).filter(|(f, j)| f != j);
        let force = |a: usize| all().map(|(f, j)| pressing[f][j][a]).sum::<f64>();
        let moment = |a: usize, b: usize| {
            let about = |(f, j): (usize, usize)| {
                let arm = between(&self.places[j], &self.places[f]);
                arm[a] * pressing[f][j][b] - arm[b] * pressing[f][j][a]
            };
            all().map(about).sum::<f64>()
        };
        let forces = (0..N).filter(live).map(force);
        let moments = (0..N).filter(live).flat_map(|b| (0..b).map(move |a| (a, b)));
        forces.chain(moments.map(|(a, b)| moment(a, b))).collect()
    }

    /// What the resultants must be, so that the weight is borne.
    pub(super) fn weights(&self) -> Vec<f64> {
        let mut weights = vec![0.0; self.resultants(&[[[0.0; N]; M]; M]).len()];
        if !self.at_surface {
            weights[up::<N>()] = -self.volume;
        }
        weights
    }

    /// Stresses at each vertex in all parts there, and at the centroid.
    pub(super) fn stresses(&self, pressing: &Pressing<N, M>) -> Vec<Stress<N>> {
        let mut stresses = Vec::with_capacity(M * N + 1);
        let mut centre = [[0.0; N]; N];
        let square = self.volume * self.volume;
        for (at, place) in self.places.iter().enumerate() {
            let others: [usize; N] = std::array::from_fn(|a| if a < at { a } else { a + 1 });
            let ways = others.map(|k| between(&self.places[k], place));
            let given = others.map(|f| others.map(|k| dot(&self.normals[k], &pressing[f][at]) / square));
            for a in 0..N {
                let stress = spread(&part(&given, a), &ways);
                add(&mut centre, &stress, -1.0 / M as f64);
                stresses.push(stress);
            }
        }
        for (f, j) in (0..M).flat_map(|f| (0..M).map(move |j| (f, j))).filter(|(f, j)| f != j) {
            let (arm, force) = (between(&self.places[j], &self.places[f]), pressing[f][j]);
            for (a, b) in pairs::<N>() {
                centre[a][b] += 0.5 * (force[a] * arm[b] + force[b] * arm[a]) / self.volume;
            }
        }
        stresses.push(centre);
        stresses
    }
}

/// Contravariant components of the stress in part `a` at a vertex, from those of the tractions on the faces there.
fn part<const N: usize>(given: &Stress<N>, a: usize) -> Stress<N> {
    let mut part = [[0.0; N]; N];
    for b in 0..N {
        part[a][b] = given[a][b];
        part[b][a] = given[a][b];
    }
    for b in (0..N).filter(|&b| b != a) {
        part[b][b] = given[b][b] - given[b][a] + given[a][b];
        for c in (0..b).filter(|&c| c != a) {
            let twice = given[a][b] + given[a][c] + given[b][c] + given[c][b] - given[b][a] - given[c][a];
            part[b][c] = 0.5 * twice;
            part[c][b] = 0.5 * twice;
        }
    }
    part
}

/// From components along ways to those along axes.
fn spread<const N: usize>(part: &Stress<N>, ways: &Stress<N>) -> Stress<N> {
    let mut stress = [[0.0; N]; N];
    for (i, j) in pairs::<N>() {
        for (b, c) in pairs::<N>() {
            stress[i][j] += part[b][c] * ways[b][i] * ways[c][j];
        }
    }
    stress
}

fn add<const N: usize>(sum: &mut Stress<N>, other: &Stress<N>, factor: f64) {
    pairs::<N>().for_each(|(i, j)| sum[i][j] += factor * other[i][j]);
}

fn pairs<const N: usize>() -> impl Iterator<Item = (usize, usize)> {
    (0..N).flat_map(|i| (0..N).map(move |j| (i, j)))
}
