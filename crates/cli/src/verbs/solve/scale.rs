//! From the units of a statement back to those of its file.

use soilctl_limit_analysis::results::Units;
use soilctl_limit_analysis::{Described, Description};

/// Metres and kilopascals, and where the statement's origin is: in the middle of the soil, at the height at which the lowest
/// points are the same.
#[must_use]
pub fn units(description: &Description, described: &Described) -> Units {
    let corners = || description.regions.iter().flat_map(|r| &r.polygon);
    let least = |axis: usize| corners().map(|p| p[axis]).fold(f64::INFINITY, f64::min);
    let greatest_x = corners().map(|p| p[0]).fold(f64::NEG_INFINITY, f64::max);
    let lowest = described.statement.points.iter().map(|p| p[1]).fold(f64::INFINITY, f64::min);
    Units {
        origin: [0.5 * (least(0) + greatest_x), least(1) - described.length_m * lowest],
        length: described.length_m,
        length_name: "m".to_owned(),
        stress: described.stress_kpa,
        stress_name: "kPa".to_owned(),
    }
}
