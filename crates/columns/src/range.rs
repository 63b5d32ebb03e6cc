/// Smallest value above zero that a column takes; keeps squares and quotients away from underflow.
const LEAST: f64 = 1e-9;
/// Largest positive value of a column; keeps squares and sums finite.
const MOST: f64 = 1e9;
/// Largest magnitude where sign is free; a clock may count seconds from 1970.
const MOST_SIGNED: f64 = 1e12;

/// The values that a column takes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Range {
    /// Any text.
    Text,
    /// Above zero, up to 1e9.
    Positive,
    /// Zero or above, up to 1e9.
    AtLeastZero,
    /// Of any sign, up to 1e12.
    Signed,
    /// Above zero and below this.
    Between0And(f64),
    /// Zero or above, and below this.
    From0Below(f64),
    /// A whole number that 32 bits hold.
    Whole,
    /// A standard deviation, above zero; a reader may let zero pass as exact data.
    Deviation,
}

impl Range {
    /// Whether a number is in the range; NaN and infinities never are. A deviation of zero is.
    #[must_use]
    pub fn holds(self, value: f64) -> bool {
        match self {
            Self::Text => false,
            Self::Positive => (LEAST..=MOST).contains(&value),
            Self::AtLeastZero | Self::Deviation => (0.0..=MOST).contains(&value),
            Self::Signed => value.abs() <= MOST_SIGNED,
            Self::Between0And(end) => value > 0.0 && value < end,
            Self::From0Below(end) => (0.0..end).contains(&value),
            Self::Whole => value.fract() == 0.0 && (0.0..=f64::from(u32::MAX)).contains(&value),
        }
    }

    /// The range in words, with its unit; the unit of numbers without one is `1`.
    #[must_use]
    pub fn words(self, unit: &str) -> String {
        let (space, unit) = if unit == "1" { ("", "") } else { (" ", unit) };
        match self {
            Self::Text => "any text".into(),
            Self::Positive => format!("above 0{space}{unit} (from {LEAST:e} to {MOST:e})"),
            Self::AtLeastZero => format!("at least 0{space}{unit} (up to {MOST:e})"),
            Self::Signed => {
                let of = if unit.is_empty() { "" } else { " of " };
                format!("a finite number{of}{unit} (magnitude up to {MOST_SIGNED:e})")
            }
            Self::Between0And(end) => format!("above 0 and below {end}{space}{unit}"),
            Self::From0Below(end) => format!("at least 0 and below {end}{space}{unit}"),
            Self::Whole => format!("a whole number from 0 to {}", u32::MAX),
            Self::Deviation => format!("above 0{space}{unit} (up to {MOST:e})"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_number_is_in_no_range() {
        for range in [Range::Positive, Range::AtLeastZero, Range::Signed, Range::Whole, Range::Deviation] {
            assert!([f64::NAN, f64::INFINITY, f64::NEG_INFINITY].iter().all(|value| !range.holds(*value)));
        }
    }

    #[test]
    fn ends_belong_to_a_range_as_its_words_say() {
        assert_eq!([0.0, 90.0, 180.0].map(|x| Range::Between0And(180.0).holds(x)), [false, true, false]);
        assert_eq!([0.0, 89.9, 90.0].map(|x| Range::From0Below(90.0).holds(x)), [true, true, false]);
        assert_eq!([0.0, 2.0, 2.5, -1.0].map(|x| Range::Whole.holds(x)), [true, true, false, false]);
        assert_eq!(Range::Between0And(180.0).words("deg"), "above 0 and below 180 deg");
        assert_eq!(Range::Signed.words("1"), "a finite number (magnitude up to 1e12)");
        assert_eq!(Range::Signed.words("m"), "a finite number of m (magnitude up to 1e12)");
    }
}
