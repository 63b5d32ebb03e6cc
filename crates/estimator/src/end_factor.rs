//! The end factor: what strokes of one campaign share about the ends of their plates.
//!
//! A bracket on the force of a plate with ends is wide because what the ends add is known only to lie between nothing and a
//! proven most. The end factor of a stroke is the part of that most which its ends do add, between 0 and 1. It is unknown, but it
//! is nearly the same for strokes in one soil, so that it is one unknown more and not one a stroke.

/// An interval of the end factor within 0 to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct EndFactors {
    pub(crate) low: f64,
    pub(crate) high: f64,
}

/// Widest interval that pieces of a cover keep.
const WIDEST: f64 = 1.0 / 32.0;

impl EndFactors {
    /// Nothing is known.
    pub(crate) const ANY: Self = Self { low: 0.0, high: 1.0 };

    /// One value.
    pub(crate) const fn at(factor: f64) -> Self {
        Self { low: factor, high: factor }
    }

    /// The middle.
    pub(crate) const fn middle(self) -> f64 {
        f64::midpoint(self.low, self.high)
    }

    /// Both halves, or nothing if it is narrow enough.
    pub(crate) fn halves(self) -> Option<[Self; 2]> {
        let middle = self.middle();
        (self.high - self.low > WIDEST)
            .then_some([Self { low: self.low, high: middle }, Self { low: middle, high: self.high }])
    }

    /// Intervals that are narrow enough and together are all.
    pub(crate) fn all() -> impl Iterator<Item = Self> {
        let count = (1.0 / WIDEST) as usize;
        (0..count).map(|i| Self { low: i as f64 * WIDEST, high: (i + 1) as f64 * WIDEST })
    }

    /// Factors of single strokes, each within a tolerance of one that they share.
    pub(crate) fn of_strokes(self, tolerance: f64) -> Self {
        Self { low: (self.low - tolerance).max(0.0), high: (self.high + tolerance).min(1.0) }
    }

    /// The least interval that holds both.
    pub(crate) const fn hull(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn halving_ends_in_the_intervals_that_are_all() {
        let mut found = vec![EndFactors::ANY];
        while let Some(halves) = found[0].halves() {
            found = found.iter().flat_map(|f| f.halves().unwrap()).collect();
            assert_eq!(halves[0].hull(halves[1]).high, halves[1].high);
        }
        assert_eq!(found, EndFactors::all().collect::<Vec<_>>());
        assert_eq!(found.into_iter().reduce(EndFactors::hull), Some(EndFactors::ANY));
    }

    #[test]
    fn factors_of_strokes_stay_within_the_proven_bracket() {
        assert_eq!(EndFactors::at(0.95).of_strokes(0.125), EndFactors { low: 0.825, high: 1.0 });
        assert_eq!(EndFactors::at(0.5).of_strokes(1.0), EndFactors::ANY);
    }
}
