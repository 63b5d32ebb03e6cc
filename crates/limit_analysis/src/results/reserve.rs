//! What a stress field leaves of a strength that depends on stress.

use super::Point;
use super::finder::centroid;
use super::stress::StressResults;

/// Stresses below this part of the greatest are rounding.
const ROUNDING: f64 = 1e-9;
/// What the factor is lessened by, for rounding of what is computed here.
const MARGIN: f64 = 1e-9;

/// What a stress field leaves of strength, where it leaves least.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reserve {
    /// The factor by which strength may be divided.
    pub factor: f64,
    /// Mean effective stress there, compression positive, in the stress of the statement.
    pub stress: f64,
}

/// The factor by which strength of friction may be divided so that a soil still bears a stress field, where the soil's friction angle, in degrees, is
/// a function of stress that does not grow: `friction_deg` of a mean effective stress, compression positive, in the stress of the statement.
/// Only the soil at which a choice is true is looked at, without its cohesion; `None` if there is none. The factor is zero where the field is in tension.
///
/// On each part of a triangle stresses are linear, and their mean is greatest at a corner. Up to that stress the strength `sigma tan(phi(sigma))` is at
/// least that of the friction angle there, which is a cone, and so convex: if the corners obey it, the part does. Beyond its top, Mohr's circle falls
/// while strength grows.
#[must_use]
pub fn least_reserve(
    stress: &StressResults,
    is_chosen: impl Fn(Point) -> bool,
    friction_deg: impl Fn(f64) -> f64,
) -> Option<Reserve> {
    let parts = || stress.shown.parts.iter().enumerate();
    let tension = |s: &[f64; 3]| 0.5 * (s[0] + s[1]);
    let greatest = parts().flat_map(|(_, parts)| parts.iter().flatten()).map(|s| tension(s).abs());
    let rounding = ROUNDING * greatest.fold(0.0, f64::max);
    let mut least: Option<Reserve> = None;
    for (triangle, parts) in parts() {
        let corners = &stress.shown.corners[triangle];
        let middle = centroid(corners);
        if !is_chosen(middle) {
            continue;
        }
        let region = stress.saved.triangles[triangle].region;
        let pore = stress.statement.regions[region].material.pore_pressure;
        for (k, nodes) in parts.iter().enumerate() {
            let at = [corners[(k + 1) % 3], corners[(k + 2) % 3], middle];
            let circles = [0, 1, 2].map(|i| {
                let [xx, yy, xy] = nodes[i];
                (-tension(&nodes[i]) - pore.at(at[i]), (0.5 * (xx - yy)).hypot(xy))
            });
            let heaviest = circles.iter().map(|c| c.0).fold(0.0, f64::max);
            if heaviest <= rounding {
                continue;
            }
            let tan = friction_deg(heaviest).to_radians().tan();
            for (mean, radius) in circles {
                if radius <= rounding {
                    continue;
                }
                let sin = radius / mean;
                let reserve = if mean > radius { tan * (1.0 - sin * sin).max(0.0).sqrt() / sin } else { 0.0 };
                if least.is_none_or(|least| reserve < least.factor) {
                    least = Some(Reserve { factor: reserve, stress: mean });
                }
            }
        }
    }
    least.map(|least| Reserve { factor: least.factor * (1.0 - MARGIN), ..least })
}
