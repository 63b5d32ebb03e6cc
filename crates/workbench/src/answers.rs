//! Answers that need nothing but what the page says: the same from the threads of a server and from the workers of a browser.

use std::path::Path;

use serde_json::Value;
use soilctl_app::convert::{self, Format};
use soilctl_app::solve::{self, Kept, Request, Solved, check};
use soilctl_app::{AppError, Unwatched, Watch, certify};
use soilctl_certificate::{CertificateError, Solution};
use soilctl_jobs::sha256;
use soilctl_limit_analysis::Description;

use crate::messages::{Certificate, Told, Wrong, problem};
use crate::shown::Shown;
use crate::{plate, probe, strokes, templates};

/// The first message.
pub(crate) fn hello(file: Option<String>) -> String {
    let version = env!("CARGO_PKG_VERSION");
    Told::Hello { version, file, templates: templates::all(), strokes: strokes::EXAMPLE }.text()
}

/// What is understood of a problem, or what is wrong with it.
pub(crate) fn checked(id: u64, value: Value) -> String {
    let description = match problem(value) {
        Ok(description) => description,
        Err(error) => return unchecked(id, None, error),
    };
    let toml = match description.to_toml() {
        Ok(toml) => Some(toml),
        Err(error) => return unchecked(id, None, (&error).into()),
    };
    match check::of(description, &Unwatched) {
        Ok(found) => Told::Checked {
            id,
            toml,
            understood: Some(soilctl_pages::solve::understood(&found)),
            notes: found.answer.notes.iter().map(|note| Wrong::note(note)).collect(),
            answer: Some(&found.answer),
            error: None,
        }
        .text(),
        Err(error) => unchecked(id, toml, (&error).into()),
    }
}

/// Why a problem was not understood.
pub(crate) fn unchecked(id: u64, toml: Option<String>, error: Wrong) -> String {
    let error = Some(error);
    Told::Checked { id, toml, understood: None, answer: None, notes: Vec::new(), error }.text()
}

/// The text of a problem file as a problem.
pub(crate) fn read(id: u64, text: &str) -> String {
    let read = Description::from_toml(text).or_else(|toml| {
        // Who opens a JSON file should not be told that it is no TOML.
        let is_json = text.trim_start().starts_with('{');
        if is_json { Description::from_json(text) } else { Err(toml) }
    });
    let error = read.as_ref().err().map(Wrong::from);
    Told::Read { id, problem: read.ok().as_ref(), error }.text()
}

/// The text of a drawing as a problem.
pub(crate) fn drawn(id: u64, name: &str, text: &str) -> String {
    let request = convert::Request { file: name.into(), ..convert::Request::default() };
    let found = match Format::of(&request.file) {
        Some(format) => convert::problem(text.as_bytes(), format, &request).map_err(|error| (&error).into()),
        None => Err(Wrong::words(format!(
            "{name} is no drawing; its name must end in .dxf, .geojson, .csv or .ags"
        ))),
    };
    match found {
        Ok((problem, answer)) => {
            let left = answer.left_out.iter().filter(|it| it.is_shape);
            let left = left
                .map(|it| format!("left out: {} {} on layer {}: {}", it.count, it.what, it.layer, it.why));
            let notes = left.chain(answer.notes.iter().cloned()).collect();
            Told::Drawn { id, problem: Some(&problem), notes, error: None }.text()
        }
        Err(error) => Told::Drawn { id, problem: None, notes: Vec::new(), error: Some(error) }.text(),
    }
}

/// A problem as a drawing.
pub(crate) fn drawing(id: u64, value: Value) -> String {
    let dxf = problem(value).and_then(|problem| {
        convert::drawing(&problem).to_text(Format::Dxf).map_err(|error| Wrong::words(error.to_string()))
    });
    match dxf {
        Ok(dxf) => Told::Drawing { id, dxf: Some(dxf), error: None }.text(),
        Err(error) => Told::Drawing { id, dxf: None, error: Some(error) }.text(),
    }
}

/// Bounds what a problem asks for: what is told at the end, and what was found.
pub(crate) fn solved(
    id: u64,
    description: Description,
    request: &Request,
    watch: &dyn Watch,
) -> (String, Option<Box<Solved>>) {
    match solve::of(description, request, watch) {
        Ok(found) => {
            let text = Told::Solved { id, answer: &found.answer, field: Shown::new(&found.fields) }.text();
            (text, Some(Box::new(found)))
        }
        Err(error) => (Told::Failed { id, error: (&error).into() }.text(), None),
    }
}

