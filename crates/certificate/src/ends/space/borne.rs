//! What soil, plate and the ground beyond the box bear, in triangles and tetrahedra alike.

use super::balance::balances;
use super::simplex::{Matrix, factorial};
use super::strength::Strengths;
use super::stress::{Point, stresses};
use super::topology::Complex;
use super::tractions::{Pressing, Sheets};
use crate::CertificateError;
use crate::interval::Interval;

/// Triangles or tetrahedra, and enclosures of what presses on all their faces, in exact balance.
#[derive(Debug)]
pub(super) struct Balanced<'a, const N: usize> {
    pub(super) complex: Complex<'a, N>,
    sheets: Sheets<N>,
    pressing: Pressing<N>,
}

fn not_proven(quantity: &'static str, place: String, low: f64) -> CertificateError {
    CertificateError::NotProven { quantity, place, low, unit: "unit weight*depth" }
}

impl<'a, const N: usize> Balanced<'a, N> {
    /// Balances what presses on all faces.
    pub(super) fn new(
        complex: Complex<'a, N>,
        ahead: &[[[f64; N]; N]],
        behind: &[[[f64; N]; N]],
        strengths: &Strengths,
    ) -> Result<Self, CertificateError> {
        let sheets = Sheets::new(&complex, ahead, behind, strengths.slip.is_zero())?;
        let free = balances(&complex, &sheets).solve(&sheets.guess)?;
        let pressing = sheets.with(&free);
        Ok(Self { complex, sheets, pressing })
    }

    /// Proves that the plate and the ground beyond the box bear what presses on them. In the planes of `given` the
    /// latter need not be proven.
    pub(super) fn check_faces(
        &self,
        strengths: &Strengths,
        given: impl Fn(usize, bool) -> bool,
    ) -> Result<(), CertificateError> {
        for (number, face) in self.complex.faces.iter().enumerate() {
            let place = || format!("{} {number}", self.complex.words.face);
            let sheets = [Some(number), face.plate.map(|plate| self.complex.faces.len() + plate)];
            for (sheet, (k, &corner)) in sheets
                .into_iter()
                .flatten()
                .flat_map(|s| face.corners.iter().enumerate().map(move |c| (s, c)))
            {
                let depth = self.complex.depth(corner);
                if depth == 0.0 {
                    continue;
                }
                let pressing = self.pressing.known[sheet][k];
                if face.plate.is_some() {
                    let stress = pressing.map(|component| component / face.normal[0]);
                    let spare = strengths.face(stress[0], &stress[1..]);
                    if spare < 0.0 {
                        return Err(not_proven("strength to spare of the plate's face", place(), spare));
                    }
                } else if let Some(rim) = face.rim.filter(|rim| !given(rim.axis, rim.high)) {
                    let spare = strengths.far(pressing[rim.axis] / face.normal[rim.axis], depth);
                    if spare < 0.0 {
                        return Err(not_proven(
                            "strength to spare of the ground beyond the box",
                            place(),
                            spare,
                        ));
                    }
                }
            }
        }
        Ok(())
    }

    /// Proves that the soil bears the stress: `whole` makes it one in space, given a simplex and where in it, as
    /// weights of its vertices.
    pub(super) fn check_soil(
        &self,
        strengths: &Strengths,
        whole: impl Fn(usize, Option<usize>, &Matrix<N>) -> Matrix<3>,
    ) -> Result<(), CertificateError> {
        for number in 0..self.complex.cells.len() {
            for point in self.stresses(number) {
                let spare = strengths.spare(&whole(number, point.corner, &point.stress));
                if spare < 0.0 {
                    let cell = format!("{} {number}", self.complex.words.cell);
                    let place = point.corner.map_or_else(
                        || format!("the centroid of {cell}"),
                        |corner| format!("{} {corner} of {cell}", self.complex.words.vertex),
                    );
                    return Err(not_proven("strength to spare of the soil", place, spare));
                }
            }
        }
        Ok(())
    }

    /// The stresses of all parts of a simplex, as [`stresses`] lists them.
    pub(super) fn stresses(&self, number: usize) -> Vec<Point<N>> {
        stresses(&self.complex, &self.sheets, &self.pressing, number)
    }

    /// The pressure along x ahead of the plate less that behind it, on one of its faces at one of the face's vertices.
    pub(super) fn net_pressure(&self, face: usize, at: usize) -> Interval {
        let behind = self.complex.faces[face].plate.map_or(face, |plate| self.complex.faces.len() + plate);
        let pressing = |sheet: usize| self.pressing.known[sheet][at][0];
        (pressing(face) - pressing(behind)) / self.complex.faces[face].normal[0]
    }

    /// The force of the plate on the soil along x.
    pub(super) fn force(&self) -> Interval {
        let mut force = Interval::ZERO;
        for (number, face) in self.complex.plates() {
            let behind = face.plate.map_or(number, |plate| self.complex.faces.len() + plate);
            let sum = |sheet: usize| {
                self.pressing.known[sheet].iter().fold(Interval::ZERO, |sum, pressing| sum + pressing[0])
            };
            let net = sum(number) - sum(behind);
            force = if face.normal[0].is_positive() { force + net } else { force - net };
        }
        force / factorial::<N>()
    }

    /// The pressure on a face in a plane of the box at one of its vertices.
    pub(super) fn pressure(&self, face: usize, at: usize, axis: usize) -> Interval {
        self.pressing.known[face][at][axis] / self.complex.faces[face].normal[axis]
    }
}
