//! All use cases of `soilctl_app`, by name and in JSON; `python/soilctl/use_cases.py` makes typed functions of them.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use pyo3::prelude::*;
use soilctl_app::request::from_json;
use soilctl_app::{
    Answer as _, AppError, Interrupted, Outcome, USE_CASES, Watch, diagnose, document, process,
};
use soilctl_pages::PageError;

use crate::error::{Answer, Fail, file, file_at, input, kinds};
use crate::progress::with_progress;

/// Runs a use case; `progress` is called with the steps done and of all steps, from time to time and at the end.
///
/// Args:
///     name: Its name, such as ``shear`` or ``log info``.
///     request: A JSON object with the fields of its request; those that are left out have their defaults.
///     progress: Called with the number of steps that are done and of all.
///     page: Of ``process`` the HTML page to write. A diagnosis writes its page whatever is said here.
///
/// Returns:
///     The exit code of the command line, 0 done, 1 done and the answer is negative, 3 done in part; and the answer in JSON.
#[pyfunction]
#[pyo3(signature = (name, request, progress = None, page = None))]
pub(crate) fn run_use_case(
    py: Python<'_>,
    name: &str,
    request: &str,
    progress: Option<&Bound<'_, PyAny>>,
    page: Option<PathBuf>,
) -> Answer<(u8, String)> {
    let Some(use_case) = USE_CASES.iter().find(|one| one.name == name) else {
        let names: Vec<&str> = USE_CASES.iter().map(|one| one.name).collect();
        return Err(input(format!("there is no use case {name:?}; known are {}", names.join(", "))));
    };
    let steps = Steps::default();
    let (outcome, json) = with_progress(
        py,
        progress,
        || steps.get(),
        |stop| {
            let watch = PythonWatch { stop, steps: &steps };
            match (name, &page) {
                ("diagnose", _) => diagnose_with_page(request, &watch),
                ("process", Some(page)) => process_with_page(request, page, &watch),
                _ => Ok(use_case.run(request, &watch)?),
            }
        },
    )?;
    Ok((outcome.exit_code(), json))
}

/// A diagnosis with its page, which is written beside the model file.
fn diagnose_with_page(request: &str, watch: &dyn Watch) -> Result<(Outcome, String), PageError> {
    let mut found = diagnose::run(&from_json(request)?, watch)?;
    soilctl_pages::diagnose::write(&mut found, None, "")?;
    Ok((found.answer.outcome(), document(&found.answer)?))
}

/// Processed logs with their page.
fn process_with_page(request: &str, page: &Path, watch: &dyn Watch) -> Result<(Outcome, String), PageError> {
    let mut answer = process::run(&from_json(request)?, watch)?;
    let written = soilctl_pages::write(&mut soilctl_pages::process::page(&answer)?, Some(page), None, "")?;
    answer.written.extend(written);
    Ok((answer.outcome(), document(&answer)?))
}

impl From<PageError> for Fail {
    fn from(problem: PageError) -> Self {
        match problem {
            PageError::App(problem) => problem.into(),
            problem => input(problem),
        }
    }
}

/// Names, ids and JSON schemas of all use cases, from which typed functions are generated.
///
/// Returns:
///     Of each its name, the id of the schema of its answer, and the JSON schemas of request and answer.
#[pyfunction]
pub(crate) fn use_case_schemas() -> Answer<Vec<(&'static str, &'static str, String, String)>> {
    let of = |one: &soilctl_app::UseCase| -> Result<_, AppError> {
        Ok((one.name, one.answer_id, one.request()?.to_string(), one.answer()?.to_string()))
    };
    Ok(USE_CASES.iter().map(of).collect::<Result<_, _>>()?)
}

/// Steps of the work that a use case is at; (0, 0) as long as nothing is counted.
#[derive(Default)]
struct Steps {
    done: AtomicU64,
    all: AtomicU64,
}

impl Steps {
    fn get(&self) -> (u64, u64) {
        let all = self.all.load(Ordering::Acquire);
        (self.done.load(Ordering::Relaxed).min(all), all)
    }
}

/// What a use case tells Python. Notes beside the answer are for people who wait, and are dropped.
struct PythonWatch<'a> {
    stop: Arc<AtomicBool>,
    steps: &'a Steps,
}

impl Watch for PythonWatch<'_> {
    fn stop(&self, _: Interrupted) -> Arc<AtomicBool> {
        Arc::clone(&self.stop)
    }

    fn begin(&self, steps: u64, _: &str) {
        self.steps.done.store(0, Ordering::Relaxed);
        self.steps.all.store(steps, Ordering::Release);
    }

    fn advance(&self, steps: u64) {
        self.steps.done.fetch_add(steps, Ordering::Relaxed);
    }

    fn end(&self) {}

    fn note(&self, _: &str) {}
}

impl From<AppError> for Fail {
    fn from(problem: AppError) -> Self {
        match problem {
            AppError::EarthPressure(problem) => problem.into(),
            AppError::Soil(problem) => problem.into(),
            AppError::Estimator(problem) => problem.into(),
            AppError::Limit(problem) => problem.into(),
            AppError::Certificate(problem) => problem.into(),
            AppError::Session(problem) => problem.into(),
            AppError::Kinematics(problem) => problem.into(),
            AppError::NotFinite { .. } => Fail(kinds::NoAnswerError::new_err(problem.to_string())),
            AppError::Json(_) => Fail(kinds::InputTypeError::new_err(problem.to_string())),
            AppError::File { ref path, .. } => file_at(&problem, path),
            _ if problem.is_of_a_file() => file(problem),
            _ => input(problem),
        }
    }
}
