use serde::Serialize;
use soilctl_soil::Angle;

use crate::curve::{FrictionAt, FrictionCurve};
use crate::degrees;
use crate::equivalent::StrokeLoad;
use crate::error::DirectShearError;

/// Angles that agree to this many degrees are the same angle.
const CONVERGED_DEG: f64 = 1e-10;
const MAX_ITERATIONS: usize = 200;

/// The friction angles that direct shear lets one expect in a stroke.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct StrokeFriction {
    /// `sigma_L` in Pa.
    pub low_stress_pa: f64,
    /// `sigma_U` in Pa.
    pub high_stress_pa: f64,
    /// Friction angle at `sigma_L`.
    #[serde(rename = "friction_at_low_stress_deg", serialize_with = "degrees::one")]
    pub friction_at_low_stress: Angle,
    /// Friction angle at `sigma_U`.
    #[serde(rename = "friction_at_high_stress_deg", serialize_with = "degrees::one")]
    pub friction_at_high_stress: Angle,
    /// The smaller of the two angles.
    #[serde(rename = "lowest_friction_deg", serialize_with = "degrees::one")]
    pub lowest_friction: Angle,
    /// The larger of the two angles.
    #[serde(rename = "highest_friction_deg", serialize_with = "degrees::one")]
    pub highest_friction: Angle,
    /// Whether `sigma_L` lies outside the stresses of the fit.
    pub low_extrapolated: bool,
    /// Whether `sigma_U` lies outside the stresses of the fit.
    pub high_extrapolated: bool,
    /// Iterations made; 0 when the friction angle was given.
    pub iterations: usize,
    /// What to keep in mind with these numbers.
    pub note: String,
}

/// Friction angles at the equivalent stresses of a stroke, the stresses computed with a given friction angle phi
/// (above 0, below 90 deg, at least delta), as in tables 6.14 and 6.15 of Hong (2001).
///
/// # Errors
/// Those of [`StrokeLoad::equivalent_stress`] and of [`FrictionCurve::friction_at`].
pub fn friction_at_stroke(
    fit: &dyn FrictionCurve,
    load: &StrokeLoad,
    friction: Angle,
) -> Result<StrokeFriction, DirectShearError> {
    let stress = load.equivalent_stress(friction)?;
    Ok(assemble(fit, load, fit.friction_at(stress.low_pa)?, fit.friction_at(stress.high_pa)?, 0))
}

/// The same without a given angle: at each end the friction angle is that of the curve at the stress which this
/// very angle produces. The two ends are separate problems.
///
/// # Errors
/// [`DirectShearError::NotConverged`] if an end does not settle to 1e-10 deg in 200 iterations, and the errors of
/// [`friction_at_stroke`].
pub fn consistent_friction_at_stroke(
    fit: &dyn FrictionCurve,
    load: &StrokeLoad,
) -> Result<StrokeFriction, DirectShearError> {
    let (low, low_iterations) = fixed_point(fit, |friction| load.low_stress_pa(friction))?;
    let (high, high_iterations) = fixed_point(fit, |friction| load.high_stress_pa(friction))?;
    Ok(assemble(fit, load, low, high, low_iterations.max(high_iterations)))
}

fn fixed_point(
    fit: &dyn FrictionCurve,
    stress_pa: impl Fn(Angle) -> Result<f64, DirectShearError>,
) -> Result<(FrictionAt, usize), DirectShearError> {
    // Start where the curve is known best. Stress depends weakly on the angle, and the angle on the
    // logarithm of stress, so plain iteration contracts unless the curve is very steep.
    let (lowest, highest) = fit.stress_range_pa();
    let mut current = fit.friction_at((lowest * highest).sqrt())?;
    let mut last_change_deg = f64::INFINITY;
    for iteration in 1..=MAX_ITERATIONS {
        let next = fit.friction_at(stress_pa(current.friction)?)?;
        last_change_deg = (next.friction.degrees() - current.friction.degrees()).abs();
        current = next;
        if last_change_deg <= CONVERGED_DEG {
            return Ok((current, iteration));
        }
    }
    Err(DirectShearError::NotConverged { iterations: MAX_ITERATIONS, last_change_deg })
}

fn assemble(
    fit: &dyn FrictionCurve,
    load: &StrokeLoad,
    low: FrictionAt,
    high: FrictionAt,
    iterations: usize,
) -> StrokeFriction {
    let swap = low.friction.radians() > high.friction.radians();
    let (lowest, highest) = if swap { (high, low) } else { (low, high) };
    StrokeFriction {
        low_stress_pa: low.normal_stress_pa,
        high_stress_pa: high.normal_stress_pa,
        friction_at_low_stress: low.friction,
        friction_at_high_stress: high.friction,
        lowest_friction: lowest.friction,
        highest_friction: highest.friction,
        low_extrapolated: low.extrapolated,
        high_extrapolated: high.extrapolated,
        iterations,
        note: note(fit, load, &low, &high),
    }
}

fn note(fit: &dyn FrictionCurve, load: &StrokeLoad, low: &FrictionAt, high: &FrictionAt) -> String {
    let (lowest, highest) = fit.stress_range_pa();
    let range = format!("the tested {lowest:.0} to {highest:.0} Pa");
    let mut notes = vec![match (low.extrapolated, high.extrapolated) {
        (false, false) => format!("both stresses lie within {range}"),
        (true, true) => format!("both stresses lie outside {range}: extrapolated angles"),
        (true, false) => format!("the low stress lies outside {range}: its angle is extrapolated"),
        (false, true) => format!("the high stress lies outside {range}: its angle is extrapolated"),
    }];
    if high.normal_stress_pa < low.normal_stress_pa {
        notes.push(
            "the plate presses less than the Rankine passive pressure, so sigma_U is below sigma_L; check force, \
             density and depth"
                .to_owned(),
        );
    }
    if load.surface_slope_deg().abs() > 1e-9 {
        notes
            .push(format!("the surface slope of {:.1} deg is left out of account", load.surface_slope_deg()));
    }
    notes.join("; ")
}
