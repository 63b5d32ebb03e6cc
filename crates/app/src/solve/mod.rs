//! Proven bounds for a problem that is described in a file.

mod answer;
mod asked;
mod boundary;
mod cases;
pub mod check;
mod one_side;
mod safety;
mod save;

use std::path::{Path, PathBuf};

pub use answer::{Answer, TrialAnswer};
pub use asked::Asked;
pub use boundary::BoundaryKind;
pub use cases::CaseAnswer;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_limit_analysis::describe::Aim;
use soilctl_limit_analysis::results::problem_units;
use soilctl_limit_analysis::{Description, LimitError};

use crate::limits::{self, Budget, Fields, ResultsAnswer};
use crate::{AppError, Watch};

/// Proven bounds for any plane-strain collapse problem described in a file.
#[derive(Debug, Clone, Default, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
pub struct Request {
    /// Problem file, .toml or .json
    pub file: PathBuf,

    #[command(flatten)]
    #[serde(flatten)]
    #[allow(missing_docs)]
    pub budget: Budget,

    /// Saves the fields that prove the bounds, for `soilctl certify`; for a factor of safety several files
    #[arg(long, value_name = "FILE")]
    pub save: Option<PathBuf>,
}

/// The answer, and the fields behind it.
#[derive(Debug)]
pub struct Solved {
    /// The answer.
    pub answer: Answer,
    /// The fields that prove it.
    pub fields: Fields,
}

/// Bounds what the file asks for.
///
/// # Errors
/// [`AppError`] if the file makes no sense, there are no bounds, or the solution cannot be saved.
pub fn run(request: &Request, watch: &dyn Watch) -> Result<Solved, AppError> {
    crate::request::check(request)?;
    let description = Description::read(&request.file).map_err(LimitError::from)?;
    let cases = description.cases().map_err(LimitError::from)?;
    if !cases.is_empty() {
        return cases::run(request, &cases, watch);
    }
    solve_one(&request.budget, request.save.as_deref(), &description, watch)
}

/// Bounds what a description without cases asks for.
fn solve_one(
    budget: &Budget,
    save: Option<&Path>,
    description: &Description,
    watch: &dyn Watch,
) -> Result<Solved, AppError> {
    let described = description.described()?;
    if description.objective == (Aim::StrengthReduction {}) {
        return safety::run(budget, save, description, watch);
    }
    let bounds = limits::bounds(&described.problem()?, &budget.options(watch)?, watch)
        .map_err(|problem| one_side::of_problem(problem, &described))?;
    if let Some(path) = save {
        save::both(path, &described, &bounds)?;
    }
    let statement = &described.statement;
    let fields = Fields::new(
        Some((statement, &bounds.upper.field)),
        Some((statement, &bounds.lower.field)),
        problem_units(description, &described),
        described.title.clone().unwrap_or_default(),
    )?;
    let answer = Answer::new(&described, &bounds, ResultsAnswer::new(&fields)?, budget.max_gap);
    Ok(Solved { answer, fields })
}
