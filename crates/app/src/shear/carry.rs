//! What happens to the friction angle of a stroke at another normal stress.

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_direct_shear::{DirectShearError, StressShift, stress_shift};

use super::equivalent::StrokePoint;
use super::fits::Fitted;
use crate::AppError;

/// The shift of the friction angle from a stress of the stroke to another one (Hong 2001, section 6.7.3).
#[derive(Debug, Serialize, JsonSchema)]
pub struct Carried {
    /// Depth of the point as a fraction of the plate's depth.
    pub point_fraction: f64,
    /// `sigma_L` or `sigma_U`.
    pub from: String,
    /// The curve: the one with a floor if it could be fitted, because a power law falls for ever.
    pub curve: String,
    /// Stress of the stroke.
    pub measured_stress_pa: f64,
    /// Stress at which the angle is to be used.
    pub used_stress_pa: f64,
    /// To be added to the angle of the stroke.
    pub shift_deg: f64,
    /// Whether the stress of the stroke lies outside those of the curve.
    pub measured_extrapolated: bool,
    /// Whether the stress of use lies outside those of the curve.
    pub used_extrapolated: bool,
    /// The same in words.
    pub warning: String,
}

/// The shifts of one curve from both stresses of every point; the largest one becomes a warning.
pub(super) fn shifts(
    fitted: &Fitted,
    points: &[StrokePoint],
    to_pa: f64,
    warnings: &mut Vec<String>,
) -> Result<Vec<Carried>, AppError> {
    let mut found: Vec<Carried> = Vec::new();
    let Some(curve) = fitted.curves().pop() else { return Ok(found) };
    for point in points.iter().filter(|point| point.curve == curve.name()) {
        for (from, stress_pa) in [("sigma_L", point.low_stress_pa), ("sigma_U", point.high_stress_pa)] {
            match stress_shift(curve, stress_pa, to_pa) {
                Ok(shift) => found.push(Carried::of(point.point_fraction, from, curve.name(), shift)),
                Err(problem @ DirectShearError::OutOfRange { .. }) => return Err(problem.into()),
                Err(problem) => warnings.push(format!("{}: {problem}", fitted.name())),
            }
        }
    }
    let largest = found.iter().max_by(|a, b| a.shift_deg.abs().total_cmp(&b.shift_deg.abs()));
    warnings.extend(largest.map(|shift| format!("{}: {}", fitted.name(), shift.warning)));
    Ok(found)
}

impl Carried {
    fn of(point_fraction: f64, from: &str, curve: &str, shift: StressShift) -> Self {
        Self {
            point_fraction,
            from: from.into(),
            curve: curve.into(),
            measured_stress_pa: shift.measured_stress_pa,
            used_stress_pa: shift.used_stress_pa,
            shift_deg: shift.shift_deg,
            measured_extrapolated: shift.measured_extrapolated,
            used_extrapolated: shift.used_extrapolated,
            warning: shift.warning,
        }
    }
}
