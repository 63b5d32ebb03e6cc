//! A conic program in inequality form: minimise `objective . x` so that every listed group of forms lies in its cone.

use std::f64::consts::SQRT_2;

use crate::form::Form;
use crate::small_dense::eigen;

/// The cones in use.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cone {
    /// Equal to zero.
    Zero,
    /// Not negative.
    NonNegative,
    /// `first >= |(second, third)|`.
    SecondOrder3,
    /// A symmetric matrix of three rows without negative eigenvalues. Its forms are the upper triangle by columns, those off
    /// the diagonal times the square root of two, so that their length is that of the matrix: `m00, r m01, m11, r m02, r m12,
    /// m22`. See [`Program::semidefinite`]. Solved only on Linux with addresses of 64 bits, so far.
    Semidefinite3,
}

/// Which forms of a semidefinite cone are on the diagonal.
const DIAGONAL: [usize; 3] = [0, 2, 5];

impl Cone {
    /// Forms of one cone.
    #[must_use]
    pub fn rows(self) -> usize {
        match self {
            Self::Zero | Self::NonNegative => 1,
            Self::SecondOrder3 => 3,
            Self::Semidefinite3 => 6,
        }
    }
}

/// A program: unknowns are numbered from zero.
#[derive(Debug, Clone, Default)]
pub struct Program {
    /// How many there are.
    pub unknowns: usize,
    /// Unknowns and their coefficients in what is minimised.
    pub objective: Vec<(usize, f64)>,
    /// The forms of all cones, one cone after another.
    pub rows: Vec<Form>,
    /// The cones.
    pub cones: Vec<Cone>,
}

impl Program {
    /// Another unknown.
    pub fn unknown(&mut self) -> usize {
        self.unknowns += 1;
        self.unknowns - 1
    }

    /// Demands that a form is not negative.
    pub fn non_negative(&mut self, form: Form) {
        self.rows.push(form);
        self.cones.push(Cone::NonNegative);
    }

    /// Demands that the first form is at least the length of the other two.
    pub fn second_order(&mut self, forms: [Form; 3]) {
        self.rows.extend(forms);
        self.cones.push(Cone::SecondOrder3);
    }

    /// Demands that a symmetric matrix has no negative eigenvalue. Its upper triangle by columns: `m00, m01, m11, m02, m12, m22`.
    pub fn semidefinite(&mut self, matrix: [Form; 6]) {
        for (k, mut form) in matrix.into_iter().enumerate() {
            if !DIAGONAL.contains(&k) {
                form.constant *= SQRT_2;
                form.terms.iter_mut().for_each(|(_, coefficient)| *coefficient *= SQRT_2);
            }
            self.rows.push(form);
        }
        self.cones.push(Cone::Semidefinite3);
    }

    /// Makes every point of the program stay clear of all cones.
    pub fn tighten(&mut self, by: f64) {
        let mut row = 0;
        for cone in &self.cones {
            match cone {
                Cone::Zero => {}
                Cone::NonNegative | Cone::SecondOrder3 => self.rows[row].constant -= by,
                Cone::Semidefinite3 => DIAGONAL.iter().for_each(|k| self.rows[row + k].constant -= by),
            }
            row += cone.rows();
        }
    }

    /// The same with each second-order cone cut down to a pyramid of `segments` sides inside it: a linear program, but for
    /// semidefinite cones, which stay as they are.
    #[must_use]
    pub fn linearised(&self, segments: usize) -> Self {
        let mut linear =
            Self { unknowns: self.unknowns, objective: self.objective.clone(), ..Self::default() };
        let mut row = 0;
        for cone in &self.cones {
            let rows = &self.rows[row..row + cone.rows()];
            row += cone.rows();
            if *cone != Cone::SecondOrder3 {
                linear.rows.extend_from_slice(rows);
                linear.cones.push(*cone);
                continue;
            }
            let half = std::f64::consts::PI / segments as f64;
            for k in 0..segments {
                let (sin, cos) = (2.0 * half * k as f64).sin_cos();
                let side =
                    Form::default().plus(half.cos(), &rows[0]).plus(-cos, &rows[1]).plus(-sin, &rows[2]);
                linear.non_negative(side);
            }
        }
        linear
    }

    /// How far inside a cone, whose first row is given, a point is: negative outside.
    ///
    /// # Panics
    ///
    /// There is no such row, or the point has fewer coordinates than the program has unknowns.
    #[must_use]
    pub fn slack(&self, row: usize, cone: Cone, x: &[f64]) -> f64 {
        let at = |k: usize| self.rows[row + k].value(x);
        match cone {
            Cone::Zero => -at(0).abs(),
            Cone::NonNegative => at(0),
            Cone::SecondOrder3 => at(0) - at(1).hypot(at(2)),
            Cone::Semidefinite3 => {
                let [a, b, c] = [1, 3, 4].map(|k| at(k) / SQRT_2);
                eigen(vec![vec![at(0), a, b], vec![a, at(2), c], vec![b, c, at(5)]]).0[0]
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A matrix with the eigenvalues 1, 2 and 4 about the axis (1, 1, 1).
    fn matrix() -> [f64; 6] {
        // 2 on the plane, less 1 along (1, -1, 0)/sqrt(2), and 2 more along the axis.
        let t = 2.0 / 3.0;
        [2.0 - 0.5 + t, 0.5 + t, 2.0 - 0.5 + t, t, t, 2.0 + t]
    }

    #[test]
    fn a_semidefinite_cone_is_as_deep_as_the_least_eigenvalue() {
        let mut program = Program::default();
        program.semidefinite(matrix().map(Form::constant));
        assert!((program.slack(0, Cone::Semidefinite3, &[]) - 1.0).abs() < 1e-14);
        program.tighten(0.25);
        assert!((program.slack(0, Cone::Semidefinite3, &[]) - 0.75).abs() < 1e-14);
        assert_eq!(program.linearised(8).cones, program.cones);
        // The length of the six forms is that of the matrix.
        let mut program = Program::default();
        program.semidefinite(matrix().map(Form::constant));
        let square: f64 = program.rows.iter().map(|row| row.constant * row.constant).sum();
        assert!((square - 21.0).abs() < 1e-13);
    }
}
