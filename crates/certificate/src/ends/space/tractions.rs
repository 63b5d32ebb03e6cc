//! What presses on faces: what is known of it exactly, and what is to be found so that all is balanced.
//!
//! A *sheet* is one side of a face that has something of its own pressing on it: faces on the plate have two, ahead
//! and behind, all others one. On a sheet with the normal `n`, long as in [`normal`](super::simplex::normal), `t = P
//! n` is linear, so its values at the vertices tell it. Of these
//!
//! - all that is at the surface is zero;
//! - only what is along the normal is not zero in a plane of the box;
//! - on all sheets of a simplex with a face in the surface what is along z is `|z| n_z` at the vertex below the
//!   surface;
//! - where the plate is smooth, only what is along its normal is not zero;
//! - the others are free: those of the field are a first guess of them.

use super::simplex::up;
use super::topology::Complex;
use crate::CertificateError;
use crate::interval::Interval;
use crate::problem::finite;

/// One component of what presses on a sheet at a vertex.
#[derive(Debug, Clone, Copy)]
pub(super) enum Component {
    Known(Interval),
    /// A free number, times its unit.
    Free {
        number: usize,
        unit: f64,
    },
}

/// What is known of all sheets.
#[derive(Debug)]
pub(super) struct Sheets<const N: usize> {
    /// For each simplex the sheets at its faces.
    pub(super) of_cells: Vec<Vec<usize>>,
    /// For each sheet and each vertex of it the components.
    components: Vec<Vec<[Component; N]>>,
    /// The first guess of the free numbers.
    pub(super) guess: Vec<f64>,
}

/// What presses on a sheet at a vertex.
#[derive(Debug, Clone)]
pub(super) struct Pressing<const N: usize> {
    pub(super) known: Vec<Vec<[Interval; N]>>,
}

impl<const N: usize> Sheets<N> {
    /// Reads the tractions of a field.
    pub(super) fn new(
        complex: &Complex<'_, N>,
        ahead: &[[[f64; N]; N]],
        behind: &[[[f64; N]; N]],
        smooth: bool,
    ) -> Result<Self, CertificateError> {
        let count = complex.faces.len();
        let plates: Vec<usize> = complex.plates().map(|(number, _)| number).collect();
        length("tractions", ahead.len(), count, complex.words.face)?;
        length("behind", behind.len(), plates.len(), "face on the plate")?;
        let of_cells: Vec<Vec<usize>> = complex
            .cells
            .iter()
            .map(|cell| {
                let sheet = |(&face, &outwards): (&usize, &bool)| {
                    let face_of = &complex.faces[face];
                    // Out of the soil behind the plate is ahead.
                    let is_behind = outwards == face_of.normal[0].is_positive();
                    face_of.plate.filter(|_| is_behind).map_or(face, |plate| count + plate)
                };
                cell.faces.iter().zip(&cell.outwards).map(sheet).collect()
            })
            .collect();
        let mut sheets = Self { of_cells, components: Vec::new(), guess: Vec::new() };
        let mut at_surface = vec![false; count + plates.len()];
        let cells = complex.cells.iter().zip(&sheets.of_cells).filter(|(cell, _)| cell.at_surface);
        cells.flat_map(|(_, sheets)| sheets).for_each(|&sheet| at_surface[sheet] = true);
        let faces = (0..count).chain(plates);
        for ((sheet, face), values) in faces.enumerate().zip(ahead.iter().chain(behind)) {
            let place = || format!("{} {face}", complex.words.face);
            for x in values.iter().flatten() {
                finite("traction", place, *x, "stress")?;
            }
            let face = &complex.faces[face];
            let long = face.normal.iter().map(|n| n.middle() * n.middle()).sum::<f64>().sqrt();
            let components = face.corners.iter().zip(values).map(|(&corner, values)| {
                let depth = complex.depth(corner);
                std::array::from_fn(|axis| {
                    let is_zero = depth == 0.0
                        || face.rim.is_some_and(|rim| rim.axis != axis)
                        || smooth && face.plate.is_some() && axis != 0;
                    if is_zero {
                        return Component::Known(Interval::ZERO);
                    }
                    if at_surface[sheet] && axis == up::<N>() {
                        return Component::Known(face.normal[axis] * Interval::point(depth));
                    }
                    let unit = long * depth;
                    let number = sheets.guess.len();
                    sheets.guess.push(values[axis] / depth);
                    Component::Free { number, unit }
                })
            });
            let components = components.collect();
            sheets.components.push(components);
        }
        Ok(sheets)
    }

    /// The components at a vertex of a sheet.
    pub(super) fn at(
        &self,
        complex: &Complex<'_, N>,
        cell: usize,
        face: usize,
        corner: usize,
    ) -> [Component; N] {
        let corners = &complex.faces[complex.cells[cell].faces[face]].corners;
        let place = corners.iter().position(|&c| c == corner);
        place.map_or([Component::Known(Interval::ZERO); N], |k| self.components[self.of_cells[cell][face]][k])
    }

    /// All that presses, given enclosures of the free numbers.
    pub(super) fn with(&self, free: &[Interval]) -> Pressing<N> {
        let value = |component: &Component| match *component {
            Component::Known(known) => known,
            Component::Free { number, unit } => free[number] * Interval::point(unit),
        };
        let known = self
            .components
            .iter()
            .map(|sheet| sheet.iter().map(|c| std::array::from_fn(|k| value(&c[k]))).collect());
        Pressing { known: known.collect() }
    }
}

impl<const N: usize> Pressing<N> {
    /// What presses on a face of a simplex at one of its corners.
    pub(super) fn on(
        &self,
        complex: &Complex<'_, N>,
        sheets: &Sheets<N>,
        cell: usize,
        face: usize,
        corner: usize,
    ) -> [Interval; N] {
        let corners = &complex.faces[complex.cells[cell].faces[face]].corners;
        let place = corners.iter().position(|&c| c == corner);
        place.map_or([Interval::ZERO; N], |k| self.known[sheets.of_cells[cell][face]][k])
    }
}

pub(super) fn length(
    list: &'static str,
    found: usize,
    needed: usize,
    each: &'static str,
) -> Result<(), CertificateError> {
    if found == needed { Ok(()) } else { Err(CertificateError::Length { list, found, needed, each }) }
}
