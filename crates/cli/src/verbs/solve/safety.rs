//! `solve` for a factor of safety.

use soilctl_limit_analysis::{Description, Options, factor_of_safety};

use super::answer::SolveAnswer;
use super::{Args, save, scale};
use crate::error::CliError;
use crate::output::Output;
use crate::text::number;
use crate::verbs::Outcome;
use crate::verbs::limits::{ResultsAnswer, Shown, words};

pub(super) fn run(
    args: &Args,
    description: &Description,
    options: &Options,
    output: &mut Output,
) -> Result<Outcome, CliError> {
    let progress = output.spinner("first mesh");
    let safety = factor_of_safety(description, options, &mut |factor, level, proven| {
        let known =
            proven.map_or_else(String::new, |gap| format!(", factor of safety to {:.2} %", 100.0 * gap));
        progress.set_message(format!("strength over {}: {}{known}", number(factor), words(level, None)));
    })?;
    progress.finish_and_clear();
    if let Some(path) = &args.save {
        for file in save::safety(path, &safety)? {
            output.note(&format!("saved {}", file.display()));
        }
    }
    let (upper, lower) = (&safety.upper, &safety.lower);
    let shown = Shown::new(
        Some((&upper.described.statement, &upper.bound.field)),
        Some((&lower.described.statement, &lower.bound.field)),
        scale::units(description, &upper.described),
        description.title.clone().unwrap_or_default(),
    )?;
    let results = ResultsAnswer::new(&shown, args.show.write(&shown, output)?)?;
    let mut answer = SolveAnswer::of_safety(description.title.as_ref(), &safety, results);
    let told = answer.told(&args.file, args.budget.max_gap)?;
    args.show.report(&shown, &mut answer.results, told, output)?;
    output.answer(&answer)?;
    Ok(if answer.gap() <= args.budget.max_gap { Outcome::Done } else { Outcome::Partial })
}
