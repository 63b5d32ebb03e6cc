//! What a question of slopes that a wheel climbs is answered with.

use schemars::JsonSchema;
use serde::Serialize;

use super::super::{FrictionBasis, Verdict};
use crate::Outcome;

/// Bounds on one slope.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub struct Trial {
    /// The slope (deg).
    pub slope_deg: f64,
    /// Proven lower bound on how many times its load a strip like the wheel's contact bears, with every one of the soils; null if none was found.
    pub lower: Option<f64>,
    /// Proven upper bound on it, with every one of the soils; null if none was found.
    pub upper: Option<f64>,
}

impl Trial {
    pub(super) fn climbs(&self) -> bool {
        self.lower.is_some_and(|lower| lower >= 1.0)
    }

    pub(super) fn slips(&self) -> bool {
        self.upper.is_some_and(|upper| upper < 1.0)
    }
}

/// Up to which slope a wheel climbs, and from which slope on the ground under it gives way.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Answer {
    /// Whether it climbs the slope that was asked about; null if none was.
    pub answer: Option<Verdict>,
    /// Steepest of the slopes that were tried (deg) on which every one of the soils is proven to bear it; null if there is none.
    pub climbs_to_deg: Option<f64>,
    /// Least of them (deg) on which every one is proven to give way; null if there is none.
    pub gives_way_from_deg: Option<f64>,
    /// Steepest slope (deg) that is looked at: the weakest soil falls by itself beyond, or 60 deg.
    pub steepest_deg: f64,
    /// The slopes that were tried, growing.
    pub trials: Vec<Trial>,
    /// Friction angles of the soils (deg).
    pub phi_deg: [f64; 2],
    /// Where these come from.
    pub friction_basis: FrictionBasis,
    /// Their cohesion (Pa), if it is published; null where strokes say nothing of it, and there is none.
    pub cohesion_pa: Option<[f64; 2]>,
    /// Their densities (kg/m3).
    pub density_kg_m3: [f64; 2],
    /// Gravity (m/s2).
    pub gravity_m_s2: f64,
    /// Mean pressure under the wheel on level ground (Pa).
    pub pressure_pa: f64,
    /// Normal stresses (Pa) at which the soil slips under the wheel on the first slope that was tried, when it gives way; null if that was not found.
    pub slip_stress_pa: Option<[f64; 2]>,
    /// Normal stresses (Pa) at which the soil was tried by strokes and tests; null if they were not published.
    pub tried_stress_pa: Option<[f64; 2]>,
    /// The answer in words.
    pub verdict: String,
    /// What to keep in mind.
    pub warnings: Vec<String>,
    /// Time spent (s).
    pub seconds: f64,
}

impl crate::Answer for Answer {
    const SCHEMA: &'static str = "soilctl.climb/1";

    fn outcome(&self) -> Outcome {
        match self.answer {
            Some(Verdict::Stands) => Outcome::Done,
            Some(Verdict::Fails) => Outcome::Negative,
            Some(Verdict::Depends) => Outcome::Partial,
            None if self.climbs_to_deg.is_some() => Outcome::Done,
            None if self.gives_way_from_deg == Some(0.0) => Outcome::Negative,
            None => Outcome::Partial,
        }
    }
}
