use super::Point;
use crate::{Described, Description};

/// What one unit of a statement is, for files and pictures.
#[derive(Debug, Clone, PartialEq)]
pub struct Units {
    /// Where the statement's origin is, in units of `length`'s name.
    pub origin: Point,
    /// One unit of length.
    pub length: f64,
    /// Name of the unit of length.
    pub length_name: String,
    /// One unit of stress.
    pub stress: f64,
    /// Name of the unit of stress.
    pub stress_name: String,
}

impl Units {
    /// A point of the statement.
    #[must_use]
    pub fn point(&self, p: Point) -> Point {
        [0, 1].map(|axis| self.origin[axis] + self.length * p[axis])
    }
}

/// Metres and kilopascals of a problem file, and where the statement's origin is: in the middle of the soil, at the height at
/// which the lowest points are the same.
#[must_use]
pub fn problem_units(description: &Description, described: &Described) -> Units {
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
