//! From unknowns to a field that can be proven.

use soilctl_certificate::{SpaceSection, SpaceStress};

use super::complex::Complex;
use super::program::Assembled;
use super::sheets::Sheets;
use super::simplices::Simplices;

/// The field with these unknowns.
pub(super) fn field(assembled: &Assembled, triangles: &Simplices<2, 3>, x: &[f64]) -> SpaceStress {
    let (ends, plane) = (&assembled.ends.0, &assembled.section.0);
    let (tractions, behind) = tractions(ends, &assembled.ends.1, x);
    let (plane_tractions, plane_behind) = self::tractions(plane, &assembled.section.1, x);
    SpaceStress {
        vertices: ends.places.clone(),
        tetrahedra: ends.cells.iter().map(|cell| cell.corners).collect(),
        tractions,
        behind,
        section: SpaceSection {
            vertices: plane.places.clone(),
            triangles: plane.cells.iter().map(|cell| cell.corners).collect(),
            parents: triangles.parents.clone(),
            tractions: plane_tractions,
            behind: plane_behind,
        },
    }
}

/// Tractions of a kind of faces, at their vertices.
type Tractions<const N: usize> = Vec<[[f64; N]; N]>;

/// On all faces, and behind the plate.
fn tractions<const N: usize, const M: usize>(
    complex: &Complex<N, M>,
    sheets: &Sheets<N>,
    x: &[f64],
) -> (Tractions<N>, Tractions<N>) {
    let values = sheets.0.iter().zip(&complex.sheets).map(|(sheet, &face)| {
        let long = complex.faces[face].long;
        sheet.map(|vertex| vertex.map(|component| component.value(x) / long))
    });
    let mut all: Vec<_> = values.collect();
    let behind = all.split_off(complex.faces.len());
    (all, behind)
}
