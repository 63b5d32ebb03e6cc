//! One soil that looks like ground which changes: its friction falls with stress, or it has some cohesion.

use soilctl_earth_pressure::Case;
use soilctl_estimator::{Estimate, Quantity, estimate};
use soilctl_soil::{Angle, WidthRatio};

use super::answer::Alias;
use super::strokes::Strokes;
use crate::AppError;
use crate::estimate::{Intervals, Known, Request};
use crate::text::to_two_digits;

/// Falls of the friction angle (deg a decade of stress) that are allowed: what `--friction-law` alone means.
const SLOPES_DEG: (f64, f64) = (0.0, 8.0);
/// Cohesion is allowed up to this part of the vertical pressure at the deepest edge in a soil of this density (kg/m3).
const COHESION_PART: f64 = 0.25;
const USUAL_DENSITY_KG_M3: f64 = 1600.0;
/// Whether a model covers cohesion does not depend on the friction angle (deg).
const USUAL_PHI_DEG: f64 = 35.0;

/// Of strokes that one soil explains anyway.
const fn plain(allowed: [f64; 2]) -> Alias {
    Alias { consistent: Some(true), allowed, left: None, phi_deg: None }
}

fn alias(found: &Estimate, allowed: [f64; 2], left: Option<[f64; 2]>) -> Alias {
    let left = left.filter(|_| found.is_consistent());
    Alias { consistent: Some(found.is_consistent()), allowed, left, phi_deg: found.phi_deg }
}

/// One soil whose friction angle falls with stress.
pub(super) fn friction_law(known: &Known, request: &Request, is_plain: bool) -> Result<Alias, AppError> {
    if is_plain {
        return Ok(plain(SLOPES_DEG.into()));
    }
    let request = Request { friction_law: Some(SLOPES_DEG), ..request.clone() };
    let found = estimate(&known.setup(&request)?)?;
    let slopes = found.slices.iter().map(|slice| slice.slope_deg_per_decade);
    let left = slopes.reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])]);
    Ok(alias(&found, SLOPES_DEG.into(), left))
}

/// One soil with some cohesion, the same at all depths.
pub(super) fn cohesion(
    known: &Known,
    request: &Request,
    strokes: &Strokes<'_>,
    is_plain: bool,
) -> Result<Alias, AppError> {
    let pressure_pa = USUAL_DENSITY_KG_M3 * strokes.setup.gravity_m_s2 * strokes.depths_m[1];
    let most_pa = to_two_digits(COHESION_PART * pressure_pa);
    if is_plain {
        return Ok(plain([0.0, most_pa]));
    }
    let covered = strokes.setup.observations.iter().all(|observation| {
        known.model.has_load_terms(&Case {
            tool_angle: observation.plate().tool_angle(),
            surface_slope: Angle::ZERO,
            width_ratio: WidthRatio::PLANE_STRAIN,
            friction: Angle::from_degrees(USUAL_PHI_DEG),
            interface: Angle::from_degrees(strokes.setup.delta_deg.0.min(USUAL_PHI_DEG)),
        })
    });
    if !covered {
        return Ok(Alias { consistent: None, allowed: [0.0, most_pa], left: None, phi_deg: None });
    }
    let intervals = Intervals { cohesion_range_pa: Some((0.0, most_pa)), ..Intervals::default() };
    let found = estimate(&known.setup(&Request { intervals, ..request.clone() })?)?;
    let left = found.joint.as_ref().and_then(|joint| joint.range(Quantity::Cohesion));
    Ok(alias(&found, [0.0, most_pa], left))
}
