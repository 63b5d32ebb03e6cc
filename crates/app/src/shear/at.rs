//! Friction angles at the stresses asked for.

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_direct_shear::DirectShearError;

use super::fits::Fitted;
use crate::AppError;
use crate::text::stress;

/// The friction angle that a curve gives at a normal stress.
#[derive(Debug, Serialize, JsonSchema)]
pub struct AngleAt {
    /// The normal stress asked for.
    pub normal_stress_pa: f64,
    /// The angle there.
    pub friction_angle_deg: f64,
    /// Whether the stress lies outside those that the curve was fitted to.
    pub extrapolated: bool,
    /// `power law` or `slope and floor`; `constant angle` if neither could be fitted.
    pub curve: String,
    /// Standard error of predicting one further test there from the scatter about the curve; null where there is no
    /// theory for it. Extrapolated, the true error is larger.
    pub standard_error_deg: Option<f64>,
}

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
