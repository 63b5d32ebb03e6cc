//! What `solve` answers.

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_limit_analysis::describe::Quantity;
use soilctl_limit_analysis::{Bounds, Described, Ended, Factorisation, SafetyBounds, StoppedBy};

use crate::output::Words;
use crate::text::{columns, number};
use crate::verbs::limits::{LevelAnswer, ResultsAnswer, level_table};

/// Proven bounds on what a problem file asks for.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct SolveAnswer {
    /// Title of the problem; null if it has none.
    title: Option<String>,
    /// What is bounded: force_kn_per_m, load_factor, weight_factor, acceleration_over_g or factor_of_safety.
    pub(super) quantity: &'static str,
    /// Lower bound. A force is negative where the soil pushes the structure on.
    pub(super) lower: f64,
    /// Upper bound.
    pub(super) upper: f64,
    /// `|(U - L) / ((U + L) / 2)|`; null if the bounds are on both sides of zero.
    pub(super) gap: Option<f64>,
    /// Whether both bounds are proven with interval arithmetic.
    certified: bool,
    /// Triangles of the mesh of the lower bound; each has three parts.
    lower_elements: usize,
    /// Triangles of the mesh of the upper bound.
    upper_elements: usize,
    /// What factorised the solver's systems behind the lower bound; its digits may depend on that, its proof does not.
    lower_factorisation: Factorisation,
    /// The same of the upper bound.
    upper_factorisation: Factorisation,
    /// Work spent in element steps: elements of meshes times steps of the solver on them.
    work: u64,
    /// Time spent in s.
    seconds: f64,
    /// Why the run ended.
    pub(super) ended: Ended,
    /// What kind of limit that is. Only after `seconds` and `user` the same command may end elsewhere another time.
    stopped_by: StoppedBy,
    /// All levels, coarse to fine; empty for a factor of safety.
    pub(super) levels: Vec<LevelAnswer>,
    /// For a factor of safety, all factors that were tried; else empty.
    pub(super) trials: Vec<TrialAnswer>,
    /// What the fields behind the bounds show, in the coordinates of the file. Those of a factor of safety are of soil whose
    /// strength is divided by its bounds.
    pub(super) results: ResultsAnswer,
}

/// A factor that strength was divided by, and bounds on the factor on all that acts that the soil then bears.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct TrialAnswer {
    /// The factor.
    pub(super) factor: f64,
    /// Lower bound on that; null if none is proven.
    pub(super) borne_lower: Option<f64>,
    /// Upper bound on it; null likewise.
    pub(super) borne_upper: Option<f64>,
}

/// The name of a quantity in JSON, and what it is in words.
pub(super) fn names(quantity: Quantity) -> [&'static str; 2] {
    match quantity {
        Quantity::ForceKnPerM => {
            ["force_kn_per_m", "force of the structure on the soil, along its motion (kN/m)"]
        }
        Quantity::LoadFactor => ["load_factor", "factor on the live loads"],
        Quantity::WeightFactor => ["weight_factor", "factor on the unit weights"],
        Quantity::Acceleration => ["acceleration_over_g", "horizontal acceleration over gravity"],
    }
}

pub(super) const SAFETY: [&str; 2] =
    ["factor_of_safety", "factor of safety, by which strength can be divided"];

/// The gap as a positive number, which it must be to be compared: where bounds are negative so is the plain one.
fn gap(lower: f64, upper: f64) -> Option<f64> {
    (lower * upper > 0.0).then(|| (2.0 * (upper - lower) / (upper + lower)).abs())
}

impl SolveAnswer {
    pub(super) fn new(described: &Described, bounds: &Bounds, results: ResultsAnswer) -> Self {
        let [lower, upper] = described.in_units([bounds.lower.value, bounds.upper.value]);
        let unit = match described.quantity {
            Quantity::ForceKnPerM => described.length_m * described.stress_kpa,
            _ => 1.0,
        };
        Self {
            title: described.title.clone(),
            quantity: names(described.quantity)[0],
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
        }
    }

    pub(super) fn of_safety(title: Option<&String>, safety: &SafetyBounds, results: ResultsAnswer) -> Self {
        let finite = |x: f64| x.is_finite().then_some(x);
        let trials = safety.trials.iter().map(|t| TrialAnswer {
            factor: t.factor,
            borne_lower: finite(t.lower).filter(|l| *l > 0.0),
            borne_upper: finite(t.upper),
        });
        Self {
            title: title.cloned(),
            quantity: SAFETY[0],
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
        }
    }

    /// The gap; infinite if there is none.
    pub(super) fn gap(&self) -> f64 {
        self.gap.unwrap_or(f64::INFINITY)
    }

    pub(super) fn words(&self) -> &'static str {
        use Quantity::{Acceleration, ForceKnPerM, LoadFactor, WeightFactor};
        let all = [ForceKnPerM, LoadFactor, WeightFactor, Acceleration].map(names);
        all.into_iter().chain([SAFETY]).find(|n| n[0] == self.quantity).map_or("", |n| n[1])
    }
}

impl soilctl_app::Answer for SolveAnswer {
    const SCHEMA: &'static str = "soilctl.solve/1";
}

impl Words for SolveAnswer {
    fn text(&self) -> String {
        let mut text = self.title.as_ref().map_or_else(String::new, |t| format!("{t}\n"));
        text += &format!("{}:\nlower  {}\nupper  {}\n", self.words(), number(self.lower), number(self.upper));
        if let Some(gap) = self.gap {
            text += &format!("gap    {} %\n", number(100.0 * gap));
        }
        if self.quantity == names(Quantity::ForceKnPerM)[0] && self.upper < 0.0 {
            let [least, most] = [number(-self.upper), number(-self.lower)];
            text += &format!("the soil pushes the structure on, with {least} to {most} kN/m\n");
        }
        text += &format!("both bounds are proven; {:.1} s, {}\n\n", self.seconds, self.ended);
        if self.trials.is_empty() {
            return text + &level_table(&self.levels) + "\n" + &self.results.text();
        }
        let mut rows = vec![["strength over", "times all that acts", ""].map(str::to_owned).to_vec()];
        let known = |x: Option<f64>| x.map_or_else(|| "?".to_owned(), number);
        for t in &self.trials {
            rows.push(vec![number(t.factor), known(t.borne_lower), known(t.borne_upper)]);
        }
        text + &columns(&rows) + "\n" + &self.results.text()
    }
}
