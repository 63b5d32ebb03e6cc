//! The balances of all simplices.
//!
//! Let `t` be what presses on the faces of a simplex at their vertices, with `s = 1` where the face's normal points
//! out of it and -1 where it points into it, and `J` be `N!` times its volume. The integral of the linear function
//! that is 1 at one of `N` vertices and 0 at the others is an `N`-th of the area, so the balance of forces, with the
//! weight, is
//!
//! ```text
//! sum over faces f and vertices j of f of  s t_fj  =  -J e_z
//! ```
//!
//! The integral of that function times `x`, less the centroid of the simplex, is the same `N`-th of the area times
//! `(x_j - x_f)/(N + 1)`, where `x_f` is the vertex opposite the face. So the balance of moments is
//!
//! ```text
//! sum over f, j of  s ((x_j - x_f)_a t_fj,b - (x_j - x_f)_b t_fj,a)  =  0     for all a < b
//! ```
//!
//! *At the surface.* In a simplex with a face in the surface `t` is zero but at the vertex `p` below it, where `t_z =
//! |z| n_z` on the others. Then `sum s t_z` is `|z|` times the opposite of the normal of the face in the surface,
//! which is `-J`: forces along z balance. With `d_f = x_f - p` and the dual basis `e_f`, `s n_f = -J e_f`, so the
//! moments of `t_z` about the axis across `a` and z are `|z| J sum (d_f)_a (e_f)_z`, which is zero, and those of
//! `t_a` are `z_p` times the force along `a`, zero if that is balanced. These balances are left out: they hold.

use super::simplex::{Vector, between, up};
use super::system::{Row, System};
use super::topology::Complex;
use super::tractions::{Component, Sheets};
use crate::interval::Interval;

/// The equations of all simplices in the free numbers.
pub(super) fn balances<const N: usize>(complex: &Complex<'_, N>, sheets: &Sheets<N>) -> System {
    let mut rows = Vec::new();
    let mut places = Vec::new();
    for (group, cell) in complex.cells.iter().enumerate() {
        let mut place = [0.0; 3];
        for &corner in &cell.corners {
            (0..N).for_each(|k| place[k] += complex.places[corner][k]);
        }
        places.push(place);
        let known: Vec<Force<N>> = pressing(complex, sheets, group);
        let live = |axis: usize| !(cell.at_surface && axis == up::<N>());
        for a in (0..N).filter(|&a| live(a)) {
            let weight = if a == up::<N>() { -cell.volume } else { Interval::ZERO };
            let terms = known.iter().map(|force| (force.sign, force.components[a]));
            rows.push(row(group, weight, terms));
        }
        for (a, b) in (0..N).flat_map(|b| (0..b).map(move |a| (a, b))).filter(|&(_, b)| live(b)) {
            let terms = known.iter().flat_map(|force| {
                [
                    (force.arm[a] * force.sign, force.components[b]),
                    (-(force.arm[b] * force.sign), force.components[a]),
                ]
            });
            rows.push(row(group, Interval::ZERO, terms));
        }
    }
    System { rows, places, columns: sheets.guess.len(), of: complex.words.cells }
}

/// What presses on a face of a simplex at one vertex of the face.
struct Force<const N: usize> {
    sign: Interval,
    /// From the vertex opposite the face.
    arm: Vector<N>,
    components: [Component; N],
}

fn pressing<const N: usize>(complex: &Complex<'_, N>, sheets: &Sheets<N>, group: usize) -> Vec<Force<N>> {
    let cell = &complex.cells[group];
    let faces = 0..=N;
    let pairs = faces.flat_map(|f| (0..=N).filter(move |&j| j != f).map(move |j| (f, j)));
    pairs
        .map(|(f, j)| Force {
            sign: if cell.outwards[f] { Interval::ONE } else { -Interval::ONE },
            arm: between(&complex.places[cell.corners[j]], &complex.places[cell.corners[f]]),
            components: sheets.at(complex, group, f, cell.corners[j]),
        })
        .collect()
}

fn row(group: usize, right: Interval, terms: impl Iterator<Item = (Interval, Component)>) -> Row {
    let mut row = Row { group, entries: Vec::new(), right };
    for (factor, component) in terms {
        match component {
            Component::Known(known) => row.right = row.right - factor * known,
            Component::Free { number, unit } => row.entries.push((number, factor * Interval::point(unit))),
        }
    }
    row.entries.retain(|(_, factor)| !factor.is_zero());
    row
}
