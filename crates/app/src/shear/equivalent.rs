//! Friction angles at the stresses that a plate's stroke puts on the failure surface.

use soilctl_direct_shear::{
    DirectShearError, FrictionCurve, StrokeFriction, StrokeLoad, consistent_friction_at_stroke,
    friction_at_stroke,
};
use soilctl_soil::Angle;

use super::answer::{StrokeAnswer, StrokePoint};
use super::carry;
use super::fits::Fitted;
use super::stroke::Given;
use crate::AppError;
use crate::text::stress;

impl Given {
    /// The angles of every curve at every point; `None`, with warnings, if no curve gives any.
    pub(super) fn friction(
        &self,
        fitted: &Fitted,
        warnings: &mut Vec<String>,
    ) -> Result<Option<StrokeAnswer>, AppError> {
        let mut points = Vec::new();
        for (fraction, load) in &self.loads {
            for curve in fitted.curves() {
                match self.on_curve(curve, load) {
                    Ok(found) => points.push(StrokePoint::of(*fraction, load, curve.name(), &found)),
                    Err(problem) => warnings.push(format!(
                        "{}, stroke at {fraction} of the depth, {}: {problem}",
                        fitted.name(),
                        curve.name()
                    )),
                }
            }
        }
        if points.is_empty() {
            return Ok(None);
        }
        warnings.extend(reach(fitted, &points));
        warnings.extend(weak_plate(fitted, &points));
        let carry = |to_pa| carry::shifts(fitted, &points, to_pa, warnings);
        let carried = self.carry_to_pa.map(carry).transpose()?;
        Ok(Some(StrokeAnswer { inputs: self.inputs, points, carried }))
    }

    fn on_curve(
        &self,
        curve: &dyn FrictionCurve,
        load: &StrokeLoad,
    ) -> Result<StrokeFriction, DirectShearError> {
        match self.inputs.phi_deg {
            Some(phi_deg) => friction_at_stroke(curve, load, Angle::from_degrees(phi_deg)),
            None => consistent_friction_at_stroke(curve, load),
        }
    }
}

impl StrokePoint {
    fn of(fraction: f64, load: &StrokeLoad, curve: &str, found: &StrokeFriction) -> Self {
        Self {
            point_fraction: fraction,
            point_depth_m: load.point_depth_m(),
            plate_pressure_pa: load.plate_pressure_pa(),
            curve: curve.into(),
            low_stress_pa: found.low_stress_pa,
            high_stress_pa: found.high_stress_pa,
            friction_at_low_stress_deg: found.friction_at_low_stress.degrees(),
            friction_at_high_stress_deg: found.friction_at_high_stress.degrees(),
            low_extrapolated: found.low_extrapolated,
            high_extrapolated: found.high_extrapolated,
            iterations: found.iterations,
            note: found.note.clone(),
        }
    }
}

/// The warning that the stroke is gentler than the lowest tested load.
fn reach(fitted: &Fitted, points: &[StrokePoint]) -> Option<String> {
    let stresses = points.iter().flat_map(|point| [point.low_stress_pa, point.high_stress_pa]);
    let lowest = stresses.fold(f64::INFINITY, f64::min);
    fitted.is_below_tested(lowest).then(|| {
        format!(
            "{}: the stresses of the stroke, from {} on, reach below the lowest tested load, {}: the angles there are \
             extrapolated",
            fitted.name(),
            stress(lowest),
            stress(fitted.tested_pa().0)
        )
    })
}

/// The warning that the plate presses too little for a failure.
fn weak_plate(fitted: &Fitted, points: &[StrokePoint]) -> Option<String> {
    points.iter().any(|point| point.high_stress_pa < point.low_stress_pa).then(|| {
        format!(
            "{}: sigma_U is below sigma_L, for the plate presses less than the Rankine passive pressure; check force, \
             density and depth",
            fitted.name()
        )
    })
}
