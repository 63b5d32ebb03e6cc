//! What `solve` answers.

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_limit_analysis::describe::Quantity;
use soilctl_limit_analysis::{Bounds, Described, Ended, Factorisation, SafetyBounds, StoppedBy};

use super::{Asked, CaseAnswer, SeepageAnswer};
use crate::Outcome;
use crate::limits::{LevelAnswer, ResultsAnswer};

/// Proven bounds on what a problem file asks for.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Answer {
    /// Title of the problem; null if it has none.
    pub title: Option<String>,
    /// What is bounded.
    pub quantity: Asked,
    /// The case of the file with the least lower bound, whose fields and levels these are; null if the file has no cases.
    pub governing: Option<String>,
    /// All cases of the file; empty if it has none.
    pub cases: Vec<CaseAnswer>,
    /// Lower bound, of cases the least. A force is negative where the soil pushes the structure on.
    pub lower: f64,
    /// Upper bound, likewise.
    pub upper: f64,
    /// `|(U - L) / ((U + L) / 2)|`; null if the bounds are on both sides of zero.
    pub gap: Option<f64>,
    /// Whether both bounds are proven with interval arithmetic, of cases those of all.
    pub certified: bool,
    /// Triangles of the mesh of the lower bound; each has three parts.
    pub lower_elements: usize,
    /// Triangles of the mesh of the upper bound.
    pub upper_elements: usize,
    /// What factorised the solver's systems behind the lower bound; its digits may depend on that, its proof does not.
    pub lower_factorisation: Factorisation,
    /// The same of the upper bound.
    pub upper_factorisation: Factorisation,
    /// Work spent in element steps: elements of meshes times steps of the solver on them.
    pub work: u64,
    /// Time spent in s.
    pub seconds: f64,
    /// Why the run ended.
    pub ended: Ended,
    /// What kind of limit that is. Only after `seconds` and `user` the same command may end elsewhere another time.
    pub stopped_by: StoppedBy,
    /// All levels, coarse to fine; empty for a factor of safety.
    pub levels: Vec<LevelAnswer>,
    /// For a factor of safety, all factors that were tried; else empty.
    pub trials: Vec<TrialAnswer>,
    /// What the fields behind the bounds show, in the coordinates of the file. Those of a factor of safety are of soil whose
    /// strength is divided by its bounds.
    pub results: ResultsAnswer,
    /// How ground water flows between given heads, of cases in the governing one; null if it does not.
    pub seepage: Option<SeepageAnswer>,
    /// Values of the file that are possible but unusual, with what is usual and a likely cause.
    pub notes: Vec<String>,
    /// The gap asked for.
    #[serde(skip)]
    pub max_gap: f64,
}

/// A factor that strength was divided by, and bounds on the factor on all that acts that the soil then bears.
#[derive(Debug, Serialize, JsonSchema)]
pub struct TrialAnswer {
    /// The factor.
    pub factor: f64,
    /// Lower bound on that; null if none is proven.
    pub borne_lower: Option<f64>,
    /// Upper bound on it; null likewise.
    pub borne_upper: Option<f64>,
}

/// The gap as a positive number, which it must be to be compared: where bounds are negative so is the plain one.
pub(super) fn gap(lower: f64, upper: f64) -> Option<f64> {
    (lower * upper > 0.0).then(|| (2.0 * (upper - lower) / (upper + lower)).abs())
}

impl Answer {
    pub(super) fn new(described: &Described, bounds: &Bounds, results: ResultsAnswer, max_gap: f64) -> Self {
        let [lower, upper] = described.in_units([bounds.lower.value, bounds.upper.value]);
        let unit = match described.quantity {
            Quantity::ForceKnPerM => described.length_m * described.stress_kpa,
            _ => 1.0,
        };
        Self {
            title: described.title.clone(),
            quantity: described.quantity.into(),
            governing: None,
            cases: Vec::new(),
            lower,
            upper,
            gap: gap(lower, upper),
            certified: true,
            lower_elements: bounds.lower.elements,
            upper_elements: bounds.upper.elements,
            lower_factorisation: bounds.lower.factorisation,
            upper_factorisation: bounds.upper.factorisation,
            work: bounds.work,
            seconds: bounds.seconds,
            ended: bounds.ended,
            stopped_by: bounds.ended.stopped_by(),
            levels: bounds.levels.iter().map(|level| LevelAnswer::new(level, unit)).collect(),
            trials: Vec::new(),
            results,
            seepage: None,
            notes: Vec::new(),
            max_gap,
        }
    }

    pub(super) fn of_safety(
        title: Option<&String>,
        safety: &SafetyBounds,
        results: ResultsAnswer,
        max_gap: f64,
    ) -> Self {
        let finite = |x: f64| x.is_finite().then_some(x);
        let trials = safety.trials.iter().map(|t| TrialAnswer {
            factor: t.factor,
            borne_lower: finite(t.lower).filter(|l| *l > 0.0),
            borne_upper: finite(t.upper),
        });
        Self {
            title: title.cloned(),
            quantity: Asked::FactorOfSafety,
            governing: None,
            cases: Vec::new(),
            lower: safety.lower.factor,
            upper: safety.upper.factor,
            gap: Some(safety.gap()),
            certified: true,
            lower_elements: safety.lower.bound.elements,
            upper_elements: safety.upper.bound.elements,
            lower_factorisation: safety.lower.bound.factorisation,
            upper_factorisation: safety.upper.bound.factorisation,
            work: safety.work,
            seconds: safety.seconds,
            ended: safety.ended,
            stopped_by: safety.ended.stopped_by(),
            levels: Vec::new(),
            trials: trials.collect(),
            results,
            seepage: None,
            notes: Vec::new(),
            max_gap,
        }
    }
}

impl crate::Answer for Answer {
    const SCHEMA: &'static str = "soilctl.solve/1";

    fn outcome(&self) -> Outcome {
        let is_close = |gap: Option<f64>| gap.is_some_and(|gap| gap <= self.max_gap);
        let is_done = match &self.cases[..] {
            [] => is_close(self.gap),
            cases => cases.iter().all(|case| is_close(case.gap)),
        };
        if is_done { Outcome::Done } else { Outcome::Partial }
    }
}
