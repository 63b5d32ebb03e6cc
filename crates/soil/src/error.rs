use thiserror::Error;

use crate::Rounded;

/// What can be wrong with a soil, an interface, a plate or a stroke.
///
/// Every message names the quantity, the value that was given, what is allowed and its unit. Numbers are
/// rounded in the message only ([`Rounded`]).
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum SoilError {
    /// A quantity is outside the range in which it means anything.
    #[error("{quantity} is {} {unit}; it must be {allowed}", Rounded(*.value))]
    OutOfRange {
        /// Name of the quantity, as the command line calls it.
        quantity: &'static str,
        /// The value given, in `unit`.
        value: f64,
        /// Unit of `value`.
        unit: &'static str,
        /// The allowed range in words.
        allowed: &'static str,
    },
    /// Interface friction above the friction of the soil itself: the soil would shear first.
    #[error(
        "interface friction delta is {} deg, more than the soil's friction phi of {} deg; \
         soil slides on soil before it slides on the plate, so use delta <= phi",
        Rounded(*.delta_deg), Rounded(*.phi_deg)
    )]
    InterfaceRougherThanSoil {
        /// Interface friction in degrees.
        delta_deg: f64,
        /// Soil friction in degrees.
        phi_deg: f64,
    },
    /// Lower bound above upper bound.
    #[error(
        "a bracket needs finite ends and lower <= upper, but lower is {} and upper is {}",
        Rounded(*.lower), Rounded(*.upper)
    )]
    InvertedBracket {
        /// The lower value.
        lower: f64,
        /// The upper value.
        upper: f64,
    },
}

/// `value` if it is finite and satisfies `ok`, otherwise the error that says what is allowed.
pub(crate) fn check(
    quantity: &'static str,
    value: f64,
    unit: &'static str,
    allowed: &'static str,
    ok: impl Fn(f64) -> bool,
) -> Result<f64, SoilError> {
    if value.is_finite() && ok(value) {
        Ok(value)
    } else {
        Err(SoilError::OutOfRange { quantity, value, unit, allowed })
    }
}
