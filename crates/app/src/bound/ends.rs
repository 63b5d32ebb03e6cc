//! Bounds of a plate that has ends.

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_certificate::{CertificateError, Claim, Mechanism, Solution, Statement, prove_mechanism};
use soilctl_earth_pressure::Blocks;
use soilctl_limit_analysis::{Bounds, Problem};
use soilctl_soil::Angle;

use super::ScaledPlate;
use crate::{AppError, Watch};

/// By how much more than the friction the blocks slide, in radians; more if the proof fails.
const MARGINS: [f64; 4] = [1e-8, 1e-7, 1e-6, 1e-5];

/// Widths over depth for which the bracket is told besides the one asked for.
const RATIOS: [f64; 10] = [0.5, 1.0, 2.0, 3.0, 5.0, 7.0, 10.0, 20.0, 50.0, 100.0];

/// How a bound is proven.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ProofKind {
    /// By a field in plane strain, for plane strain
    Plane,
    /// By a stress field in plane strain that is spliced with the ground at rest, for every width
    Splice,
    /// By rigid blocks in space
    Mechanism,
}

impl ProofKind {
    /// The kind in words.
    #[must_use]
    pub fn words(self) -> &'static str {
        match self {
            Self::Plane => "a field in plane strain",
            Self::Splice => "a plane stress field spliced with the ground at rest beyond the ends",
            Self::Mechanism => "rigid blocks in space",
        }
    }
}

/// The bracket of one width. Bounds are on the net coefficient per slant length and width.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct WidthAnswer {
    /// Width over vertical depth; null in plane strain.
    pub width_ratio: Option<f64>,
    /// Lower bound.
    pub lower: f64,
    /// Upper bound.
    pub upper: f64,
    /// `(U - L) / ((U + L) / 2)`.
    pub gap: f64,
    /// How the lower bound is proven.
    pub lower_proof: ProofKind,
    /// How the upper bound is proven.
    pub upper_proof: ProofKind,
}

impl WidthAnswer {
    fn new(width_ratio: Option<f64>, [lower, upper]: [f64; 2], upper_proof: ProofKind) -> Self {
        let gap = 2.0 * (upper - lower) / (upper + lower);
        let lower_proof = if width_ratio.is_some() { ProofKind::Splice } else { ProofKind::Plane };
        Self { width_ratio, lower, upper, gap, lower_proof, upper_proof }
    }

    /// That of plane strain.
    pub(super) fn plane(scaled: &ScaledPlate, bounds: &Bounds) -> Self {
        Self { gap: bounds.gap(), ..Self::new(None, scaled.coefficients(bounds), ProofKind::Plane) }
    }
}

/// What is proven of a plate with ends.
#[derive(Debug)]
pub(super) struct WithEnds {
    /// For the width asked for.
    pub(super) bracket: WidthAnswer,
    /// In plane strain.
    pub(super) plane: WidthAnswer,
    /// For other widths, narrow to wide, and plane strain last.
    pub(super) over_width: Vec<WidthAnswer>,
    statement: Statement,
    mechanism: Claim<Mechanism>,
}

impl WithEnds {
    /// Adds mechanisms in space to the bounds of a section.
    pub(super) fn new(
        scaled: &ScaledPlate,
        problem: &Problem,
        bounds: &Bounds,
        width_ratio: f64,
        watch: &dyn Watch,
    ) -> Result<Self, AppError> {
        let plane = WidthAnswer::plane(scaled, bounds);
        let bracket = |ratio: f64, force: f64| {
            let [lower, upper] = scaled.of_forces([bounds.lower.value, force]);
            WidthAnswer::new(Some(ratio), [lower, upper], ProofKind::Mechanism)
        };
        watch.begin(1 + RATIOS.len() as u64, "mechanisms in space");
        let statement = problem.statement().clone();
        let mechanism = proven(scaled, &statement)?;
        let mut over_width = Vec::new();
        for ratio in RATIOS {
            watch.advance(1);
            let width = scaled.slant_width(ratio);
            let force = proven(scaled, &Statement { width: Some(width), ..statement.clone() })?.claimed;
            over_width.push(bracket(ratio, force));
        }
        watch.end();
        over_width.push(plane);
        Ok(Self { bracket: bracket(width_ratio, mechanism.claimed), plane, over_width, statement, mechanism })
    }

    /// The solution for a file: without the flow in the plane, which proves nothing here.
    pub(super) fn solution(&self, scaled: &ScaledPlate, problem: &Problem, bounds: &Bounds) -> Solution {
        let plane = scaled.solution(problem, bounds);
        Solution {
            statement: self.statement.clone(),
            upper: None,
            mechanism: Some(self.mechanism.clone()),
            ..plane
        }
    }
}

/// A mechanism for the width of a statement, with the force that it proves per width.
fn proven(scaled: &ScaledPlate, statement: &Statement) -> Result<Claim<Mechanism>, AppError> {
    let (case, loads) = scaled.case();
    let width = statement.width.unwrap_or(f64::INFINITY);
    let mut refusal: Option<CertificateError> = None;
    for margin in MARGINS {
        let field = Blocks.mechanism(&case, width, loads, Angle::from_radians(margin))?;
        match prove_mechanism(statement, &field) {
            Ok(claimed) => return Ok(Claim { field, claimed, computed: None }),
            Err(why) => refusal = Some(why),
        }
    }
    let why = refusal.map_or_else(String::new, |why| why.to_string());
    Err(AppError::Request(format!(
        "no mechanism in space is proven for this plate ({why}); --ends none gives plane strain"
    )))
}
