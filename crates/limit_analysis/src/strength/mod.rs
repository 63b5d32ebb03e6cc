//! Strength reduction: proven bounds on the factor of safety of a description.

mod guess;
mod search;

use soilctl_certificate::{LowerField, UpperField, prove_lower};

use crate::bound::{Bound, Clock, Ended, Level, Options, Seed, Sides, continued, is_decided};
use crate::describe::{Described, Description, PoreField};
use crate::error::{LimitError, OneSide};
use guess::guess;
use search::Search;
pub use search::Trial;

/// What proves one side of a factor of safety.
#[derive(Debug, Clone)]
pub struct SafetyProof<F> {
    /// The proven factor.
    pub factor: f64,
    /// The problem with strength divided by it; its objective is the factor on everything that acts.
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
    /// All factors that were tried.
    pub trials: Vec<Trial>,
    /// Why there are no more.
    pub ended: Ended,
    /// Element steps spent: see [`Options::max_work`].
    pub work: u64,
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

/// So many trials that prove nothing are given up.
const MAX_BLIND: usize = 6;

/// Parts of the work and time left that one trial may take: the first, a later one at least, and at most if the last one that was
/// left open took so much; it takes more than that one to be decided.
const FIRST_SHARE: f64 = 0.2;
const SHARE: f64 = 0.25;
const MOST_SHARE: f64 = 0.5;
const LONGER: f64 = 1.5;

/// With less than this part of all time or work left, a trial that is not sharp enough is the last one.
const LEAST_LEFT: f64 = 0.15;

/// A trial that proves less than one, but this much, proves that the soil stands with a little more strength.
const SHIFTED: f64 = 0.8;

/// What rounding may take from a shifted proof.
const SHIFT: f64 = 1e-9;

/// Rounding of reduced angles and cohesions, made good in the factors.
pub(crate) const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// Bounds the factor of safety: what cohesion and the tangents of all friction angles, of soils and faces, can be divided
/// by. For each factor that is tried, the factor on everything that acts (weight, water, loads) is bounded: it is one where the soil
/// is at its limit, and bounded well even where the soil is far from that. `progress` is told the trial's factor, each
/// level, and what gap of the factor of safety is proven.
///
/// # Errors
///
/// [`LimitError`] as from [`bound`](crate::bound()), or if no pair of bounds is proven within the budget.
pub fn factor_of_safety(
    description: &Description,
    options: &Options,
    progress: &mut dyn FnMut(f64, &Level, Option<f64>),
) -> Result<SafetyBounds, LimitError> {
    let pores = description.pore_field()?;
    let first = description.reduced(1.0).described_under(pores.as_ref())?;
    let mut run = Run {
        description,
        options,
        clock: Clock::start(options.max_seconds),
        spent: 0,
        is_cut: false,
        search: Search::new(options.max_gap, guess(&first.problem()?)),
        pores,
        found: Found::default(),
        limit: Ended::Elements,
        open: None,
        seed: None,
    };
    let ended = loop {
        if run.search.is_done() {
            break Ended::Gap;
        }
        if options.is_stopped() {
            break Ended::Stopped;
        }
        if !run.clock.allows(0.0) {
            break Ended::Time;
        }
        if run.remaining() == 0 || run.search.trials.len() == MAX_TRIALS {
            break Ended::Work;
        }
        let Some(factor) = run.search.next() else { break run.limit };
        if let Some(ended) = run.trial(factor, progress)? {
            break ended;
        }
    };
    let ended = if run.is_cut && ended != Ended::Stopped { Ended::Time } else { ended };
    let nothing = run.nothing();
    let (Some(lower), Some(upper)) = (run.found.lower.take(), run.found.upper.take()) else {
        return Err(nothing);
    };
    let (work, seconds) = (run.spent, run.clock.elapsed());
    Ok(SafetyBounds { lower, upper, trials: run.search.trials, ended, work, seconds })
}

#[derive(Default)]
struct Found {
    lower: Option<SafetyProof<LowerField>>,
    upper: Option<SafetyProof<UpperField>>,
}

struct Run<'a> {
    description: &'a Description,
    options: &'a Options,
    clock: Clock,
    /// Element steps of all trials.
    spent: u64,
    /// Whether the clock ended any trial.
    is_cut: bool,
    search: Search,
    /// Ground water that flows, the same whatever the strength.
    pores: Option<PoreField>,
    found: Found,
    /// What kept the last trial that was left open from getting sharper.
    limit: Ended,
    /// What it took, in element steps and seconds.
    open: Option<[f64; 2]>,
    /// Where trials begin: as finely as those before them have shown to be needed.
    seed: Option<Seed>,
}

/// What a trial may take of what is left.
fn share(left: f64, last_open: Option<f64>) -> f64 {
    last_open.map_or(FIRST_SHARE * left, |last| (LONGER * last).clamp(SHARE * left, MOST_SHARE * left))
}

