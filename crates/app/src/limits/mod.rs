//! What the use cases that bound collapse loads share: the budget, how levels are told, and what a solution shows.

mod budget;
mod fields;
mod levels;
mod results;
mod why;

pub use budget::{Budget, FactorisationChoice};
pub use fields::Fields;
pub use levels::{LevelAnswer, SolveAnswer};
pub use results::{BendingAnswer, ContactAnswer, MemberAnswer, ResultsAnswer, StretchAnswer, face_names};
use soilctl_limit_analysis::{Bounds, Level, Options, Problem, bound_section};

use crate::{AppError, Proven, Watch};

/// Bounds of a problem, or of the section of a structure with ends; where there are none, the error says why in physical words.
/// `unit` is what a bound is multiplied by for the answer.
pub(crate) fn bounds(
    problem: &Problem,
    options: &Options,
    unit: f64,
    watch: &dyn Watch,
) -> Result<Bounds, AppError> {
    let mut statuses = why::Statuses::default();
    let mut so_far = Proven { elements: 0, lower: None, upper: None, trial: None };
    watch.begin(0, "first mesh");
    let bounds = bound_section(problem, options, &mut |level, gap| {
        statuses.see(level, problem, options);
        watch.say(&words(level, gap));
        so_far.elements = level.upper.elements;
        let lower = level.lower.as_ref().and_then(|solve| solve.proven);
        so_far.lower = lower.map(|l| l * unit).into_iter().chain(so_far.lower).reduce(f64::max);
        so_far.upper = level.upper.proven.map(|u| u * unit).into_iter().chain(so_far.upper).reduce(f64::min);
        watch.proven(&so_far);
    });
    watch.end();
    let bounds = bounds.map_err(|error| statuses.explain(error, problem, options))?;
    levels::note_doubts(&bounds.levels, watch);
    Ok(bounds)
}

/// A level in a few words.
pub(crate) fn words(level: &Level, gap: Option<f64>) -> String {
    let elements = level.upper.elements;
    gap.map_or_else(
        || format!("{elements} elements, no bounds yet"),
        |gap| format!("{elements} elements, gap {:.2} %", 100.0 * gap.abs()),
    )
}
