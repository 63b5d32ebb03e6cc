use serde::{Deserialize, Serialize};

use crate::SoilError;

/// Where the two ends of a [`Bracket`] come from.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Provenance {
    /// What produced the lower end.
    pub lower: String,
    /// What produced the upper end.
    pub upper: String,
}

/// A quantity known only to lie between two values, and why we believe that.
///
/// A point prediction is a bracket of zero width.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Bracket {
    lower: f64,
    upper: f64,
    provenance: Provenance,
}

impl Bracket {
    /// A bracket from its ends.
    ///
    /// # Errors
    /// [`SoilError::InvertedBracket`] if an end is not finite or `lower > upper`.
    pub fn new(lower: f64, upper: f64, provenance: Provenance) -> Result<Self, SoilError> {
        if lower.is_finite() && upper.is_finite() && lower <= upper {
            Ok(Self { lower, upper, provenance })
        } else {
            Err(SoilError::InvertedBracket { lower, upper })
        }
    }

    /// The lower end.
    #[must_use]
    pub const fn lower(&self) -> f64 {
        self.lower
    }

    /// The upper end.
    #[must_use]
    pub const fn upper(&self) -> f64 {
        self.upper
    }

    /// Where the ends come from.
    #[must_use]
    pub const fn provenance(&self) -> &Provenance {
        &self.provenance
    }

    /// Relative width `(upper - lower) / mid`; 0 for a bracket around zero of zero width.
    #[must_use]
    pub fn gap(&self) -> f64 {
        let mid = f64::midpoint(self.lower, self.upper);
        if self.upper == self.lower { 0.0 } else { (self.upper - self.lower) / mid }
    }

    /// The value halfway in the logarithm, `sqrt(lower * upper)`; `None` unless both ends are positive.
    #[must_use]
    pub fn geometric_mean(&self) -> Option<f64> {
        (self.lower > 0.0).then(|| (self.lower * self.upper).sqrt())
    }

    /// Whether `value` lies inside, ends included.
    #[must_use]
    pub fn contains(&self, value: f64) -> bool {
        self.lower <= value && value <= self.upper
    }

    /// Whether the two closed intervals share a point.
    #[must_use]
    pub fn meets(&self, low: f64, high: f64) -> bool {
        self.lower <= high && low <= self.upper
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn provenance() -> Provenance {
        Provenance { lower: "a".into(), upper: "b".into() }
    }

    #[test]
    fn inverted_or_non_finite_ends_are_refused() {
        for (lower, upper) in [(2.0, 1.0), (f64::NAN, 1.0), (0.0, f64::INFINITY)] {
            assert!(Bracket::new(lower, upper, provenance()).is_err());
        }
    }

    #[test]
    fn gap_is_relative_to_the_middle() {
        let bracket = Bracket::new(0.9, 1.1, provenance()).unwrap();
        assert!((bracket.gap() - 0.2).abs() < 1e-12);
        assert!(bracket.contains(1.1) && bracket.meets(1.05, 3.0) && !bracket.meets(1.2, 3.0));
    }
}
