//! A use case by name, with its types erased: for what goes over all of them, such as JSON schemas, the documentation and Python.

use serde_json::Value;

use crate::request::{self, Request};
use crate::{Answer, AppError, Outcome, Watch, answer, document};

/// Runs the JSON of a request; how it ended, and the JSON of the answer.
type Run = fn(&str, &dyn Watch) -> Result<(Outcome, String), AppError>;

/// A use case whose request and answer are JSON documents.
#[derive(Debug, Clone, Copy)]
pub struct UseCase {
    /// Its name, as in `soilctl NAME`; `solve check` is `soilctl solve --check`.
    pub name: &'static str,
    /// Id of the schema of its answer.
    pub answer_id: &'static str,
    request: fn() -> Result<Value, AppError>,
    answer: fn() -> Result<Value, AppError>,
    run: Run,
}

impl UseCase {
    /// Of the types of request and answer.
    pub(crate) const fn new<R: Request, A: Answer + 'static>(name: &'static str, run: Run) -> Self {
        Self { name, answer_id: A::SCHEMA, request: request::schema::<R>, answer: answer::schema::<A>, run }
    }

    /// The JSON schema of its request: fields, units, ranges, defaults and what is required.
    ///
    /// # Errors
    /// [`AppError::Json`] if the schema cannot be put into JSON.
    pub fn request(&self) -> Result<Value, AppError> {
        (self.request)()
    }

    /// The JSON schema of its answer.
    ///
    /// # Errors
    /// [`AppError::Json`] if the schema cannot be put into JSON.
    pub fn answer(&self) -> Result<Value, AppError> {
        (self.answer)()
    }

    /// Runs the request of a JSON object; how it ended, and the answer's document.
    ///
    /// # Errors
    /// [`AppError`] if the request makes no sense, or as the use case says.
    pub fn run(&self, request: &str, watch: &dyn Watch) -> Result<(Outcome, String), AppError> {
        (self.run)(request, watch)
    }
}

/// The use case of a module with a `Request` and an `Answer`, and of a function from one to the other.
macro_rules! use_case {
    ($name:literal, $module:path, $run:expr) => {{
        use $module as module;
        UseCase::new::<module::Request, module::Answer>($name, |text, watch| {
            let run: fn(&module::Request, &dyn Watch) -> Result<module::Answer, AppError> = $run;
            use_cases::answered(text, watch, run)
        })
    }};
}
pub(crate) use use_case;

/// Runs a use case from JSON to JSON.
pub(crate) fn answered<R: Request, A: Answer>(
    text: &str,
    watch: &dyn Watch,
    run: impl Fn(&R, &dyn Watch) -> Result<A, AppError>,
) -> Result<(Outcome, String), AppError> {
    let answer = run(&request::from_json(text)?, watch)?;
    Ok((answer.outcome(), document(&answer)?))
}
