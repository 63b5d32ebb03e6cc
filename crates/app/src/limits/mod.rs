//! What the use cases that bound collapse loads share: the budget, how levels are told, and what a solution shows.

mod budget;
mod fields;
mod levels;
mod results;
mod why;

pub use budget::{Budget, FactorisationChoice};
pub use fields::Fields;
pub use levels::{LevelAnswer, SolveAnswer};
pub use results::{ContactAnswer, ResultsAnswer, StretchAnswer, face_names};
use soilctl_limit_analysis::{Bounds, Level, Options, Problem, bound_section};

use crate::{AppError, Watch};

/// Bounds of a problem, or of the section of a structure with ends; where there are none, the error says why in physical words.
pub(crate) fn bounds(problem: &Problem, options: &Options, watch: &dyn Watch) -> Result<Bounds, AppError> {
    let mut statuses = why::Statuses::default();
    watch.begin(0, "first mesh");
    let bounds = bound_section(problem, options, &mut |level, gap| {
        statuses.see(level, problem, options);
        watch.say(&words(level, gap));
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
