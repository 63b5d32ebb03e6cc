//! Strength reduction: proven bounds on the factor of safety of a description.

mod search;

use std::sync::atomic::Ordering;
use std::time::Instant;

use soilctl_certificate::{Condition, LowerField, Objective, UpperField};

use crate::bound::{Bound, Bounds, Ended, Level, Options, bound};
use crate::describe::{Described, Description};
use crate::error::LimitError;
use search::Search;
pub use search::Trial;

/// What proves one side of a factor of safety.
#[derive(Debug, Clone)]
pub struct SafetyProof<F> {
    /// The proven factor.
    pub factor: f64,
    /// The problem with strength divided by it; its objective is the factor on the weight.
    pub described: Described,
    /// The bound on that: at least one for the lower side, below one for the upper side.
    pub bound: Bound<F>,
}

/// Proven bounds on a factor of safety.
#[derive(Debug, Clone)]
pub struct SafetyBounds {
    /// Strength can be divided by this much, and the soil stands.
    pub lower: SafetyProof<LowerField>,
    /// With strength divided by this much it cannot stand.
    pub upper: SafetyProof<UpperField>,
    /// Proof that some weight not above the given one can be borne at the lower factor too; none where that is plain since
    /// neither water nor loads act. A weight of at least the given one can be, so the given one can.
    pub at_rest: Option<SafetyProof<LowerField>>,
    /// All factors that were tried.
    pub trials: Vec<Trial>,
    /// Why there are no more.
    pub ended: Ended,
    /// Time in seconds.
    pub seconds: f64,
}

impl SafetyBounds {
    /// Distance of the bounds over their mean.
    #[must_use]
    pub fn gap(&self) -> f64 {
        let (low, high) = (self.lower.factor, self.upper.factor);
        2.0 * (high - low) / (high + low)
    }
}

/// More trials than any search needs.
const MAX_TRIALS: usize = 60;

/// Part of the remaining time that one trial may take.
const SHARE: f64 = 0.4;

/// Rounding of reduced angles and cohesions, made good in the factors.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// Bounds the factor of safety: what cohesion and the tangents of all friction angles, of soils and faces, can be divided
/// by. For each factor that is tried, the factor on the weight is bounded; `progress` is told the trial's factor, each
/// level, and what gap of the factor of safety is proven.
///
/// # Errors
///
/// [`LimitError`] as from [`bound`], or if no pair of bounds is proven within the budget.
pub fn factor_of_safety(
    description: &Description,
    options: &Options,
    progress: &mut dyn FnMut(f64, &Level, Option<f64>),
) -> Result<SafetyBounds, LimitError> {
    let start = Instant::now();
    let mut run = Run {
        description,
        options,
        start,
        search: Search::new(options.max_gap),
        found: Found::default(),
        limit: Ended::Elements,
    };
    let ended = loop {
        if run.search.is_done() {
            break Ended::Gap;
        }
        if options.stop.load(Ordering::Relaxed) {
            break Ended::Stopped;
        }
        if run.remaining() <= 0.0 {
            break Ended::Time;
        }
        if run.search.trials.len() == MAX_TRIALS {
            break Ended::Elements;
        }
        let Some(factor) = run.search.next() else { break run.limit };
        if let Some(ended) = run.trial(factor, progress)? {
            break ended;
        }
    };
    let (trials, seconds) = (run.search.trials, start.elapsed().as_secs_f64());
    match (run.found.lower, run.found.upper) {
        (Some((lower, at_rest)), Some(upper)) => {
            Ok(SafetyBounds { lower, upper, at_rest, trials, ended, seconds })
        }
        _ => Err(LimitError::NothingProven { spent: format!("{} factors, {seconds:.1} s", trials.len()) }),
    }
}

#[derive(Default)]
struct Found {
    lower: Option<(SafetyProof<LowerField>, Option<SafetyProof<LowerField>>)>,
    upper: Option<SafetyProof<UpperField>>,
}

struct Run<'a> {
    description: &'a Description,
    options: &'a Options,
    start: Instant,
    search: Search,
    found: Found,
    /// What keeps trials from getting sharper, once something does.
    limit: Ended,
}

