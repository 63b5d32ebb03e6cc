//! Proven bounds on the force of an embedded plate.

mod answer;
mod ends;
mod plate;
mod request;

pub use answer::{Answer, Inputs};
pub use ends::{ProofKind, WidthAnswer};
pub(crate) use plate::ScaledPlate;
pub use request::Request;

use ends::WithEnds;

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
    let width_ratio = request.width_ratio()?;
    let plane = scaled.problem()?;
    let problem = match width_ratio {
        Some(ratio) => plane.with_width(scaled.slant_width(ratio))?,
        None => plane,
    };
    let bounds = limits::bounds(&problem, &request.budget.options(watch)?, watch)?;
    let ended =
        width_ratio.map(|ratio| WithEnds::new(&scaled, &problem, &bounds, ratio, watch)).transpose()?;
    if let Some(path) = &request.save {
        let plane = || scaled.solution(&problem, &bounds);
        ended.as_ref().map_or_else(plane, |e| e.solution(&scaled, &problem, &bounds)).write(path)?;
    }
    let statement = problem.statement();
    let fields = Fields::new(
        Some((statement, &bounds.upper.field)),
        Some((statement, &bounds.lower.field)),
        scaled.shown_in(),
        scaled.title(),
    )?;
    let answer = Answer::new(request, &scaled, &bounds, ended.as_ref(), ResultsAnswer::new(&fields)?);
    Ok(Bounded { answer, fields })
}
