//! The unknowns: what presses on sheets at their vertices.
//!
//! On a sheet with the normal `n`, long as in `Face`, the traction `t = P n` is linear, so its values at the vertices tell it. Of
//! these all at the surface are zero; in planes of the box and on smooth plates what is not along the normal is zero; on all
//! sheets of a simplex with a face in the surface what is along z is `depth n_z`; the rest is unknown, in units of the depth.

use soilctl_conic::{Form, Program};

use super::complex::{Complex, up};

/// A component of a traction.
#[derive(Debug, Clone, Copy)]
pub(super) enum Component {
    Known(f64),
    /// An unknown of the program, times a unit.
    Free {
        number: usize,
        unit: f64,
    },
}

impl Component {
    /// `factor` times it.
    pub(super) fn form(self, factor: f64) -> Form {
        match self {
            Self::Known(value) => Form::constant(factor * value),
            Self::Free { number, unit } => Form::unknown(number, factor * unit),
        }
    }

    /// What it is, given all unknowns.
    pub(super) fn value(self, x: &[f64]) -> f64 {
        match self {
            Self::Known(value) => value,
            Self::Free { number, unit } => unit * x[number],
        }
    }
}

/// For each sheet and each vertex of it the components.
#[derive(Debug)]
pub(super) struct Sheets<const N: usize>(pub(super) Vec<[[Component; N]; N]>);

impl<const N: usize> Sheets<N> {
    /// Makes the unknowns of a mesh.
    pub(super) fn new<const M: usize>(complex: &Complex<N, M>, smooth: bool, program: &mut Program) -> Self {
        let mut at_surface = vec![false; complex.sheets.len()];
        for cell in complex.cells.iter().filter(|cell| cell.at_surface) {
            cell.sheets.iter().for_each(|&sheet| at_surface[sheet] = true);
        }
        let mut sheets = Vec::with_capacity(at_surface.len());
        for (&face, at_surface) in complex.sheets.iter().zip(at_surface) {
            let face = &complex.faces[face];
            let component = |depth: f64, axis: usize, program: &mut Program| {
                let is_across = face.rim.is_some_and(|rim| rim != axis);
                if depth == 0.0 || is_across || smooth && face.plate.is_some() && axis != 0 {
                    return Component::Known(0.0);
                }
                if at_surface && axis == up::<N>() {
                    return Component::Known(face.normal[axis] * depth);
                }
                Component::Free { number: program.unknown(), unit: face.long * depth }
            };
            sheets.push(face.corners.map(|corner| {
                let depth = complex.depth(corner);
                std::array::from_fn(|axis| component(depth, axis, program))
            }));
        }
        Self(sheets)
    }

    /// The stress (pressure positive) along an axis at a vertex of a sheet in a plane across another.
    pub(super) fn stress<const M: usize>(
        &self,
        complex: &Complex<N, M>,
        sheet: usize,
        vertex: usize,
        [axis, across]: [usize; 2],
        factor: f64,
    ) -> Form {
        let face = &complex.faces[complex.sheets[sheet]];
        self.0[sheet][vertex][axis].form(factor / face.normal[across])
    }
}
