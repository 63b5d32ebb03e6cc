use soilctl_certificate::CertificateError;
use soilctl_conic::ConicError;
use thiserror::Error;

use crate::describe::DescriptionError;
use crate::mesh::MeshError;

/// A bound without its counterpart.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum OneSide {
    /// What is bounded is at least this.
    Lower(f64),
    /// It is at most this.
    Upper(f64),
}

/// What can go wrong on the way to a bound.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum LimitError {
    /// The geometry or the mesh.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// A proof was refused.
    #[error(transparent)]
    Certificate(#[from] CertificateError),
    /// A number of a solution is too large to be written for another program.
    #[error("field \"{field}\": a value is {value}; it must be finite")]
    NotFinite {
        /// What the number is.
        field: &'static str,
        /// Its value.
        value: f64,
    },
    /// A problem description makes no sense.
    #[error(transparent)]
    Description(#[from] DescriptionError),
    /// A number is outside its range.
    #[error("{quantity} is {value} {unit}, allowed is {} {unit}", span(*.low, *.high))]
    Range {
        /// Name of the number.
        quantity: &'static str,
        /// Its value.
        value: f64,
        /// Least value allowed.
        low: f64,
        /// Bound above.
        high: f64,
        /// Unit, empty for pure numbers.
        unit: &'static str,
    },
    /// The problem is sound but cannot be solved yet.
    #[error("{what}: not covered; {advice}")]
    NotCovered {
        /// What the problem has.
        what: &'static str,
        /// What the user can do.
        advice: &'static str,
    },
    /// No load is finite, or none is possible; in physical words.
    #[error("there is no collapse load: {reason}; {advice}")]
    NoCollapse {
        /// Why.
        reason: &'static str,
        /// What the user can do.
        advice: &'static str,
    },
    /// The budget ended before the first pair of bounds was proven.
    #[error("no pair of bounds was proven within the budget ({spent}); {advice}")]
    NothingProven {
        /// The one bound that was, if there is one: in units of the statement, or a factor of safety.
        proven: Option<OneSide>,
        /// What was done so far.
        spent: String,
        /// What the user can do.
        advice: &'static str,
    },
    /// No stress field about the end of a plate was found.
    #[error("no stress field about the plate's end was found: {why}; {advice}")]
    NoField {
        /// Why.
        why: &'static str,
        /// What the user can do.
        advice: &'static str,
    },
    /// A program could not be solved at all.
    #[error(transparent)]
    Conic(#[from] ConicError),
}

/// A range in words. Limits next to a number that is shorter to write mean that one.
fn span(low: f64, high: f64) -> String {
    let is_shorter = |a: f64, b: f64| a.to_string().len() < b.to_string().len();
    let low = match low.next_down() {
        _ if low == f64::MIN_POSITIVE => "above 0".to_owned(),
        under if is_shorter(under, low) => format!("above {under}"),
        _ => format!("from {low}"),
    };
    match high.next_down() {
        under if is_shorter(under, high) => format!("{low} up to {under}"),
        _ => format!("{low} up to, but not including, {high}"),
    }
}

/// Checks that a number is at least `low` and below `high`.
pub(crate) fn in_range(
    quantity: &'static str,
    value: f64,
    low: f64,
    high: f64,
    unit: &'static str,
) -> Result<(), LimitError> {
    if value >= low && value < high {
        Ok(())
    } else {
        Err(LimitError::Range { quantity, value, low, high, unit })
    }
}

impl LimitError {
    /// The same error, where one side is proven.
    pub(crate) fn with_proven(mut self, side: Option<OneSide>) -> Self {
        if let Self::NothingProven { proven, .. } = &mut self {
            *proven = side;
        }
        self
    }

    /// Nothing proven, with what may help: some soil may bear no tension at all.
    pub(crate) fn nothing_proven(without_tension: bool, spent: String) -> Self {
        let advice = if without_tension {
            "allow more work, elements, memory or time, or soil that bears no tension at all a thousandth of its cohesion: stresses \
             along a free face have no other room for a proof"
        } else {
            "allow more work, elements, memory or time"
        };
        Self::NothingProven { proven: None, spent, advice }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_read_well() {
        assert_eq!(span(f64::MIN_POSITIVE, 70.0), "above 0 up to, but not including, 70");
        assert_eq!(span(0.0, 30.0_f64.next_up()), "from 0 up to 30");
        assert_eq!(span((-30.0_f64).next_up(), 30.0), "above -30 up to, but not including, 30");
        assert_eq!(span(-90.0, f64::INFINITY), "from -90 up to, but not including, inf");
    }
}
