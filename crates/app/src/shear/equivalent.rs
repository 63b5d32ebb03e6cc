//! Friction angles at the stresses that a plate's stroke puts on the failure surface.

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_direct_shear::{
    DirectShearError, FrictionCurve, StrokeFriction, StrokeLoad, consistent_friction_at_stroke,
    friction_at_stroke,
};
use soilctl_soil::Angle;

use super::carry::{self, Carried};
use super::fits::Fitted;
use super::stroke::Given;
use crate::AppError;
use crate::text::stress;

/// Friction angles at the normal stresses of a stroke (Hong 2001, section 6.6.1).
#[derive(Debug, Serialize, JsonSchema)]
pub struct StrokeAnswer {
    /// The stroke.
    pub inputs: Inputs,
    /// One entry a point beside the plate and curve.
    pub points: Vec<StrokePoint>,
    /// What happens to the angles at another stress; only with such a stress.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub carried: Option<Vec<Carried>>,
}

/// A stroke of a plate in a level, cohesionless soil.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub struct Inputs {
    /// Tool angle.
    pub alpha_deg: f64,
    /// Vertical depth of the lower edge.
    pub depth_m: f64,
    /// Width of the plate.
    pub width_m: f64,
    /// Bulk density.
    pub density_kg_m3: f64,
    /// Gravity.
    pub gravity_m_s2: f64,
    /// Interface friction angle.
    pub delta_deg: f64,
    /// Failure force.
    pub force_n: f64,
    /// Friction angle that the stresses were computed with; null if angle and stress were made consistent.
    pub phi_deg: Option<f64>,
}

/// Stresses and angles at one point beside the plate.
#[derive(Debug, Serialize, JsonSchema)]
pub struct StrokePoint {
    /// Depth of the point as a fraction of the plate's depth.
    pub point_fraction: f64,
    /// Depth of the point.
    pub point_depth_m: f64,
    /// Pressure of the plate at that depth, along the resultant.
    pub plate_pressure_pa: f64,
    /// The curve that the angles are read from.
    pub curve: String,
    /// `sigma_L`: normal stress on the failure surface far from the plate.
    pub low_stress_pa: f64,
    /// `sigma_U`: normal stress on the failure surface beside the plate.
    pub high_stress_pa: f64,
    /// Friction angle at `sigma_L`.
    pub friction_at_low_stress_deg: f64,
    /// Friction angle at `sigma_U`.
    pub friction_at_high_stress_deg: f64,
    /// Whether `sigma_L` lies outside the stresses of the curve.
    pub low_extrapolated: bool,
    /// Whether `sigma_U` lies outside the stresses of the curve.
    pub high_extrapolated: bool,
    /// Iterations until angle and stress agreed; 0 with a given angle.
    pub iterations: usize,
    /// What to keep in mind with these numbers.
    pub note: String,
}

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