impl Run<'_> {
    fn remaining(&self) -> f64 {
        self.options.max_seconds - self.start.elapsed().as_secs_f64()
    }

    /// One factor. Returns why to stop, if so.
    fn trial(
        &mut self,
        factor: f64,
        progress: &mut dyn FnMut(f64, &Level, Option<f64>),
    ) -> Result<Option<Ended>, LimitError> {
        let described = self.description.reduced(factor).described()?;
        let proven = self.search.gap();
        let options = Options {
            max_gap: self.search.trial_gap,
            max_seconds: SHARE * self.remaining(),
            ..self.options.clone()
        };
        let solved = bound(&described.problem()?, &options, &mut |level, _| progress(factor, level, proven));
        let bounds = match solved {
            Ok(bounds) => bounds,
            // Any weight is borne: too strong to tell, and no proof either.
            Err(LimitError::NoCollapse { .. }) if factor < 1e3 => {
                self.search.add(Trial { factor, lower: f64::INFINITY, upper: f64::INFINITY }, false);
                return Ok(None);
            }
            // What is proven already counts.
            Err(LimitError::NothingProven { .. })
                if self.found.lower.is_some() && self.found.upper.is_some() =>
            {
                return Ok(Some(Ended::Time));
            }
            Err(error) => return Err(error),
        };
        let trial = Trial { factor, lower: bounds.lower.value, upper: bounds.upper.value };
        let ended = bounds.ended;
        let unsharp = bounds.gap().abs() > self.search.trial_gap;
        let stands = trial.lower >= 1.0 && self.keep_lower(factor, &described, &bounds, &options)?;
        if trial.upper < 1.0 && self.found.upper.as_ref().is_none_or(|u| factor < u.factor) {
            let factor = factor * (1.0 + ROUNDING);
            self.found.upper = Some(SafetyProof { factor, described, bound: bounds.upper });
        }
        self.search.add(trial, stands);
        if unsharp && matches!(ended, Ended::Elements | Ended::Memory) {
            // What is as fine as is allowed and still not sharp will not be so the next time either. But there may be
            // something to gain from its two bounds.
            self.search.is_finest = true;
            self.limit = ended;
            return Ok(None);
        }
        let both = self.found.lower.is_some() && self.found.upper.is_some();
        Ok((unsharp && both && !self.search.is_done()).then_some(ended))
    }

    /// Takes over a proof that the soil stands, if it is complete.
    fn keep_lower(
        &mut self,
        factor: f64,
        described: &Described,
        bounds: &Bounds,
        options: &Options,
    ) -> Result<bool, LimitError> {
        let exact = factor * (1.0 - ROUNDING);
        let proof = |described: Described, bound| SafetyProof { factor: exact, described, bound };
        let at_rest = if rests(described) {
            None
        } else {
            match at_rest(described, options)? {
                Some((problem, bound)) => Some(proof(problem, bound)),
                None => return Ok(false),
            }
        };
        if self.found.lower.as_ref().is_none_or(|(l, _)| exact > l.factor) {
            self.found.lower = Some((proof(described.clone(), bounds.lower.clone()), at_rest));
        }
        Ok(true)
    }
}

/// Whether the soil plainly bears no weight at all: then the surcharge, as a pressure all over, balances with no shear.
fn rests(described: &Described) -> bool {
    let s = &described.statement;
    let dry = s.regions.iter().all(|r| r.material.pore_pressure.is_zero());
    dry && !s.boundaries.iter().any(|b| matches!(b.condition, Condition::Loaded { .. }))
}

/// Proof that some weight not above the given one is borne. Weights that are form an interval, so with one that is not
/// below it the given one is borne.
fn at_rest(
    described: &Described,
    options: &Options,
) -> Result<Option<(Described, Bound<LowerField>)>, LimitError> {
    let mut lighter = described.clone();
    let Objective::Body { gravity } = lighter.statement.objective else { return Ok(None) };
    lighter.statement.gravity = gravity;
    lighter.statement.objective = Objective::Body { gravity: gravity.map(|g| -g) };
    // Any pair of bounds will do, the first one too.
    let options = Options { max_gap: f64::MAX, ..options.clone() };
    match bound(&lighter.problem()?, &options, &mut |_, _| {}) {
        Ok(bounds) if bounds.lower.value >= 0.0 => Ok(Some((lighter, bounds.lower))),
        Ok(_) | Err(LimitError::NoCollapse { .. } | LimitError::NothingProven { .. }) => Ok(None),
        Err(error) => Err(error),
    }
}
