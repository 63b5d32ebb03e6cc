//! `soilctl solve FILE`: proven bounds for a problem that is described in a file.

mod answer;
mod check;
mod drawing;
mod page;
mod safety;
mod save;
mod scale;

use std::path::{Path, PathBuf};

pub(crate) use answer::SolveAnswer;
pub(crate) use check::CheckAnswer;
pub use scale::units;
use soilctl_limit_analysis::describe::Aim;
use soilctl_limit_analysis::{Description, bound};

use super::Outcome;
use super::limits::{Budget, ResultsAnswer, Show, Shown, Watch, note_doubts, words};
use crate::error::CliError;
use crate::output::Output;

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Both bounds are proven with interval arithmetic; the true value for rigid-plastic soil with \
    associated flow lies between them. What the file says is in docs/problem-file.md, examples are in data/problems. \
    Exit code 3: the budget ended before the gap was reached. Ctrl-C or SIGTERM ends the run with the best bounds so far."
)]
pub(crate) struct Args {
    /// Problem file, .toml or .json
    file: PathBuf,

    /// Only reads the file and says what it was understood to mean; --plot draws it (.svg, .png, .csv)
    #[arg(long)]
    check: bool,

    #[command(flatten)]
    budget: Budget,

    /// Saves the fields that prove the bounds, for `soilctl certify`; for a factor of safety several files
    #[arg(long, value_name = "FILE")]
    save: Option<PathBuf>,

    #[command(flatten)]
    show: Show,
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    let description = Description::read(&args.file).map_err(soilctl_limit_analysis::LimitError::from)?;
    let described = description.described()?;
    if args.check {
        if let Some(path) = check_plot(args)? {
            let figure = drawing::drawing(&description, &described)?;
            super::save_figure(&figure, path, soilctl_figure::Size::default())?;
        }
        output.answer(&CheckAnswer::new(&description, &described))?;
        return Ok(Outcome::Done);
    }
    args.show.check()?;
    let options = args.budget.options(output)?;
    if description.objective == (Aim::StrengthReduction {}) {
        return safety::run(args, &description, &options, output);
    }
    let problem = described.problem()?;
    let progress = output.spinner("first mesh");
    let mut watch = Watch::default();
    let bounds = bound(&problem, &options, &mut |level, gap| {
        watch.see(level, &options);
        progress.set_message(words(level, gap));
    });
    let bounds = bounds.map_err(|problem| watch.explain(problem))?;
    progress.finish_and_clear();
    note_doubts(&bounds.levels, output);
    if let Some(path) = &args.save {
        save::both(path, &described, &bounds)?;
    }
    let statement = &described.statement;
    let shown = Shown::new(
        Some((statement, &bounds.upper.field)),
        Some((statement, &bounds.lower.field)),
        scale::units(&description, &described),
        described.title.clone().unwrap_or_default(),
    )?;
    let results = ResultsAnswer::new(&shown, args.show.write(&shown, output)?)?;
    let mut answer = SolveAnswer::new(&described, &bounds, results);
    let told = answer.told(&args.file, args.budget.max_gap)?;
    args.show.report(&shown, &mut answer.results, told, output)?;
    output.answer(&answer)?;
    Ok(if answer.gap() <= args.budget.max_gap { Outcome::Done } else { Outcome::Partial })
}

/// Where --check draws to; files that need a solution are refused.
fn check_plot(args: &Args) -> Result<Option<&Path>, CliError> {
    let unsolved = args.save.as_ref().map(|_| "--save").or_else(|| args.show.of_a_solution());
    match unsolved {
        Some(option) => Err(CliError::Usage(format!(
            "{option} needs a solution, and --check solves nothing; leave one of them out"
        ))),
        None => Ok(args.show.plot.as_deref()),
    }
}
