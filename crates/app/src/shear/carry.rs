//! What happens to the friction angle of a stroke at another normal stress.

use soilctl_direct_shear::{DirectShearError, StressShift, stress_shift};

use super::answer::{Carried, StrokePoint};
use super::fits::Fitted;
use crate::AppError;

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
