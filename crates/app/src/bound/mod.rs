//! Proven bounds on the force of an embedded plate.

mod answer;
mod plate;
mod request;

pub use answer::{Answer, Inputs};
pub(crate) use plate::ScaledPlate;
pub use request::Request;

use crate::limits::{self, Fields, ResultsAnswer};
use crate::{AppError, Watch};

/// The answer, and the fields behind it.
#[derive(Debug)]
pub struct Bounded {
    /// The answer.
    pub answer: Answer,
    /// The fields that prove it.
    pub fields: Fields,
}

/// Bounds the force of a plate.
///
/// # Errors
/// [`AppError`] if the request makes no sense, there are no bounds, or the solution cannot be saved.
pub fn run(request: &Request, watch: &dyn Watch) -> Result<Bounded, AppError> {
    crate::request::check(request)?;
    let scaled = ScaledPlate::new(request)?;
    let problem = scaled.problem()?;
    let bounds = limits::bounds(&problem, &request.budget.options(watch)?, watch)?;
    if let Some(path) = &request.save {
        scaled.solution(&problem, &bounds).write(path)?;
    }
    let statement = problem.statement();
    let fields = Fields::new(
        Some((statement, &bounds.upper.field)),
        Some((statement, &bounds.lower.field)),
        scaled.shown_in(),
        scaled.title(),
    )?;
    let answer = Answer::new(request, &scaled, &bounds, ResultsAnswer::new(&fields)?);
    Ok(Bounded { answer, fields })
}