/// What proves the bounds that were found last, as `soilctl solve --save` writes it.
pub(crate) fn certificate(id: u64, found: Option<&Solved>) -> String {
    let Some(found) = found else {
        let words = "there is no solution to save; solve the problem first";
        return Told::Certificate { id, files: Vec::new(), error: Some(Wrong::words(words)) }.text();
    };
    let file = |kept: &Kept| -> Result<_, CertificateError> {
        let text = kept.solution.to_json(Path::new("the solution"))?;
        Ok(Certificate { part: kept.part, sha256: sha256(text.as_bytes()), text })
    };
    match found.kept.iter().map(file).collect() {
        Ok(files) => Told::Certificate { id, files, error: None }.text(),
        Err(problem) => {
            let error = Some(Wrong::words(problem.to_string()));
            Told::Certificate { id, files: Vec::new(), error }.text()
        }
    }
}

/// The calculation of what was found last, as a page for paper; `name` is the problem file's.
pub(crate) fn report(id: u64, found: Option<&Solved>, name: &str) -> String {
    let page = found.ok_or_else(|| Wrong::words("there is no solution to report; solve the problem first"));
    let page = page.and_then(|found| {
        soilctl_pages::solve::page(found, Path::new(name))
            .map_err(|problem| Wrong::words(problem.to_string()))
    });
    match page {
        Ok(mut page) => {
            page.still().footer(format!("soilctl {}", env!("CARGO_PKG_VERSION")));
            Told::Report { id, html: Some(page.to_html()), error: None }.text()
        }
        Err(error) => Told::Report { id, html: None, error: Some(error) }.text(),
    }
}

/// Stresses and velocities of what was found last, along a line.
pub(crate) fn probed(id: u64, found: Option<&Solved>, from: [f64; 2], to: [f64; 2]) -> String {
    let found = found.ok_or_else(|| "there is no solution to look into; solve the problem first".to_owned());
    match found.and_then(|found| probe::shown(&found.fields, from, to)) {
        Ok(shown) => Told::Probed { id, shown: Some(shown), error: None }.text(),
        Err(words) => Told::Probed { id, shown: None, error: Some(Wrong::words(words)) }.text(),
    }
}

/// Proves anew what the text of a saved solution claims.
pub(crate) fn certified(id: u64, name: &str, text: &str) -> String {
    let name = Path::new(name);
    let found = Solution::from_json(text, name).map_err(AppError::from);
    let found = found.and_then(|solution| certify::of(solution, name));
    let error = found.as_ref().err().map(Wrong::from);
    let answer = found.ok().map(|found| found.answer);
    Told::Certified { id, sha256: sha256(text.as_bytes()), answer, error }.text()
}

/// What a plate in a soil needs.
pub(crate) fn plate(id: u64, given: &plate::Given) -> String {
    match plate::shown(given) {
        Ok(shown) => Told::Plate { id, shown: Some(shown), error: None }.text(),
        Err(problem) => no_plate(id, &problem.to_string()),
    }
}

/// Why there is nothing to tell of a plate.
pub(crate) fn no_plate(id: u64, words: &str) -> String {
    Told::Plate { id, shown: None, error: Some(Wrong::words(words)) }.text()
}

/// What strokes say of their soil.
pub(crate) fn strokes(id: u64, given: strokes::Given) -> String {
    match strokes::shown(given) {
        Ok(shown) => Told::Strokes { id, shown: Some(Box::new(shown)), error: None }.text(),
        Err(problem) => no_strokes(id, &problem.to_string()),
    }
}

/// Why there is nothing to tell of strokes.
pub(crate) fn no_strokes(id: u64, words: &str) -> String {
    Told::Strokes { id, shown: None, error: Some(Wrong::words(words)) }.text()
}

/// Which stroke would tell most.
pub(crate) fn next(id: u64, given: strokes::Given) -> String {
    match strokes::next(given) {
        Ok(strokes) => Told::Next { id, strokes: Some(strokes), error: None }.text(),
        Err(problem) => no_next(id, &problem.to_string()),
    }
}

/// Why there is no stroke to make next.
pub(crate) fn no_next(id: u64, words: &str) -> String {
    Told::Next { id, strokes: None, error: Some(Wrong::words(words)) }.text()
}
