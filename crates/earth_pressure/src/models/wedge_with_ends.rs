//! Limit equilibrium of a plane wedge with something at its two ends: the failure plane is the one of least weight
//! factor, ends included, and all other loads are taken on it.
//!
//! The least may be at the steepest plane for which a model's ends have a meaning, which is then tried itself.

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

/// The prediction of a model whose passive factors are `ends` of a wedge, with failure planes that rise up to `steepest`
/// (radians). The active thrust is Coulomb's, in plane strain.
pub(super) fn predict(
    id: &'static str,
    case: &Case,
    steepest: f64,
    ends: impl Fn(&BetweenEnds) -> LoadFactors,
) -> Result<Prediction, EarthPressureError> {
    let (wedges, plane) = critical(id, case, steepest, &ends)?;
    let passive = ends(&wedges.on(plane));
    let mut prediction = Prediction::from_sides(id, case, passive, Coulomb::active(case))?;
    prediction.notes.push("active side after Coulomb, in plane strain");
    if plane > steepest - 1e-9 {
        prediction.notes.push(
            "the failure plane of least force is the steepest of this model, where its ends vanish: a narrow plate in \
             this position is beyond the model",
        );
    }
    Ok(prediction)
}

/// The failure plane between the ends, ahead of the plate.
pub(super) fn failure_surface(
    model: &dyn ForceModel,
    case: &Case,
    steepest: f64,
    ends: impl Fn(&BetweenEnds) -> LoadFactors,
) -> Result<Option<FailureSurface>, EarthPressureError> {
    model.valid_range().check(model.id(), case)?;
    let (wedges, plane) = critical(model.id(), case, steepest, &ends)?;
    let (height, reach) = (wedges.depth, wedges.depth / libm::tan(plane));
    Ok(Some(FailureSurface::from_tip(case, vec![(0.0, 0.0), (reach, height)])))
}

/// The wedges of a case and the rise of the failure plane of least weight factor.
fn critical(
    id: &'static str,
    case: &Case,
    steepest: f64,
    ends: &impl Fn(&BetweenEnds) -> LoadFactors,
) -> Result<(Wedges, f64), EarthPressureError> {
    let wedges = Wedges::of(case);
    // Steeper planes hold the wedge whatever the force.
    let holding =
        std::f64::consts::PI - case.tool_angle.radians() - case.interface.radians() - case.friction.radians();
    let edge = 1e-6 * holding;
    let weight = |plane: f64| ends(&wedges.on(plane)).weight;
    let found = if holding > 0.0 { minimise(edge, steepest.min(holding - edge), SCAN, weight) } else { None };
    let (plane, _) = found
        .ok_or_else(|| case.singular(id, "no failure plane has a finite force; lower alpha, phi or delta"))?;
    Ok((wedges, plane))
}

/// What all failure planes of a case have in common.
struct Wedges {
    wedge: Wedge,
    /// `alpha + delta + phi`.
    sum: Turn,
    plate_cot: f64,
    depth: f64,
    depth_over_width: f64,
}

impl Wedges {
    fn of(case: &Case) -> Self {
        let wedge = Wedge::of(case);
        let sum = case.tool_angle.radians() + case.interface.radians() + case.friction.radians();
        Self {
            wedge,
            sum: Turn::of(sum),
            plate_cot: case.tool_angle.cos() / case.tool_angle.sin(),
            depth: case.tool_angle.sin(),
            depth_over_width: case.width_ratio.depth_over_width(),
        }
    }

    fn on(&self, plane: f64) -> BetweenEnds {
        let rise = Turn::of(plane);
        BetweenEnds {
            wedge: self.wedge.factors(rise),
            plane_cot: rise.cos / rise.sin,
            plate_cot: self.plate_cot,
            depth: self.depth,
            scale: 1.0 / (self.sum + rise).sin,
            depth_over_width: self.depth_over_width,
        }
    }
}
