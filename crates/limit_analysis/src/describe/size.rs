//! The units of the statement, and its datum.

use super::error::DescriptionError;
use super::fill::Units;
use super::holds::Holds;
use super::input::{Aim, Description, SoilEntry};
use super::plan::Plan;
use crate::vector::Point;

/// The height of the level free ground: of soil that must not be loaded there first, then the longest.
fn datum(description: &Description, plan: &Plan) -> f64 {
    let bare = plan.levels(|w, h| *h == Holds::Free && plan.is_bare(description, w));
    let free = plan.levels(|_, h| *h == Holds::Free);
    bare.first().or(free.first()).map_or(plan.drawing.high[1], |level| level.0)
}

/// Width (0) or height (1) of the box around some lines.
fn span(lines: &[[Point; 2]], axis: usize) -> f64 {
    let coordinates = || lines.iter().flatten().map(|p| p[axis]);
    let low = coordinates().fold(f64::INFINITY, f64::min);
    (coordinates().fold(f64::NEG_INFINITY, f64::max) - low).max(0.0)
}

fn extent(lines: &[[Point; 2]]) -> f64 {
    span(lines, 0).max(span(lines, 1))
}

/// Lengths in units of what moves or carries the load, or of the height of the free ground; stresses in units of the
/// largest there are at that size: so the numbers of the statement are of the order of one.
pub(super) fn units(description: &Description, plan: &Plan, at_far: f64) -> Result<Units, DescriptionError> {
    let faces = || plan.where_holds(|_, h| matches!(h, Holds::Face(_)));
    let live = || plan.where_holds(|_, h| matches!(h, Holds::Load { live: true, .. }));
    let free = plan.where_holds(|_, h| matches!(h, Holds::Free | Holds::Load { .. }));
    let soil = plan.drawing.high[1] - plan.drawing.low[1];
    let lead = match description.objective {
        Aim::Structure { .. } => extent(&faces()),
        Aim::Load {} => extent(&live()),
        _ => span(&free, 1),
    };
    // Flat ground has no height to speak of.
    let length_m = if lead > 1e-3 * soil { lead } else { soil };
    let [x, y] = [0.5 * (plan.drawing.low[0] + plan.drawing.high[0]), datum(description, plan)];
    let cohesion = |[_, p]: [Point; 2]| {
        let at = |s: &SoilEntry| {
            let level = s.cohesion_level_m.unwrap_or(0.0);
            s.cohesion_kpa + s.cohesion_gradient_kpa_per_m * (level - p[1]).abs().min(2.0 * length_m)
        };
        description.soils.iter().map(at).fold(0.0, f64::max)
    };
    let cohesion = free.iter().copied().map(cohesion).fold(0.0, f64::max);
    let loads = plan.holds.values().flat_map(|h| match h {
        Holds::Load { pressure, shear, .. } => {
            vec![pressure[0].abs(), pressure[1].abs(), shear[0].abs(), shear[1].abs()]
        }
        Holds::Face(face) => vec![face.adhesion_kpa],
        _ => Vec::new(),
    });
    let weight = description.soils.iter().map(|s| s.unit_weight_kn_m3).fold(0.0, f64::max);
    let strength = description.soils.iter().map(SoilEntry::at_no_pressure_kpa).fold(cohesion, f64::max);
    let stress_kpa = loads.fold((weight * length_m).max(strength).max(at_far), f64::max);
    if stress_kpa > 0.0 {
        return Ok(Units { origin: [x, y], length_m, stress_kpa });
    }
    let problem = "there is neither weight nor cohesion nor load, so nothing resists or drives";
    Err(DescriptionError::entry("the problem", problem))
}
