//! All use cases by name, for what goes over all of them: JSON schemas, the documentation, and Python.

use serde_json::Value;

use crate::request::{self, Request};
use crate::{
    Answer, AppError, Outcome, Watch, answer, arm, bound, certify, document, estimate, predict, replay,
    shear, simulate, solve, table,
};

/// What runs a request in JSON.
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

/// The use case of a request, of a function that runs it, and of the answer in what that function gives.
macro_rules! use_case {
    ($name:literal, $module:path, $run:expr) => {{
        use $module as module;
        UseCase {
            name: $name,
            answer_id: module::Answer::SCHEMA,
            request: request::schema::<module::Request>,
            answer: answer::schema::<module::Answer>,
            run: |text, watch| {
                let run: fn(&module::Request, &dyn Watch) -> Result<module::Answer, AppError> = $run;
                answered(text, watch, run)
            },
        }
    }};
}

fn answered<R: Request, A: Answer>(
    text: &str,
    watch: &dyn Watch,
    run: impl Fn(&R, &dyn Watch) -> Result<A, AppError>,
) -> Result<(Outcome, String), AppError> {
    let answer = run(&request::from_json(text)?, watch)?;
    Ok((answer.outcome(), document(&answer)?))
}

/// All use cases.
pub const USE_CASES: &[UseCase] = &[
    use_case!("predict", crate::predict, predict::run),
    use_case!("bound", crate::bound, |request, watch| Ok(bound::run(request, watch)?.answer)),
    use_case!("solve", crate::solve, |request, watch| Ok(solve::run(request, watch)?.answer)),
    use_case!("solve check", crate::solve::check, |request, watch| {
        Ok(solve::check::run(request, watch)?.answer)
    }),
    use_case!("certify", crate::certify, |request, watch| Ok(certify::run(request, watch)?.answer)),
    use_case!("table show", crate::table::show, table::show::run),
    use_case!("table build", crate::table::build, table::build::run),
    use_case!("table merge", crate::table::merge, table::merge::run),
    use_case!("table check", crate::table::check, table::check::run),
    use_case!("estimate", crate::estimate, |request, watch| Ok(estimate::run(request, watch)?.answer)),
    use_case!("shear", crate::shear, |request, watch| Ok(shear::run(request, watch)?.answer)),
    use_case!("simulate", crate::simulate, simulate::run),
    use_case!("replay", crate::replay, replay::run),
    use_case!("arm skewing", crate::arm::skewing, |request, watch| {
        Ok(arm::skewing::run(request, watch)?.answer)
    }),
    use_case!("arm urdf", crate::arm::urdf, arm::urdf::run),
];
