//! Bounds of a plate that has ends.

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_certificate::{Claim, Mechanism, Solution};
use soilctl_earth_pressure::Blocks;
use soilctl_limit_analysis::{Bounds, Problem};

use super::ScaledPlate;
use super::end::EndField;
use crate::request::Ends;
use crate::{AppError, Watch};

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
    /// By a stress field in space about the plate's ends, and one in plane strain between
    Space,
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
            Self::Space => "a stress field in space about the ends",
            Self::Mechanism => "rigid blocks in space",
        }
    }
}

/// Width over vertical depth of a plate that has ends; none in plane strain. A plate with a width has ends unless it is said
/// otherwise.
///
/// # Errors
/// What is missing or said twice.
pub fn ratio_of_ends(
    wish: Option<Ends>,
    width_ratio: Option<f64>,
    width_m: Option<f64>,
    depth_m: Option<f64>,
) -> Result<Option<f64>, AppError> {
    let given = match (width_ratio, width_m, depth_m) {
        (Some(_), Some(_), _) => {
            let both = "width and width ratio both say how wide the plate is; leave one out";
            return Err(AppError::Request(both.into()));
        }
        (Some(ratio), None, _) => Some(ratio),
        (None, Some(width), Some(depth)) => Some(width / depth),
        (None, None, _) | (None, _, None) => None,
    };
    match (wish, given) {
        (Some(Ends::None), _) => Ok(None),
        (None, None) if width_m.is_none() => Ok(None),
        (Some(Ends::Finite) | None, Some(ratio)) => Ok(Some(ratio)),
        (Some(Ends::Finite) | None, None) => Err(AppError::Request(
            "where a plate has ends its force depends on its width over its depth; give both, or the width ratio, or ask for \
             plane strain with ends none"
                .into(),
        )),
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
    fn new(width_ratio: Option<f64>, [lower, upper]: [f64; 2], proofs: [ProofKind; 2]) -> Self {
        let gap = 2.0 * (upper - lower) / (upper + lower);
        let [lower_proof, upper_proof] = proofs;
        Self { width_ratio, lower, upper, gap, lower_proof, upper_proof }
    }

    /// That of plane strain.
    pub(super) fn plane(scaled: &ScaledPlate, bounds: &Bounds) -> Self {
        Self { gap: bounds.gap(), ..Self::new(None, scaled.coefficients(bounds), [ProofKind::Plane; 2]) }
    }
}

/// Mechanisms in space for a plate's width and for others.
#[derive(Debug)]
pub(super) struct Mechanisms {
    width_ratio: f64,
    own: Claim<Mechanism>,
    /// Forces per width for [`RATIOS`].
    others: Vec<f64>,
}

impl Mechanisms {
    /// Finds and proves them, for a problem that has the width.
    pub(super) fn new(
        scaled: &ScaledPlate,
        problem: &Problem,
        width_ratio: f64,
        watch: &dyn Watch,
    ) -> Result<Self, AppError> {
        let (case, loads) = scaled.case();
        watch.begin(RATIOS.len() as u64, "mechanisms in space");
        let own = Blocks.proven(&case, problem.statement(), loads)?;
        let mut others = Vec::new();
        for ratio in RATIOS {
            let statement = problem.statement().clone().with_width(scaled.slant_width(ratio));
            others.push(Blocks.proven(&case, &statement, loads)?.claimed);
            watch.advance(1);
        }
        watch.end();
        Ok(Self { width_ratio, own, others })
    }

    /// The brackets that follow from a lower bound for every width, and from a field about the ends, if there is one.
    pub(super) fn brackets(&self, scaled: &ScaledPlate, bounds: &Bounds, end: Option<&EndField>) -> Brackets {
        let bracket = |ratio: f64, upper: f64| {
            let about_end = end.and_then(|end| end.force.per_width(scaled.slant_width(ratio)));
            let (lower, proof) = match about_end {
                Some(force) if force > bounds.lower.value => (force, ProofKind::Space),
                _ => (bounds.lower.value, ProofKind::Splice),
            };
            let sides = scaled.of_forces([lower, upper]);
            WidthAnswer::new(Some(ratio), sides, [proof, ProofKind::Mechanism])
        };
        let plane = WidthAnswer::plane(scaled, bounds);
        let others = RATIOS.into_iter().zip(&self.others).map(|(ratio, force)| bracket(ratio, *force));
        Brackets {
            own: bracket(self.width_ratio, self.own.claimed),
            plane,
            over_width: others.chain([plane]).collect(),
        }
    }

    /// The blocks for the plate's own width.
    pub(super) fn own(&self) -> &Mechanism {
        &self.own.field
    }

    /// The solution for a file: without the flow in the plane, which proves nothing here.
    pub(super) fn solution(&self, plane: Solution, end: Option<&EndField>) -> Solution {
        let space = end.map(|end| end.claim.clone());
        Solution { upper: None, mechanism: Some(self.own.clone()), space, ..plane }
    }
}

/// What is proven of a plate with ends, or without.
#[derive(Debug)]
pub(super) struct Brackets {
    /// For the width asked for; plane strain if it has no ends.
    pub(super) own: WidthAnswer,
    pub(super) plane: WidthAnswer,
    /// For other widths, narrow to wide, and plane strain last; none if it has no ends.
    pub(super) over_width: Vec<WidthAnswer>,
}

impl Brackets {
    /// Of a plate without ends.
    pub(super) fn plane(scaled: &ScaledPlate, bounds: &Bounds) -> Self {
        let plane = WidthAnswer::plane(scaled, bounds);
        Self { own: plane, plane, over_width: Vec::new() }
    }
}
