//! `soilctl bound`: proven bounds on the force of an embedded plate.

mod answer;
mod page;
mod plate;

use std::path::PathBuf;

pub(crate) use answer::BoundAnswer;
use soilctl_limit_analysis::bound;

use super::Outcome;
use super::limits::{Budget, ResultsAnswer, Show, Shown, Watch, note_doubts, words};
use crate::args::{LoadArgs, finite};
use crate::error::CliError;
use crate::output::Output;
pub(crate) use plate::Scaled;

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Both bounds are proven with interval arithmetic; the true force of the rigid-plastic soil with \
    associated flow lies between them. Coefficients are net and per slant length, K = 2 F / (gamma L^2 w). Exit code 3: \
    the budget ended before the gap was reached. Ctrl-C or SIGTERM ends the run with the best bounds so far."
)]
pub(crate) struct Args {
    /// Tool angle from the horizontal (deg), 10 to 170
    #[arg(long, value_name = "DEG", value_parser = finite, allow_negative_numbers = true)]
    alpha: f64,

    /// Internal friction angle of the soil (deg), above 0 and below 70
    #[arg(long, value_name = "DEG", value_parser = finite, allow_negative_numbers = true)]
    phi: f64,

    /// Friction angle between soil and plate (deg), at most phi
    #[arg(long, value_name = "DEG", value_parser = finite, allow_negative_numbers = true)]
    delta: f64,

    /// Bulk density (kg/m3); needed for forces, and with cohesion, adhesion or surcharge
    #[arg(long, value_name = "KG/M3", value_parser = finite, allow_negative_numbers = true)]
    density: Option<f64>,

    /// Vertical depth of the plate's lower edge below the surface (m); likewise
    #[arg(long, value_name = "M", value_parser = finite, allow_negative_numbers = true)]
    depth: Option<f64>,

    /// Width of the plate (m); needed for forces
    #[arg(long, value_name = "M", value_parser = finite, allow_negative_numbers = true)]
    width: Option<f64>,

    #[command(flatten)]
    loads: LoadArgs,

    #[command(flatten)]
    budget: Budget,

    /// Saves the fields that prove the bounds, for `soilctl certify`
    #[arg(long, value_name = "FILE")]
    save: Option<PathBuf>,

    #[command(flatten)]
    show: Show,
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    let scaled = Scaled::new(args)?;
    let problem = scaled.plate.problem()?;
    args.show.check()?;
    let options = args.budget.options(output)?;
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
        scaled.solution(&problem, &bounds).write(path)?;
    }
    let statement = problem.statement();
    let fields = (&bounds.upper.field, &bounds.lower.field);
    let shown = Shown::new(
        Some((statement, fields.0)),
        Some((statement, fields.1)),
        scaled.shown_in(),
        scaled.title(),
    )?;
    let results = ResultsAnswer::new(&shown, args.show.write(&shown, output)?)?;
    let mut answer = BoundAnswer::new(args, &scaled, &bounds, results);
    let told = answer.told(args.budget.max_gap)?;
    args.show.report(&shown, &mut answer.results, told, output)?;
    output.answer(&answer)?;
    Ok(if bounds.gap() <= args.budget.max_gap { Outcome::Done } else { Outcome::Partial })
}
