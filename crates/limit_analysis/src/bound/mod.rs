//! Both bounds of a problem on a sequence of meshes, each made from what the last one showed.

mod both;
mod clock;
mod ended;
mod memory;
mod meshes;
mod options;
mod rest;
mod run;
mod solves;

use soilctl_certificate::{Claim, Computed, LowerField, UpperField};
use soilctl_conic::{Factorisation, SOLVER, Status};

use crate::error::{LimitError, OneSide};
use crate::problem::Problem;
pub(crate) use clock::Clock;
pub use ended::{Ended, StoppedBy};
pub use options::Options;
pub use rest::{WORK_TO_FALL, falls, seems_to_fall};
use run::Run;
pub(crate) use run::Seed;

/// A proven bound.
#[derive(Debug, Clone)]
pub struct Bound<F> {
    /// The bound, as the certificate proves it: power of the structure's force at its velocity.
    pub value: f64,
    /// Triangles of its mesh.
    pub elements: usize,
    /// What proves it.
    pub field: F,
    /// What factorised the systems of the solve that found it.
    pub factorisation: Factorisation,
}

impl<F: Clone> Bound<F> {
    /// The bound as saved solutions have it.
    #[must_use]
    pub fn claim(&self) -> Claim<F> {
        let factorisation = self.factorisation.name().to_owned();
        let computed = Computed { solver: SOLVER.to_owned(), factorisation };
        Claim { field: self.field.clone(), claimed: self.value, computed: Some(computed) }
    }
}

/// One solve of a level.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solve {
    /// Triangles.
    pub elements: usize,
    /// Unknowns and rows of the program.
    pub size: usize,
    /// How the solver ended.
    pub status: Status,
    /// Its steps.
    pub iterations: u32,
    /// Its work in element steps, with that of the attempts before it: see [`Options::max_work`].
    pub work: u64,
    /// What factorised its systems.
    pub factorisation: Factorisation,
    /// Time in the solver in seconds.
    pub seconds: f64,
    /// Time for repair and proof in seconds.
    pub proof_seconds: f64,
    /// The proven bound, if there is one.
    pub proven: Option<f64>,
    /// What the checker does not cover, if that is why nothing is proven.
    pub uncovered: Option<&'static str>,
}

/// One mesh and what was solved after it was made.
#[derive(Debug, Clone, PartialEq)]
pub struct Level {
    /// The upper bound, on this level's mesh.
    pub upper: Solve,
    /// A lower bound, on the mesh of this level or of one before.
    pub lower: Option<Solve>,
    /// Gap by the proven dissipation and the lower program's objective, and by the sum of its shares over the soil: the same
    /// quantity by two ways that have nothing in common, so a check of both programs. See [`Level::identity_residual`].
    pub identity: Option<[f64; 2]>,
}

impl Level {
    /// By how much the two gaps differ, over the upper bound; zero where they are not known. Only rounding is left of it.
    #[must_use]
    pub fn identity_residual(&self) -> f64 {
        match (self.identity, self.upper.proven) {
            (Some([a, b]), Some(upper)) => (a - b).abs() / upper.abs().max(f64::MIN_POSITIVE),
            _ => 0.0,
        }
    }

    /// Whether the two gaps agree to [`IDENTITY`], or so well that the shares say where the gap is all the same: to [`SHARES`] of it.
    #[must_use]
    pub fn shares_tell(&self) -> bool {
        let close = self.identity.is_some_and(|[a, b]| (a - b).abs() <= SHARES * a.abs());
        close || self.identity_residual() <= IDENTITY
    }
}

/// The bounds of a problem.
#[derive(Debug, Clone)]
pub struct Bounds {
    /// The greatest lower bound proven.
    pub lower: Bound<LowerField>,
    /// The least upper bound proven.
    pub upper: Bound<UpperField>,
    /// All levels.
    pub levels: Vec<Level>,
    /// Why there are no more.
    pub ended: Ended,
    /// Element steps spent: see [`Options::max_work`].
    pub work: u64,
    /// Time in seconds.
    pub seconds: f64,
}

impl Bounds {
    /// Distance of the bounds over their mean.
    #[must_use]
    pub fn gap(&self) -> f64 {
        relative_gap(self.lower.value, self.upper.value)
    }

    /// The greatest [residual](Level::identity_residual) of all levels.
    #[must_use]
    pub fn identity_residual(&self) -> f64 {
        self.levels.iter().map(Level::identity_residual).fold(0.0, f64::max)
    }
}

/// What is left of the [identity](Level::identity) in sound runs. More says that a program is not what it should be, or
/// was solved badly. Proven bounds hold all the same.
pub const IDENTITY: f64 = 1e-8;

/// What may be left of it, as a part of the gap, where shares are used to refine meshes. Layers of soil without cohesion leave some 1e-6 of the bound.
pub const SHARES: f64 = 1e-2;

fn relative_gap(lower: f64, upper: f64) -> f64 {
    2.0 * (upper - lower) / (upper + lower).abs()
}

