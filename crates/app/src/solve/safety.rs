//! Bounds on a factor of safety.

use std::path::Path;

use soilctl_limit_analysis::results::problem_units;
use soilctl_limit_analysis::{Described, Description, Level, factor_of_safety};

use super::{Answer, Solved, one_side, save};
use crate::limits::{Budget, Fields, ResultsAnswer, words};
use crate::text::number;
use crate::{AppError, Proven, Watch};

/// What is proven after a level of a trial: with strength over the factor the soil stands, falls, or neither is known.
fn tried(so_far: Proven, factor: f64, level: &Level) -> Proven {
    let stands = level.lower.as_ref().and_then(|solve| solve.proven).is_some_and(|borne| borne >= 1.0);
    let falls = level.upper.proven.is_some_and(|borne| borne < 1.0);
    let factor_if = |is: bool| is.then_some(factor);
    Proven {
        elements: level.upper.elements,
        lower: factor_if(stands).into_iter().chain(so_far.lower).reduce(f64::max),
        upper: factor_if(falls).into_iter().chain(so_far.upper).reduce(f64::min),
        trial: Some(factor),
    }
}

pub(super) fn run(
    budget: &Budget,
    save: Option<&Path>,
    description: Description,
    described: Described,
    watch: &dyn Watch,
) -> Result<Solved, AppError> {
    let options = budget.options(watch)?;
    watch.begin(0, "first mesh");
    let mut so_far = Proven { elements: 0, lower: None, upper: None, trial: None };
    let safety = factor_of_safety(&description, &options, &mut |factor, level, proven| {
        so_far = tried(so_far, factor, level);
        watch.proven(&so_far);
        let known =
            proven.map_or_else(String::new, |gap| format!(", factor of safety to {:.2} %", 100.0 * gap));
        watch.say(&format!("strength over {}: {}{known}", number(factor), words(level, None)));
    });
    watch.end();
    let safety = safety.map_err(one_side::of_safety)?;
    let kept = save::safety(&safety);
    let unsaved = save.and_then(|path| {
        save::write(&kept, path)
            .map(|files| files.iter().for_each(|file| watch.note(&format!("saved {}", file.display()))))
            .err()
    });
    let (upper, lower) = (&safety.upper, &safety.lower);
    let fields = Fields::new(
        Some((&upper.described.statement, &upper.bound.field)),
        Some((&lower.described.statement, &lower.bound.field)),
        problem_units(&description, &upper.described),
        description.title.clone().unwrap_or_default(),
    )?;
    let results = ResultsAnswer::new(&fields)?;
    let answer = Answer::of_safety(description.title.as_ref(), &safety, results, budget.max_gap);
    let given = description.clone();
    Ok(Solved { answer, fields, given, description, described, cases: Vec::new(), kept, unsaved })
}
