/// An affine function of the unknowns of a program: `constant + sum of coefficient * x[index]`.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Form {
    /// What it is where all unknowns are zero.
    pub constant: f64,
    /// Unknowns and their coefficients, each unknown once.
    pub terms: Vec<(usize, f64)>,
}

impl Form {
    /// A number.
    #[must_use]
    pub fn constant(value: f64) -> Self {
        Self { constant: value, terms: Vec::new() }
    }

    /// A multiple of one unknown.
    #[must_use]
    pub fn unknown(index: usize, coefficient: f64) -> Self {
        Self { constant: 0.0, terms: vec![(index, coefficient)] }
    }

    /// Adds `factor` times another form, merging equal unknowns.
    pub fn add(&mut self, factor: f64, other: &Self) {
        if factor == 0.0 {
            return;
        }
        self.constant += factor * other.constant;
        for &(index, coefficient) in &other.terms {
            match self.terms.iter().position(|(i, _)| *i == index) {
                Some(at) => {
                    self.terms[at].1 += factor * coefficient;
                    // What cancels is gone: `is_constant` tells.
                    if self.terms[at].1 == 0.0 {
                        self.terms.remove(at);
                    }
                }
                None => self.terms.push((index, factor * coefficient)),
            }
        }
    }

    /// The sum of this and `factor` times another form.
    #[must_use]
    pub fn plus(mut self, factor: f64, other: &Self) -> Self {
        self.add(factor, other);
        self
    }

    /// Its value at a point.
    ///
    /// # Panics
    ///
    /// The point has fewer coordinates than the form has unknowns.
    #[must_use]
    pub fn value(&self, x: &[f64]) -> f64 {
        self.terms.iter().fold(self.constant, |sum, &(i, c)| sum + c * x[i])
    }
}
