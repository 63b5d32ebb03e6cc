//! Limit equilibrium of a plane wedge with something at its two ends: the failure plane is the one of least weight
//! factor, ends included, and all other loads are taken on it.

use super::coulomb::{Coulomb, Wedge};
use crate::minimise::minimise;
use crate::model::{FailureSurface, ForceModel};
use crate::turn::Turn;
use crate::{Case, EarthPressureError, LoadFactors, Prediction};

/// Points of the first scan over the rise of the failure plane.
const SCAN: usize = 32;

/// A wedge on one failure plane, as its ends see it. Slant length 1.
pub(super) struct BetweenEnds {
    /// Factors of the wedge alone.
    pub(super) wedge: LoadFactors,
    /// Cotangent of the failure plane's rise.
    pub(super) plane_cot: f64,
    /// Cotangent of the tool angle.
    pub(super) plate_cot: f64,
    /// Vertical depth.
    pub(super) depth: f64,
    /// `1 / sin(alpha + delta + b + phi)`: what a force along the failure plane's normal becomes on the plate.
    pub(super) scale: f64,
    /// Depth over width.
    pub(super) depth_over_width: f64,
}

impl BetweenEnds {
    /// From the plate to where the failure plane daylights, `r / d = cot(alpha) + cot(b)`.
    pub(super) fn reach_over_depth(&self) -> f64 {
        self.plate_cot + self.plane_cot
    }
}

/// The prediction of a model whose passive factors are `ends` of a wedge. The active thrust is Coulomb's, in plane
/// strain.
pub(super) fn predict(
    id: &'static str,
    case: &Case,
    ends: impl Fn(&BetweenEnds) -> LoadFactors,
) -> Result<Prediction, EarthPressureError> {
    let plane = critical_plane(case, &ends)
        .ok_or_else(|| case.singular(id, "no failure plane has a finite force; lower alpha, phi or delta"))?;
    let mut prediction =
        Prediction::from_sides(id, case, ends(&between(case, plane)), Coulomb::active(case))?;
    prediction.notes.push("active side after Coulomb, in plane strain");
    Ok(prediction)
}

/// The failure plane between the ends, ahead of the plate.
pub(super) fn failure_surface(
    model: &dyn ForceModel,
    case: &Case,
    ends: impl Fn(&BetweenEnds) -> LoadFactors,
) -> Result<Option<FailureSurface>, EarthPressureError> {
    model.valid_range().check(model.id(), case)?;
    Ok(critical_plane(case, &ends).map(|plane| {
        let height = case.tool_angle.sin();
        FailureSurface::from_tip(case, vec![(0.0, 0.0), (height / libm::tan(plane), height)])
    }))
}

fn critical_plane(case: &Case, ends: &impl Fn(&BetweenEnds) -> LoadFactors) -> Option<f64> {
    let steepest =
        std::f64::consts::PI - case.tool_angle.radians() - case.interface.radians() - case.friction.radians();
    if steepest <= 0.0 {
        return None;
    }
    let edge = 1e-6 * steepest;
    let weight = |plane: f64| ends(&between(case, plane)).weight;
    minimise(edge, steepest - edge, SCAN, weight).map(|(plane, _)| plane)
}

fn between(case: &Case, plane: f64) -> BetweenEnds {
    let rise = Turn::of(plane);
    let sum = case.tool_angle.radians() + case.interface.radians() + plane + case.friction.radians();
    BetweenEnds {
        wedge: Wedge::of(case).factors(rise),
        plane_cot: rise.cos / rise.sin,
        plate_cot: case.tool_angle.cos() / case.tool_angle.sin(),
        depth: case.tool_angle.sin(),
        scale: 1.0 / libm::sin(sum),
        depth_over_width: case.width_ratio.depth_over_width(),
    }
}
