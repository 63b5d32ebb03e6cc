//! The program: the greatest force of a plate of a given width that stresses in equilibrium, and within strength, can resist.

use soilctl_conic::{Form, Program};

use super::complex::Complex;
use super::element::Element;
use super::response::{Response, depth};
use super::section::across;
use super::sheets::Sheets;
use super::simplices::Simplices;
use super::strength::{Strengths, force};

/// A program, and what its unknowns and rows are.
#[derive(Debug)]
pub(super) struct Assembled {
    pub(super) program: Program,
    pub(super) ends: (Complex<3, 4>, Sheets<3>),
    pub(super) section: (Complex<2, 3>, Sheets<2>),
    /// The force per unit width.
    pub(super) force: Form,
    /// For each tetrahedron, and each triangle, the first of its rows of strength, and the first beyond.
    pub(super) rows: [Vec<[usize; 2]>; 2],
}

/// By how much fields stay clear of what is borne, in units of the pressure at rest: the solver meets its rows that well.
const MARGIN: f64 = 1e-6;

/// The upper triangle of a symmetric matrix, by columns.
const UPPER: [[usize; 2]; 6] = [[0, 0], [0, 1], [1, 1], [0, 2], [1, 2], [2, 2]];

impl Assembled {
    /// For tetrahedra about the end, and triangles of the section with the faces in which they lie. The width is that over the
    /// depth.
    pub(super) fn new(
        complex: Complex<3, 4>,
        triangles: &Simplices<2, 3>,
        strengths: &Strengths,
        width_ratio: f64,
    ) -> Self {
        let mut program = Program::default();
        let smooth = strengths.slip == 0.0;
        let sheets = Sheets::new(&complex, smooth, &mut program);
        let plane = Complex::new(triangles);
        let plane_sheets = Sheets::new(&plane, smooth, &mut program);
        let mut rows = [Vec::new(), Vec::new()];
        for cell in 0..complex.cells.len() {
            let response = Response::new(&complex, &sheets, cell, &mut program);
            let from = program.rows.len();
            for (at, point) in Element::<3, 4>::points().enumerate() {
                let depth = depth(&complex, cell, point);
                if depth > 0.0 {
                    let stress = UPPER.map(|axes| response.form(at, axes, 1.0 / depth));
                    strengths.soil(&stress, &mut program);
                }
            }
            rows[0].push([from, program.rows.len()]);
        }
        for cell in 0..plane.cells.len() {
            let response = Response::new(&plane, &plane_sheets, cell, &mut program);
            let from = program.rows.len();
            for (at, point) in Element::<2, 3>::points().enumerate() {
                let depth = depth(&plane, cell, point);
                if depth > 0.0 {
                    let stress = [[0, 0], [0, 1], [1, 1]].map(|axes| response.form(at, axes, 1.0 / depth));
                    let ends = (&complex, &sheets);
                    let across = across(&plane, &triangles.parents, cell, point, ends, 1.0 / depth);
                    strengths.plane(&stress, &across, &mut program);
                }
            }
            rows[1].push([from, program.rows.len()]);
        }
        let side = complex.low[1];
        strengths.faces(&complex, &sheets, |place, axis| axis == 1 && place[1] == side, &mut program);
        strengths.faces(&plane, &plane_sheets, |_, _| false, &mut program);
        let between = (width_ratio + 2.0 * side) / width_ratio;
        let mut total = Form::default().plus(2.0 / width_ratio, &force(&complex, &sheets));
        total.terms.extend(Form::default().plus(between, &force(&plane, &plane_sheets)).terms);
        program.objective = total.terms.iter().map(|&(number, factor)| (number, -factor)).collect();
        program.tighten(MARGIN);
        Self { program, ends: (complex, sheets), section: (plane, plane_sheets), force: total, rows }
    }

    /// How fast a tetrahedron (0) or a triangle (1) yields, times its size: the difference of the multipliers of what is borne.
    pub(super) fn yielding(&self, kind: usize, cell: usize, multipliers: &[f64]) -> f64 {
        let [from, to] = self.rows[kind][cell];
        let size = if kind == 0 { 6 } else { 4 };
        multipliers[from..to]
            .chunks_exact(2 * size)
            .map(|point| (0..size).map(|k| (point[k] - point[size + k]).powi(2)).sum::<f64>().sqrt())
            .sum()
    }
}
