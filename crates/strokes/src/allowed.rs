/// Smallest value above zero that a column takes; keeps squares and quotients away from underflow.
const LEAST: f64 = 1e-9;
/// Largest positive value of a column; keeps squares and sums finite.
const MOST: f64 = 1e9;
/// Largest magnitude where sign is free; a clock may count seconds from 1970.
const MOST_SIGNED: f64 = 1e12;

/// The range of a column, with its unit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Allowed {
    /// Above zero.
    Positive(&'static str),
    /// Zero or above.
    AtLeastZero(&'static str),
    /// Of any sign.
    Signed(&'static str),
    /// A tool angle.
    ToolAngle,
    /// An interface friction angle.
    InterfaceAngle,
    /// A whole number from 0.
    Whole,
    /// A standard deviation of a force in N; zero has a message of its own.
    Deviation,
}

impl Allowed {
    /// Whether a value is in the range; NaN and infinities never are.
    pub(crate) fn holds(self, value: f64) -> bool {
        match self {
            Self::Positive(_) => (LEAST..=MOST).contains(&value),
            Self::AtLeastZero(_) | Self::Deviation => (0.0..=MOST).contains(&value),
            Self::Signed(_) => value.abs() <= MOST_SIGNED,
            Self::ToolAngle => value > 0.0 && value < 180.0,
            Self::InterfaceAngle => (0.0..90.0).contains(&value),
            Self::Whole => value.fract() == 0.0 && (0.0..=f64::from(u32::MAX)).contains(&value),
        }
    }

    /// The range in words.
    pub(crate) fn words(self) -> String {
        match self {
            Self::Positive(unit) => format!("above 0{} (from {LEAST:e} to {MOST:e})", spaced(unit)),
            Self::AtLeastZero(unit) => format!("at least 0{} (up to {MOST:e})", spaced(unit)),
            Self::Signed(unit) => {
                format!("a finite number{} (magnitude up to {MOST_SIGNED:e})", of_unit(unit))
            }
            Self::ToolAngle => "above 0 and below 180 deg".into(),
            Self::InterfaceAngle => "at least 0 and below 90 deg".into(),
            Self::Deviation => format!("above 0 N (up to {MOST:e})"),
            Self::Whole => format!("a whole number from 0 to {}", u32::MAX),
        }
    }
}

fn spaced(unit: &str) -> String {
    if unit.is_empty() { String::new() } else { format!(" {unit}") }
}

fn of_unit(unit: &str) -> String {
    if unit.is_empty() { String::new() } else { format!(" of {unit}") }
}
