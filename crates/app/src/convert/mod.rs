//! A problem file of a cross-section that was drawn elsewhere, and a drawing of a problem file.

mod answer;
mod conform;
mod from_problem;
mod request;
mod to_problem;

use std::path::Path;

pub use answer::{Answer, LeftOut, SoilAnswer};
pub use from_problem::drawing;
pub use request::Request;
pub use soilctl_drawing::Format;
use soilctl_drawing::{Drawing, DrawingError, Reading};
use soilctl_limit_analysis::{Description, LimitError};

use crate::files::{failed, refuse_over, save};
use crate::{AppError, Watch};

/// Reads one, writes the other; which, the endings of the files say.
///
/// # Errors
/// [`AppError`] if a file cannot be read or written, is neither drawing nor problem, has no area, or would be written over.
pub fn run(request: &Request, _watch: &dyn Watch) -> Result<Answer, AppError> {
    crate::request::check(request)?;
    let (from, to) = (&request.file, &request.out);
    match (Format::of(from), Format::of(to)) {
        (Some(format), None) if is_problem(to) => {
            let (description, answer) = problem(&read(from)?, format, request)?;
            let text = if is_json(to) {
                serde_json::to_string_pretty(&description)? + "\n"
            } else {
                description.to_toml().map_err(LimitError::from)?
            };
            write(request, &text)?;
            Ok(answer)
        }
        (None, Some(format)) if is_problem(from) => {
            let description = Description::read(from).map_err(LimitError::from)?;
            let drawing = drawing(&description);
            write(request, &drawing.to_text(format).map_err(of(from))?)?;
            Ok(Answer::of_problem(&description, &drawing))
        }
        _ => Err(AppError::Request(format!(
            "{} and {}: one must be a drawing (.dxf, .geojson, .csv or .ags) and the other a problem file (.toml or .json)",
            from.display(),
            to.display()
        ))),
    }
}

/// The problem that a drawing's bytes show; `file` of the request is what it is called.
///
/// # Errors
/// [`AppError`] if they are no such drawing, or show no area.
pub fn problem(bytes: &[u8], format: Format, request: &Request) -> Result<(Description, Answer), AppError> {
    let (join_m, chord_m, holes) = (request.join_m, request.chord_m, request.holes.clone());
    let reading = Reading { unit: request.unit()?, join_m, chord_m, holes };
    let drawing = Drawing::from_bytes(bytes, format, &reading).map_err(of(&request.file))?;
    to_problem::problem(request, drawing)
}

/// What a problem with a drawing is called.
fn of(path: &Path) -> impl Fn(DrawingError) -> AppError + use<'_> {
    move |problem| AppError::Drawing { file: path.display().to_string(), problem }
}

fn ending(path: &Path) -> Option<String> {
    Some(path.extension()?.to_str()?.to_ascii_lowercase())
}

fn is_json(path: &Path) -> bool {
    ending(path).as_deref() == Some("json")
}

fn is_problem(path: &Path) -> bool {
    is_json(path) || ending(path).as_deref() == Some("toml")
}

fn read(path: &Path) -> Result<Vec<u8>, AppError> {
    let size = std::fs::metadata(path).map_err(failed(path))?.len();
    let (what, limit) = ("bytes", soilctl_drawing::MOST_BYTES);
    let count = usize::try_from(size).unwrap_or(usize::MAX);
    if count > limit {
        return Err(of(path)(DrawingError::TooLarge { what, count, limit }));
    }
    std::fs::read(path).map_err(failed(path))
}

/// Writes the file, not over one that is there: somebody may have put strengths into it.
fn write(request: &Request, text: &str) -> Result<(), AppError> {
    refuse_over(&request.out, request.replace)?;
    save(&request.out, text.as_bytes())
}
