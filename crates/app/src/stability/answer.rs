//! What a question of stability is answered with.

use schemars::JsonSchema;
use serde::Serialize;

use crate::Outcome;
use crate::solve::Asked;

/// Whether something stands on, or in, every soil that explains the strokes, or that was published.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// With every one of them.
    Stands,
    /// With none of them.
    Fails,
    /// With some, or the bounds are too wide to tell.
    Depends,
}

/// Where the friction angle of the problem comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum FrictionBasis {
    /// The law of stress, at the stresses of the problem.
    Law,
    /// The strokes, or published tests, whose stresses are those of the problem.
    SameStress,
    /// The same, taken to hold at other stresses because the user said so.
    Constant,
}

/// Bounds with one friction angle.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub struct Trial {
    /// Friction angle of the soil (deg).
    pub phi_deg: f64,
    /// Proven lower bound on the factor, for all densities; null if none was asked for or found.
    pub lower: Option<f64>,
    /// Proven upper bound on the factor, for all densities; null likewise.
    pub upper: Option<f64>,
}

/// A lower bound with the soils of one slice of a law of stress.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub struct SlopeAnswer {
    /// By how much their friction falls (deg a decade of stress).
    pub slope_deg_per_decade: [f64; 2],
    /// Proven lower bound on the factor; null if none was found.
    pub lower: Option<f64>,
}

/// Whether it stands, and what decides.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Answer {
    /// Title of the problem; null if it has none.
    pub title: Option<String>,
    /// Whether it stands.
    pub answer: Verdict,
    /// What is bounded.
    pub quantity: Asked,
    /// Least factor with which it is said to stand, or least force (kN/m) that the soil must bear.
    pub required: f64,
    /// Proven lower bound on the factor with every one of the soils; null if there is none.
    pub lower: Option<f64>,
    /// Proven upper bound on the factor with every one of the soils; null if there is none.
    pub upper: Option<f64>,
    /// Whether both bounds are proven for soils of the friction and the densities told here. That the soil has this friction at the stresses of the problem is
    /// what strokes or publications say, not part of the proof. With a law of stress the field behind the lower bound is proven with interval arithmetic for
    /// layers or one friction angle, and held against the law in floating point.
    pub certified: bool,
    /// The soil of the problem that was asked about.
    pub soil: String,
    /// Its friction angles (deg); with a law of stress those of the field behind the lower and of the mechanism behind the upper bound.
    pub phi_deg: [f64; 2],
    /// Where these come from.
    pub friction_basis: FrictionBasis,
    /// Its cohesion (Pa), if it is published; null where that of the problem file is kept.
    pub cohesion_pa: Option<[f64; 2]>,
    /// Its densities (kg/m3).
    pub density_kg_m3: [f64; 2],
    /// Gravity at the problem (m/s2).
    pub gravity_m_s2: f64,
    /// Normal stresses at which the soil slips in the problem (Pa), were its friction the same everywhere; null if that was not found.
    pub slip_stress_pa: Option<[f64; 2]>,
    /// Mean stress (Pa) where the field behind the lower bound leaves least of the strength; null without a law of stress.
    pub decisive_stress_pa: Option<f64>,
    /// Normal stresses at which the soil was tried by strokes and tests (Pa); null if they were not published.
    pub tried_stress_pa: Option<[f64; 2]>,
    /// Least friction angle with which it is proven to stand (deg); null if none was found.
    pub stands_from_phi_deg: Option<f64>,
    /// Greatest friction angle with which it is proven to fail (deg); null if none was found.
    pub fails_to_phi_deg: Option<f64>,
    /// The friction angles that were tried. With a law of stress a lower bound is what the field found for that angle proves of the law.
    pub trials: Vec<Trial>,
    /// Lower bounds by slices of the law of stress; empty without a law.
    pub by_slope: Vec<SlopeAnswer>,
    /// The answer in words.
    pub verdict: String,
    /// What to keep in mind.
    pub warnings: Vec<String>,
    /// Time spent (s).
    pub seconds: f64,
}

impl crate::Answer for Answer {
    const SCHEMA: &'static str = "soilctl.stability/1";

    fn outcome(&self) -> Outcome {
        match self.answer {
            Verdict::Stands => Outcome::Done,
            Verdict::Fails => Outcome::Negative,
            Verdict::Depends => Outcome::Partial,
        }
    }
}
