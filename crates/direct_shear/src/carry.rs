use serde::Serialize;

use crate::curve::FrictionCurve;
use crate::error::DirectShearError;

/// How a friction angle changes when it is carried from one normal stress to another.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct StressShift {
    /// Stress in Pa at which the angle was measured.
    pub measured_stress_pa: f64,
    /// Stress in Pa at which it is to be used.
    pub used_stress_pa: f64,
    /// To be added to the measured angle, in degrees; negative when the soil is weaker where it is used.
    pub shift_deg: f64,
    /// Whether the first stress is outside the fitted stresses.
    pub measured_extrapolated: bool,
    /// Whether the second stress is outside the fitted stresses.
    pub used_extrapolated: bool,
    /// The same in words, for a report.
    pub warning: String,
}

/// The shift of the friction angle between two normal stresses in Pa (Hong 2001, section 6.7.3: 5 to 9 degrees
/// between the lowest and the high loads).
///
/// # Errors
/// Those of [`FrictionCurve::friction_at`] at either stress.
pub fn stress_shift(
    fit: &dyn FrictionCurve,
    measured_stress_pa: f64,
    used_stress_pa: f64,
) -> Result<StressShift, DirectShearError> {
    let measured = fit.friction_at(measured_stress_pa)?;
    let used = fit.friction_at(used_stress_pa)?;
    let shift_deg = used.friction.degrees() - measured.friction.degrees();
    let effect = match shift_deg {
        shift if shift < -0.05 => {
            format!("lower it by {:.1} deg, or forces there are overestimated", -shift)
        }
        shift if shift > 0.05 => format!("raise it by {shift:.1} deg, or forces there are underestimated"),
        _ => "the curve gives the same angle at both".to_owned(),
    };
    let mut warning = format!(
        "a friction angle measured at {measured_stress_pa:.0} Pa is used at {used_stress_pa:.0} Pa: {effect} ({})",
        fit.name()
    );
    let (lowest, highest) = fit.stress_range_pa();
    let outside = match (measured.extrapolated, used.extrapolated) {
        (false, false) => None,
        (true, false) => Some("the stress of the measurement is"),
        (false, true) => Some("the stress of use is"),
        (true, true) => Some("both stresses are"),
    };
    if let Some(outside) = outside {
        warning += &format!(
            "; {outside} outside the tested {lowest:.0} to {highest:.0} Pa, so the shift is a guess"
        );
    }
    Ok(StressShift {
        measured_stress_pa,
        used_stress_pa,
        shift_deg,
        measured_extrapolated: measured.extrapolated,
        used_extrapolated: used.extrapolated,
        warning,
    })
}