impl Run<'_> {
    /// Element steps left.
    fn remaining(&self) -> u64 {
        self.options.max_work.saturating_sub(self.spent)
    }

    fn nothing(&self) -> LimitError {
        let without_tension = self.description.soils.iter().any(|soil| soil.tension_kpa == Some(0.0));
        let spent = format!("{} factors, {} element steps", self.search.trials.len(), self.spent);
        let lower = self.found.lower.as_ref().map(|proof| OneSide::Lower(proof.factor));
        let side = lower.or(self.found.upper.as_ref().map(|proof| OneSide::Upper(proof.factor)));
        LimitError::nothing_proven(without_tension, spent).with_proven(side)
    }

    /// One factor. Returns why to stop, if so.
    fn trial(
        &mut self,
        factor: f64,
        progress: &mut dyn FnMut(f64, &Level, Option<f64>),
    ) -> Result<Option<Ended>, LimitError> {
        let described = self.description.reduced(factor).described_under(self.pores.as_ref())?;
        let options = Options {
            max_gap: self.search.trial_gap,
            max_work: share(self.remaining() as f64, self.open.map(|[work, _]| work)) as u64,
            max_seconds: self.clock.left().map(|left| share(left, self.open.map(|[_, seconds]| seconds))),
            ..self.options.clone()
        };
        let problem = described.problem()?;
        // Far from the limit coarse meshes decide. How a wall fails changes with the strength: a mesh refined for one way is coarse
        // where the next one needs it.
        let seed = self.seed.clone().filter(|_| self.search.is_near() && !problem.has_beams());
        let solved = continued(&problem, &options, seed, &is_decided, &mut |level, _| {
            let lower = level.lower.and_then(|solve| solve.proven);
            progress(factor, level, self.search.gap_with(factor, lower, level.upper.proven));
        });
        let (Sides { lower, upper, ended, work, seconds, .. }, seed) = solved?;
        self.spent += work;
        self.is_cut |= ended == Ended::Time;
        let both = self.found.lower.is_some() && self.found.upper.is_some();
        if lower.is_none() && upper.is_none() && !both && self.search.trials.len() >= MAX_BLIND {
            return Err(self.nothing());
        }
        let trial = Trial {
            factor,
            lower: lower.as_ref().map_or(0.0, |b| b.value),
            upper: upper.as_ref().map_or(f64::INFINITY, |b| b.value),
        };
        let unsharp = trial.gap() > self.search.trial_gap && trial.is_open();
        if let Some(bound) = lower {
            if bound.value >= 1.0 {
                self.keep_lower(factor, &described, bound);
            } else if bound.value >= SHIFTED
                && let Some(proof) = self.shifted(factor, &described, bound)
            {
                self.search.stands_at(proof.factor);
                self.found.lower = Some(proof);
            }
        }
        if let Some(bound) = upper.filter(|u| u.value < 1.0)
            && self.found.upper.as_ref().is_none_or(|u| factor < u.factor)
        {
            let factor = factor * (1.0 + ROUNDING);
            self.found.upper = Some(SafetyProof { factor, described, bound });
        }
        self.search.add(trial);
        if trial.is_open() {
            self.open = Some([work as f64, seconds]);
        }
        // One that is far from the limit is decided on a coarse mesh, and shows little of it.
        if let Some(seed) = seed.filter(|seed| {
            trial.is_open() || self.seed.as_ref().is_none_or(|old| old.elements() < seed.elements())
        }) {
            self.seed = Some(seed);
        }
        if unsharp {
            self.limit = ended;
        }
        if unsharp && matches!(ended, Ended::Elements | Ended::Memory) {
            // What is as fine as is allowed and still not sharp will not be so the next time either. But there may be
            // something to gain from its two bounds.
            self.search.is_finest = true;
            return Ok(None);
        }
        let little_time = self
            .clock
            .left()
            .zip(self.options.max_seconds)
            .is_some_and(|(left, all)| left < LEAST_LEFT * all);
        let little_work = (self.remaining() as f64) < LEAST_LEFT * self.options.max_work as f64;
        let is_over = unsharp && both && (little_time || little_work) && !self.search.is_done();
        Ok(is_over.then_some(ended))
    }

    /// What a trial that proves `l` of all that acts, less than one, proves of the factor `l F`. Its stresses bear all that acts with the
    /// `F`-th part of the tangents of friction angles and the `lF`-th part of cohesions, and there is more than that of the first. Members are as
    /// strong as before, so stresses may ask too much of them: the checker says.
    fn shifted(
        &self,
        factor: f64,
        described: &Described,
        mut bound: Bound<LowerField>,
    ) -> Option<SafetyProof<LowerField>> {
        let factor = factor * bound.value * (1.0 - SHIFT);
        if self.found.lower.as_ref().is_some_and(|l| l.factor >= factor) {
            return None;
        }
        let stronger = self.description.reduced(factor).described_under(self.pores.as_ref()).ok()?;
        if stronger.stress_kpa != described.stress_kpa {
            return None;
        }
        bound.field.multiplier = 1.0;
        bound.value = prove_lower(&stronger.statement, &bound.field).ok().filter(|value| *value >= 1.0)?;
        Some(SafetyProof { factor: factor * (1.0 - ROUNDING), described: stronger, bound })
    }

    /// Takes over a proof that the soil stands.
    fn keep_lower(&mut self, factor: f64, described: &Described, bound: Bound<LowerField>) {
        let factor = factor * (1.0 - ROUNDING);
        if self.found.lower.as_ref().is_none_or(|l| factor > l.factor) {
            self.found.lower = Some(SafetyProof { factor, described: described.clone(), bound });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_trial_after_an_open_one_may_take_longer_than_that() {
        assert_eq!(share(100.0, None), 20.0);
        assert_eq!(share(80.0, Some(20.0)), 30.0);
        // No less than any trial may, and something is left for others.
        assert_eq!(share(100.0, Some(1.0)), 25.0);
        assert_eq!(share(40.0, Some(30.0)), 20.0);
    }
}
