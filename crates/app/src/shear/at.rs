//! Friction angles at the stresses asked for.

use soilctl_direct_shear::DirectShearError;

use super::answer::AngleAt;
use super::fits::Fitted;
use crate::AppError;
use crate::text::stress;

/// The angles of every curve at every stress.
pub(super) fn angles(
    fitted: &Fitted,
    stresses_pa: &[f64],
    warnings: &mut Vec<String>,
) -> Result<Vec<AngleAt>, AppError> {
    let mut found = Vec::new();
    for &stress_pa in stresses_pa {
        let before = found.len();
        for curve in fitted.curves() {
            match curve.friction_at(stress_pa) {
                Ok(at) => found.push(AngleAt {
                    normal_stress_pa: stress_pa,
                    friction_angle_deg: at.friction.degrees(),
                    extrapolated: at.extrapolated,
                    curve: curve.name().into(),
                    standard_error_deg: at.standard_error_deg,
                }),
                Err(problem @ DirectShearError::OutOfRange { .. }) => return Err(problem.into()),
                Err(problem) => warnings.push(format!("{}: {problem}", fitted.name())),
            }
        }
        if found.len() > before {
            warnings.extend(outside_tested(fitted, stress_pa));
        }
    }
    Ok(found)
}

/// The warning that a stress is below or above all tested ones.
fn outside_tested(fitted: &Fitted, stress_pa: f64) -> Option<String> {
    let (low, high) = fitted.tested_pa();
    let beyond = if fitted.is_below_tested(stress_pa) {
        format!("below the lowest tested load, {}", stress(low))
    } else if fitted.is_above_tested(stress_pa) {
        format!("above the highest tested load, {}", stress(high))
    } else {
        return None;
    };
    Some(format!("{}: {} is {beyond}: the angles there are extrapolated", fitted.name(), stress(stress_pa)))
}
