/// An affine function of the unknowns of a program: `constant + sum of coefficient * x[index]`.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Form {
    pub(crate) constant: f64,
    pub(crate) terms: Vec<(usize, f64)>,
}

impl Form {
    pub(crate) fn constant(value: f64) -> Self {
        Self { constant: value, terms: Vec::new() }
    }

    pub(crate) fn unknown(index: usize, coefficient: f64) -> Self {
        Self { constant: 0.0, terms: vec![(index, coefficient)] }
    }

    /// Adds `factor` times another form, merging equal unknowns.
    pub(crate) fn add(&mut self, factor: f64, other: &Self) {
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

    pub(crate) fn plus(mut self, factor: f64, other: &Self) -> Self {
        self.add(factor, other);
        self
    }

    pub(crate) fn value(&self, x: &[f64]) -> f64 {
        self.terms.iter().fold(self.constant, |sum, &(i, c)| sum + c * x[i])
    }
}
