//! Proven bounds on the force of an embedded plate.

mod answer;
mod end;
mod ends;
mod plate;
mod request;

pub use answer::{Answer, Inputs};
pub use end::{EndAnswer, EndBudget, EndField, find_end};
pub use ends::{ProofKind, WidthAnswer, ratio_of_ends};
pub(crate) use plate::ScaledPlate;
pub use request::Request;

use std::sync::Arc;
use std::time::Instant;

use ends::{Brackets, Mechanisms};

use crate::files::can_be_written;
use crate::limits::{self, Fields, ResultsAnswer};
use crate::{AppError, Watch, plausible};

/// The answer, and the fields behind it.
#[derive(Debug)]
pub struct Bounded {
    /// The answer.
    pub answer: Answer,
    /// The fields that prove it.
    pub fields: Fields,
    /// Why the solution was not saved, if it was to be: bounds that took their time are not lost with a file.
    pub unsaved: Option<AppError>,
}

impl Bounded {
    /// The answer of a run that did all it was asked for.
    ///
    /// # Errors
    /// [`AppError`] if the solution could not be saved.
    pub fn complete(self) -> Result<Answer, AppError> {
        self.unsaved.map_or(Ok(self.answer), Err)
    }
}

/// Bounds the force of a plate.
///
/// # Errors
/// [`AppError`] if the request makes no sense, there is no folder for the solution, or there are no bounds.
pub fn run(request: &Request, watch: &dyn Watch) -> Result<Bounded, AppError> {
    crate::request::check(request)?;
    request.save.as_deref().map_or(Ok(()), can_be_written)?;
    let scaled = ScaledPlate::new(request)?;
    plausible::of_plate(request).iter().for_each(|note| watch.note(note));
    let Request { ends, width_ratio, width_m, depth_m, .. } = *request;
    let width_ratio = ratio_of_ends(ends, width_ratio, width_m, depth_m)?;
    if request.friction_law.is_some() && width_ratio.is_some() {
        return Err(AppError::Request(
            "--friction-law is for plane strain: bounds of plates with ends are for one friction angle; leave the width out, or give --ends none".into(),
        ));
    }
    let problem = match width_ratio {
        Some(ratio) => scaled.problem_with_ends(ratio)?,
        None => scaled.problem()?,
    };
    let options = request.budget.options(watch)?;
    let mechanisms = width_ratio.map(|ratio| Mechanisms::new(&scaled, &problem, ratio, watch)).transpose()?;
    let bounds = limits::bounds(&problem, &options, 1.0, watch)?;
    let start = Instant::now();
    let end = width_ratio.map(|ratio| {
        watch.begin(0, "stresses about the ends in space");
        let budget = EndBudget {
            tetrahedra: request.tetrahedra as usize,
            seconds: request.budget.max_seconds.map(|all| all - bounds.seconds),
            memory: options.max_memory_bytes,
            stop: Arc::clone(&options.stop),
        };
        let found = scaled.end(ratio, &budget, &mut |level| {
            watch.say(&format!("{} tetrahedra", level.tetrahedra));
        });
        watch.end();
        (found, start.elapsed().as_secs_f64())
    });
    let field = end.as_ref().and_then(|(found, _)| found.as_ref().ok());
    let brackets = match &mechanisms {
        Some(mechanisms) => mechanisms.brackets(&scaled, &bounds, field),
        None => Brackets::plane(&scaled, &bounds),
    };
    let unsaved = request.save.as_ref().and_then(|path| {
        let plane = scaled.solution(&problem, &bounds);
        let solution = match &mechanisms {
            Some(mechanisms) => mechanisms.solution(plane, field),
            None => plane,
        };
        solution.write(path).err().map(AppError::from)
    });
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
    let fields = match field {
        Some(end) => fields.with_end(statement, &end.claim.field)?,
        None => fields,
    };
    let end = end.map(|(found, seconds)| EndAnswer::new(&found, seconds, &scaled));
    let answer = Answer::new(request, &scaled, &bounds, (brackets, end), ResultsAnswer::new(&fields)?);
    Ok(Bounded { answer, fields, unsaved })
}
