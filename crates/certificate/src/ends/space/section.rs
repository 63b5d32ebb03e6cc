//! The stress between the ends: `P_xx`, `P_zz` and `P_xz` of triangles, the same for all y, and across them the
//! pressure `f(x, z)` of the faces on the side of the box. Each triangle is proven to lie in its face, where `f` is
//! linear.

use super::borne::Balanced;
use super::simplex::{Matrix, between};
use super::topology::{Complex, Rim};
use super::tractions::length;
use crate::CertificateError;
use crate::interval::Interval;
use crate::problem::exists;

/// The pressure across at the corners of each triangle, in the order in which it names them.
pub(super) fn across(
    section: &Complex<'_, 2>,
    parents: &[usize],
    end: &Balanced<'_, 3>,
) -> Result<Vec<[Interval; 3]>, CertificateError> {
    length("parents", parents.len(), section.cells.len(), "triangle")?;
    let mut across = Vec::with_capacity(parents.len());
    for (number, (&parent, cell)) in parents.iter().zip(&section.cells).enumerate() {
        let place = || format!("{} {number}", section.words.cell);
        exists(place, "face", parent, end.complex.faces.len())?;
        let face = &end.complex.faces[parent];
        if face.rim != Some(Rim { axis: 1, high: false }) {
            let problem = "its parent must be on the side of the box where s is least";
            return Err(CertificateError::BadMesh { place: place(), problem });
        }
        let corners: Vec<[f64; 2]> = face
            .corners
            .iter()
            .map(|&c| {
                let [x, _, z] = end.complex.places[c];
                [x, z]
            })
            .collect();
        let pressures: Vec<Interval> = (0..3).map(|k| end.pressure(parent, k, 1)).collect();
        let mut values = [Interval::ZERO; 3];
        for (value, &corner) in values.iter_mut().zip(&cell.corners) {
            let Some(weights) = weights(&corners, &section.places[corner]) else {
                let problem = "is not proven to lie in its parent";
                return Err(CertificateError::BadMesh { place: place(), problem });
            };
            *value = weights.iter().zip(&pressures).fold(Interval::ZERO, |sum, (w, p)| sum + *w * *p);
        }
        across.push(values);
    }
    Ok(across)
}

/// Weights of the corners of a triangle for a place proven to be in it.
fn weights(corners: &[[f64; 2]], place: &[f64; 2]) -> Option<[Interval; 3]> {
    let area = |a: &[f64; 2], b: &[f64; 2], c: &[f64; 2]| {
        let ([ux, uz], [vx, vz]) = (between(b, a), between(c, a));
        ux * vz - uz * vx
    };
    let whole = area(&corners[0], &corners[1], &corners[2]);
    if !whole.is_not_zero() {
        return None;
    }
    // From the place, so that what has a corner there is zero exactly.
    let weights = [(1, 2), (2, 0), (0, 1)].map(|(b, c)| area(place, &corners[b], &corners[c]) / whole);
    weights.iter().all(|w| w.is_at_least_zero()).then_some(weights)
}

/// A stress in the plane with a pressure across.
pub(super) fn with_across(plane: &Matrix<2>, across: Interval) -> Matrix<3> {
    let zero = Interval::ZERO;
    [[plane[0][0], zero, plane[0][1]], [zero, across, zero], [plane[1][0], zero, plane[1][1]]]
}
