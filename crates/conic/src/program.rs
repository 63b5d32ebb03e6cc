//! A conic program in inequality form: minimise `objective . x` so that every listed group of forms lies in its cone.

use crate::form::Form;

/// The cones in use.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cone {
    /// Equal to zero.
    Zero,
    /// Not negative.
    NonNegative,
    /// `first >= |(second, third)|`.
    SecondOrder3,
}

impl Cone {
    /// Forms of one cone.
    #[must_use]
    pub fn rows(self) -> usize {
        match self {
            Self::Zero | Self::NonNegative => 1,
            Self::SecondOrder3 => 3,
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

    /// Makes every point of the program stay clear of all cones.
    pub fn tighten(&mut self, by: f64) {
        let mut row = 0;
        for cone in &self.cones {
            if *cone != Cone::Zero {
                self.rows[row].constant -= by;
            }
            row += cone.rows();
        }
    }

    /// The same with each second-order cone cut down to a pyramid of `segments` sides inside it: a linear program.
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
        }
    }
}
