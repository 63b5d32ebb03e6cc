//! What a jump of the velocity across a facet dissipates.

use super::position::Spatial;
use crate::CertificateError;
use crate::interval::{Angle, Interval};

/// Checks that a jump obeys the flow rule, `opening >= |jump| sin(friction)`, and gives the volume by which it opens in a
/// unit of time. `normal` is the vector of the facet's area, from the side that is left to the side that moves by `jump`
/// against it.
pub(super) fn opened(
    jump: Spatial,
    normal: Spatial,
    friction: Angle,
    place: impl Fn() -> String,
) -> Result<Interval, CertificateError> {
    let opening = jump.dot(normal);
    let spare = opening.square() - friction.sin.square() * jump.square() * normal.square();
    if jump.is_zero() || (opening.is_at_least_zero() && spare.is_at_least_zero()) {
        return Ok(opening);
    }
    let low = opening.lo().min(spare.lo()).min(-f64::MIN_POSITIVE);
    let quantity = "opening beyond what the friction demands";
    Err(CertificateError::NotProven { quantity, place: place(), low, unit: "velocity*area" })
}