/// What a run has proven: both sides, one, or none.
#[derive(Debug, Clone)]
pub(crate) struct Sides {
    pub(crate) lower: Option<Bound<LowerField>>,
    pub(crate) upper: Option<Bound<UpperField>>,
    pub(crate) levels: Vec<Level>,
    pub(crate) ended: Ended,
    pub(crate) work: u64,
    pub(crate) seconds: f64,
}

/// Bounds the load of a problem in plane strain, calling `progress` after each level.
///
/// # Errors
///
/// [`LimitError`] if the mesh cannot be made, the solver refuses, no pair of bounds is proven within the budget, or the
/// structure has ends, for which a flow in the plane proves nothing.
pub fn bound(
    problem: &Problem,
    options: &Options,
    progress: &mut dyn FnMut(&Level, Option<f64>),
) -> Result<Bounds, LimitError> {
    if problem.statement().width.is_some() {
        return Err(LimitError::NotCovered {
            what: "an upper bound by a flow in the plane, for a structure with ends",
            advice: "bound its section from below and take a mechanism in space from above",
        });
    }
    bound_section(problem, options, progress)
}

/// As [`bound`], for the section of a structure: where it has [a width](Problem::with_width), the lower bound holds per
/// width of a structure of any width, and the upper one is that of plane strain, which only says how good the mesh is.
///
/// # Errors
///
/// As [`bound`].
pub fn bound_section(
    problem: &Problem,
    options: &Options,
    progress: &mut dyn FnMut(&Level, Option<f64>),
) -> Result<Bounds, LimitError> {
    let Sides { lower, upper, levels, ended, work, seconds } =
        sides(problem, options, &|_, _| false, progress)?;
    match (lower, upper) {
        (Some(lower), Some(upper)) => Ok(Bounds { lower, upper, levels, ended, work, seconds }),
        (lower, upper) => {
            let spent = format!("{} levels, {work} element steps", levels.len());
            let lower = lower.map(|bound| OneSide::Lower(bound.value));
            let side = lower.or(upper.map(|bound| OneSide::Upper(bound.value)));
            Err(LimitError::nothing_proven(problem.has_no_tension(), spent).with_proven(side))
        }
    }
}

/// Whether the levels so far, and the lower and upper bound proven, are enough.
pub(crate) type Enough<'a> = dyn Fn(&[Level], [Option<f64>; 2]) -> bool + 'a;

/// Whether it is proven that what acts is borne, or that it is not: how well matters only where that is in doubt.
pub(crate) fn is_decided(_: &[Level], [lower, upper]: [Option<f64>; 2]) -> bool {
    lower.is_some_and(|lower| lower >= 1.0) || upper.is_some_and(|upper| upper < 1.0)
}

/// As [`bound`], for those to whom one side may be enough: `is_enough` is asked after each level, with the bounds proven so
/// far.
pub(crate) fn sides(
    problem: &Problem,
    options: &Options,
    is_enough: &Enough,
    progress: &mut dyn FnMut(&Level, Option<f64>),
) -> Result<Sides, LimitError> {
    continued(problem, options, None, is_enough, progress).map(|(sides, _)| sides)
}

/// As [`sides`], from where a run on the same ground with other strengths has ended; and what it leaves to the next.
pub(crate) fn continued(
    problem: &Problem,
    options: &Options,
    seed: Option<Seed>,
    is_enough: &Enough,
    progress: &mut dyn FnMut(&Level, Option<f64>),
) -> Result<(Sides, Option<Seed>), LimitError> {
    problem.covered()?;
    let mut run = match seed {
        Some(seed) => Run::seeded(problem, options, seed),
        None => Run::new(problem, options),
    };
    let ended = loop {
        let ended = run.level(progress)?;
        if let Some(what) = uncovered(&run.levels) {
            let advice = "see in docs/problem-file.md what is covered, and change that";
            return Err(LimitError::NotCovered { what, advice });
        }
        if let Some(ended) = ended {
            break run.last_lower(ended, progress)?;
        }
        let proven = [run.lower.as_ref().map(|b| b.value), run.upper.as_ref().map(|b| b.value)];
        if is_enough(&run.levels, proven) {
            break Ended::Stopped;
        }
    };
    let (work, seconds, seed) = (run.spent, run.clock.elapsed(), run.seed());
    let Run { lower, upper, levels, .. } = run;
    Ok((Sides { lower, upper, levels, ended, work, seconds }, seed))
}

/// What keeps the checker from proving any bound of one side, on more than one mesh.
fn uncovered(levels: &[Level]) -> Option<&'static str> {
    let all = |solves: Vec<Solve>| {
        let what = solves.first().and_then(|s| s.uncovered);
        what.filter(|_| solves.len() > 1 && solves.iter().all(|s| s.uncovered.is_some()))
    };
    all(levels.iter().filter_map(|l| l.lower).collect())
        .or_else(|| all(levels.iter().map(|l| l.upper).collect()))
}
