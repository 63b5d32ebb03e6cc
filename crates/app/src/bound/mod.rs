//! Proven bounds on the force of an embedded plate.

mod answer;
mod ends;
mod plate;
mod request;

pub use answer::{Answer, Inputs};
pub use ends::{ProofKind, WidthAnswer, ratio_of_ends};
pub(crate) use plate::ScaledPlate;
pub use request::Request;

use ends::{Brackets, Mechanisms};

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
    let Request { ends, width_ratio, width_m, depth_m, .. } = *request;
    let width_ratio = ratio_of_ends(ends, width_ratio, width_m, depth_m)?;
    let plane = scaled.problem()?;
    let problem = match width_ratio {
        Some(ratio) => plane.with_width(scaled.slant_width(ratio))?,
        None => plane,
    };
    let options = request.budget.options(watch)?;
    let mechanisms = width_ratio.map(|ratio| Mechanisms::new(&scaled, &problem, ratio, watch)).transpose()?;
    let bounds = limits::bounds(&problem, &options, watch)?;
    let brackets = match &mechanisms {
        Some(mechanisms) => mechanisms.brackets(&scaled, &bounds),
        None => Brackets::plane(&scaled, &bounds),
    };
    if let Some(path) = &request.save {
        let plane = scaled.solution(&problem, &bounds);
        match &mechanisms {
            Some(mechanisms) => mechanisms.solution(plane),
            None => plane,
        }
        .write(path)?;
    }
    let statement = problem.statement();
    let fields = Fields::new(
        Some((statement, &bounds.upper.field)),
        Some((statement, &bounds.lower.field)),
        scaled.shown_in(),
        scaled.title(),
    )?;
    let fields = match &mechanisms {
        Some(mechanisms) => fields.with_blocks(statement, mechanisms.own())?,
        None => fields,
    };
    let answer = Answer::new(request, &scaled, &bounds, brackets, ResultsAnswer::new(&fields)?);
    Ok(Bounded { answer, fields })
}
