//! Force and coefficients of a plate from a named model.

mod answer;
mod chosen;
mod law;
mod patched;
mod request;
mod single;
mod strokes;

pub use answer::{Answer, BracketEnds, Inputs, Range, Sensitivity, StrokePrediction};
pub use law::LawPrediction;
pub use request::Request;
use soilctl_earth_pressure::Case;

use crate::{AppError, Watch, request as requests};

/// Predicts one plate, or one for every row of a stroke table.
///
/// # Errors
/// [`AppError`] if the request makes no sense, the model has no answer there, or a file cannot be read.
pub fn run(request: &Request, _watch: &dyn Watch) -> Result<Answer, AppError> {
    requests::check(request)?;
    if let Some(path) = &request.model_file {
        return patched::predict(request, path);
    }
    match (&request.strokes, request.alpha_deg) {
        (Some(table), _) => strokes::predict(request, table),
        (None, Some(alpha)) => match request.friction_law {
            Some(slopes) => law::predict(request, alpha, slopes),
            None => single::predict(request, alpha, true),
        },
        (None, None) => Err(AppError::Request("give --alpha DEG or --strokes FILE".into())),
    }
}

impl Request {
    /// The four angles of a single plate; `None` for strokes of a table.
    ///
    /// # Errors
    /// [`AppError::Request`] if an angle is missing.
    pub fn case(&self) -> Result<Option<Case>, AppError> {
        self.alpha_deg.map(|alpha_deg| single::case(self, alpha_deg)).transpose()
    }
}
