//! Proven bounds for a problem that is described in a file.

mod answer;
mod asked;
mod boundary;
mod cases;
pub mod check;
mod one_side;
mod safety;
mod save;
mod seepage;

use std::path::{Path, PathBuf};

pub use answer::{Answer, TrialAnswer};
pub use asked::Asked;
pub use boundary::BoundaryKind;
pub use cases::CaseAnswer;
pub use save::Kept;
pub(crate) use save::write;
use schemars::JsonSchema;
pub use seepage::{HeadAnswer, SeepageAnswer};
use serde::{Deserialize, Serialize};
use soilctl_limit_analysis::describe::{Aim, Case, Quantity};
use soilctl_limit_analysis::results::problem_units;
use soilctl_limit_analysis::{Described, Description, LimitError, OneSide};

use crate::files::can_be_written;
use crate::limits::{self, Budget, Fields, ResultsAnswer};
use crate::{AppError, Watch, plausible};

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
    /// The file as it was given.
    pub given: Description,
    /// The file, of cases that of the governing one, with its values set and its partial factors applied.
    pub description: Description,
    /// The same cut into regions, in the units of the solver.
    pub described: Described,
    /// The cases of the file, with what each of them solved; none if it has none.
    pub cases: Vec<Case>,
    /// What proves the bounds, of the governing case if there are several.
    pub kept: Vec<Kept>,
    /// Why the solution was not saved, if it was to be: bounds that took their time are not lost with a file.
    pub unsaved: Option<AppError>,
}

impl Solved {
    /// The answer of a run that did all it was asked for.
    ///
    /// # Errors
    /// [`AppError`] if the solution could not be saved.
    pub fn complete(self) -> Result<Answer, AppError> {
        self.unsaved.map_or(Ok(self.answer), Err)
    }
}

/// Bounds what the file asks for.
///
/// # Errors
/// [`AppError`] if the file makes no sense, there is no folder for the solution, or there are no bounds.
pub fn run(request: &Request, watch: &dyn Watch) -> Result<Solved, AppError> {
    crate::request::check(request)?;
    of(Description::read(&request.file).map_err(LimitError::from)?, request, watch)
}

/// Bounds what a description asks for; the file of the request is not read.
///
/// # Errors
/// As those of [`run`].
pub fn of(description: Description, request: &Request, watch: &dyn Watch) -> Result<Solved, AppError> {
    crate::request::check(request)?;
    request.save.as_deref().map_or(Ok(()), can_be_written)?;
    let cases = description.cases().map_err(LimitError::from)?;
    let given = description.clone();
    let notes = plausible::of_file(&description, &cases);
    notes.iter().for_each(|note| watch.note(note));
    let mut solved = if cases.is_empty() {
        one(&request.budget, request.save.as_deref(), description, watch)?
    } else {
        cases::run(request, &cases, watch)?
    };
    solved.answer.notes = notes;
    solved.answer.seepage = SeepageAnswer::of(&solved.described);
    solved.given = given;
    solved.cases = cases;
    Ok(solved)
}

/// Bounds what a description without cases asks for.
pub(crate) fn one(
    budget: &Budget,
    save: Option<&Path>,
    description: Description,
    watch: &dyn Watch,
) -> Result<Solved, AppError> {
    let described = description.described()?;
    if description.objective == (Aim::StrengthReduction {}) {
        return safety::run(budget, save, description, described, watch);
    }
    let side_of = described.clone();
    found(budget, save, description, described, watch)
        .map_err(|problem| one_side::of_problem(problem, &side_of))
}

/// Bounds what a description without cases asks for, or the one side that is proven.
pub(crate) fn one_or_side(
    budget: &Budget,
    save: Option<&Path>,
    description: Description,
    watch: &dyn Watch,
) -> Result<Solved, (Option<OneSide>, Box<AppError>)> {
    let described = description.described().map_err(|problem| (None, Box::new(AppError::from(problem))))?;
    let side_of = described.clone();
    found(budget, save, description, described, watch).map_err(|problem| {
        (one_side::proven(&problem, &side_of), Box::new(one_side::of_problem(problem, &side_of)))
    })
}

/// Bounds the section of a structure with ends: the lower bound holds per metre for every width, and is the only one that is kept; the upper
/// one is that of plane strain.
pub(crate) fn with_ends(
    budget: &Budget,
    description: Description,
    width_m: f64,
    watch: &dyn Watch,
) -> Result<Solved, AppError> {
    let mut described = description.described()?;
    described.statement = described.statement.with_width(width_m / described.length_m);
    found(budget, None, description, described, watch)
}

/// Bounds a described problem other than a factor of safety.
fn found(
    budget: &Budget,
    save: Option<&Path>,
    description: Description,
    described: Described,
    watch: &dyn Watch,
) -> Result<Solved, AppError> {
    let unit = match described.quantity {
        Quantity::ForceKnPerM => described.length_m * described.stress_kpa,
        Quantity::LoadFactor | Quantity::WeightFactor | Quantity::Acceleration => 1.0,
    };
    let bounds = limits::bounds(&described.problem()?, &budget.options(watch)?, unit, watch)?;
    let kept = save::both(&described, &bounds);
    let unsaved = save.and_then(|path| write(&kept, path).err());
    let statement = &described.statement;
    let fields = Fields::new(
        Some((statement, &bounds.upper.field)),
        Some((statement, &bounds.lower.field)),
        problem_units(&description, &described),
        described.title.clone().unwrap_or_default(),
    )?;
    let answer = Answer::new(&described, &bounds, ResultsAnswer::new(&fields)?, budget.max_gap);
    let given = description.clone();
    Ok(Solved { answer, fields, given, description, described, cases: Vec::new(), kept, unsaved })
}
