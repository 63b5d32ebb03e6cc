//! What an element says of its unknowns: balances as rows, stresses as forms.

use soilctl_conic::{Cone, Form, Program};

use super::complex::Complex;
use super::element::{Element, Point, Stress};
use super::sheets::{Component, Sheets};

/// Stresses of a simplex that depend on unknowns of a program.
#[derive(Debug)]
pub(super) struct Response<const N: usize> {
    constant: Vec<Stress<N>>,
    /// For each unknown what one unit of it adds.
    columns: Vec<(usize, Vec<Stress<N>>)>,
}

/// Coefficients below this share of the largest are rounding.
const ROUNDING: f64 = 1e-13;

impl<const N: usize> Response<N> {
    /// Demands that a simplex is balanced, and returns its stresses.
    pub(super) fn new<const M: usize>(
        complex: &Complex<N, M>,
        sheets: &Sheets<N>,
        number: usize,
        program: &mut Program,
    ) -> Self {
        let cell = &complex.cells[number];
        let element = Element::new(complex, cell);
        let mut constant = [[[0.0; N]; M]; M];
        let mut units = Vec::new();
        for f in 0..M {
            let face = &complex.faces[cell.faces[f]];
            for (k, corner) in face.corners.iter().enumerate() {
                let Some(j) = cell.corners.iter().position(|c| c == corner) else { continue };
                for axis in 0..N {
                    match sheets.0[cell.sheets[f]][k][axis] {
                        Component::Known(value) => constant[f][j][axis] = cell.signs[f] * value,
                        Component::Free { number, unit } => {
                            let mut pressing = [[[0.0; N]; M]; M];
                            pressing[f][j][axis] = cell.signs[f] * unit;
                            units.push((number, pressing));
                        }
                    }
                }
            }
        }
        let known = element.resultants(&constant);
        let resultants: Vec<_> = units.iter().map(|(number, p)| (*number, element.resultants(p))).collect();
        for (row, weight) in element.weights().into_iter().enumerate() {
            let terms = resultants.iter().map(|(number, column)| (*number, column[row]));
            let mut form = tidy(Form { constant: known[row] - weight, terms: terms.collect() });
            let long = form.terms.iter().map(|(_, c)| c * c).sum::<f64>().sqrt();
            form.constant /= long;
            form.terms.iter_mut().for_each(|(_, c)| *c /= long);
            program.rows.push(form);
            program.cones.push(Cone::Zero);
        }
        Self {
            constant: element.stresses(&constant),
            columns: units.iter().map(|(number, p)| (*number, element.stresses(p))).collect(),
        }
    }

    /// A component of the stress at a point, times a factor.
    pub(super) fn form(&self, point: usize, [i, j]: [usize; 2], factor: f64) -> Form {
        let terms = self.columns.iter().map(|(number, column)| (*number, factor * column[point][i][j]));
        tidy(Form { constant: factor * self.constant[point][i][j], terms: terms.collect() })
    }
}

/// Without what is only rounding.
fn tidy(mut form: Form) -> Form {
    let largest = form.terms.iter().fold(0.0_f64, |most, (_, c)| most.max(c.abs()));
    form.terms.retain(|(_, c)| c.abs() > ROUNDING * largest);
    form
}

/// The depth of a point of a simplex.
pub(super) fn depth<const N: usize, const M: usize>(
    complex: &Complex<N, M>,
    cell: usize,
    point: Point,
) -> f64 {
    let corners = &complex.cells[cell].corners;
    match point {
        Point::Vertex(k) => complex.depth(corners[k]),
        Point::Centroid => corners.iter().map(|&c| complex.depth(c)).sum::<f64>() / M as f64,
    }
}
