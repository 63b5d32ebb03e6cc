//! What is answered of safe forces.

use schemars::JsonSchema;
use serde::Serialize;

use super::polygon::{hull, within};

/// What the motion in one direction says of the forces of the tool on the soil.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct DirectionAnswer {
    /// Direction, from the level ahead, above 0 upwards (deg).
    pub direction_deg: f64,
    /// Lower bound on the greatest part along it of a force that is borne (N/m); null if none is proven.
    pub lower_n_per_m: Option<f64>,
    /// Upper bound on it: all forces with more fail (N/m); null if none is proven.
    pub upper_n_per_m: Option<f64>,
    /// A force that is borne, level ahead and upwards (N/m): that of the stresses behind the lower bound; null without them.
    pub force_n_per_m: Option<[f64; 2]>,
    /// Why a bound is missing; null if none is.
    pub problem: Option<String>,
}

/// Forces that the soil bears on a tool that does not turn, per metre of width.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct ForcesAnswer {
    /// Each direction, from the level ahead upwards and round.
    pub directions: Vec<DirectionAnswer>,
    /// Corners of forces that are all borne, level ahead and upwards (N/m), against the clock: the hull of those of the directions.
    pub safe_n_per_m: Vec<[f64; 2]>,
    /// Corners of a polygon beyond which all forces fail, likewise; null where the bounds do not close it.
    pub limit_n_per_m: Option<Vec<[f64; 2]>>,
}

impl ForcesAnswer {
    pub(super) fn new(directions: Vec<DirectionAnswer>) -> Self {
        let safe: Vec<[f64; 2]> = directions.iter().filter_map(|one| one.force_n_per_m).collect();
        let line = |one: &DirectionAnswer| {
            let (sin, cos) = one.direction_deg.to_radians().sin_cos();
            Some(([cos, sin], one.upper_n_per_m?))
        };
        let lines: Vec<_> = directions.iter().filter_map(line).collect();
        Self { safe_n_per_m: hull(&safe), limit_n_per_m: within(&lines), directions }
    }
}
