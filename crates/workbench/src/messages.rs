//! What page and server say to each other: one JSON object a message.

use serde::{Deserialize, Serialize};
use serde_json::Value;
use soilctl_app::estimate::NextStroke;
use soilctl_app::solve::{Answer, check};
use soilctl_app::{AppError, Proven, certify};
use soilctl_limit_analysis::describe::Place;
use soilctl_limit_analysis::{Description, DescriptionError, LimitError};
use soilctl_pages::solve::Understood;

use crate::shown::Shown;
use crate::templates::Given;
use crate::{plate, probe, strokes};

/// From a page.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(tag = "type", rename_all = "snake_case", deny_unknown_fields)]
pub(crate) enum Request {
    /// Shows the token, for which it gets the file.
    Authorize { token: String },
    /// What is understood of a problem, in JSON form; of several that wait, only the last is looked at.
    Check { id: u64, problem: Value },
    /// Converts the text of a problem file.
    Read { id: u64, text: String },
    /// Makes a problem of the text of a drawing, whose ending is that of `name`.
    Draw { id: u64, name: String, text: String },
    /// Makes a drawing of a problem.
    Drawing { id: u64, problem: Value },
    /// Bounds what a problem asks for.
    Solve { id: u64, problem: Value, budget: Spend },
    /// Ends the run with the best bounds so far.
    Stop {},
    /// Writes the text of a problem file to the file that was given at the start.
    Save {
        id: u64,
        text: String,
        /// Also over what another program wrote meanwhile.
        anyway: bool,
    },
    /// What proves the bounds that were found last.
    Certificate { id: u64 },
    /// The calculation of what was found last; `name` is what the problem file is called.
    Report { id: u64, name: String },
    /// Stresses and velocities of what was found last, along a line in m.
    Probe { id: u64, from: [f64; 2], to: [f64; 2] },
    /// Proves anew what a saved solution claims.
    Certify { id: u64, name: String, text: String },
    /// What a plate in a soil needs; of several that wait, only the last is answered.
    Plate { id: u64, plate: plate::Given },
    /// What strokes say of their soil; of several that wait, only the last is answered.
    Strokes { id: u64, strokes: strokes::Given },
    /// Which stroke would tell most of it, which takes longer; of several that wait, only the last is answered.
    Next { id: u64, next: strokes::Given },
}

/// What a run may spend.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Spend {
    pub(crate) max_gap: f64,
    pub(crate) max_seconds: Option<f64>,
}

/// What is wrong, and where that belongs.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct Wrong {
    pub(crate) words: String,
    #[serde(flatten)]
    pub(crate) place: Place,
}

impl Wrong {
    pub(crate) fn words(words: impl Into<String>) -> Self {
        Self { words: words.into(), place: Place::default() }
    }

    /// A note that begins with the title of its entry.
    pub(crate) fn note(words: &str) -> Self {
        Self { words: words.to_owned(), place: Place::of_words(words) }
    }
}

impl From<&DescriptionError> for Wrong {
    fn from(problem: &DescriptionError) -> Self {
        Self { words: problem.to_string(), place: problem.place() }
    }
}

impl From<&AppError> for Wrong {
    fn from(problem: &AppError) -> Self {
        match problem {
            AppError::Limit(LimitError::Description(wrong)) => wrong.into(),
            other => Self::words(other.to_string()),
        }
    }
}

/// To a page.
#[derive(Debug, Serialize)]
#[serde(tag = "type", rename_all = "snake_case")]
pub(crate) enum Told<'a> {
    /// First of all.
    Hello {
        version: &'a str,
        /// Name of the file; null if there is none.
        file: Option<String>,
        templates: Vec<Given>,
        /// Strokes to begin with.
        strokes: strokes::Example,
    },
    /// The token was right. What the file holds: its text, and the problem or what is wrong with it.
    File { text: Option<String>, problem: Option<&'a Description>, error: Option<Wrong> },
    /// A problem as it was understood, or what is wrong with it.
    Checked {
        id: u64,
        /// The problem as TOML; null if it is no problem file.
        toml: Option<String>,
        understood: Option<Understood>,
        answer: Option<&'a check::Answer>,
        notes: Vec<Wrong>,
        error: Option<Wrong>,
    },
    /// The text as a problem, or what is wrong with it.
    Read { id: u64, problem: Option<&'a Description>, error: Option<Wrong> },
    /// The problem that a drawing shows and what is to be said of it, or why it shows none.
    Drawn { id: u64, problem: Option<&'a Description>, notes: Vec<String>, error: Option<Wrong> },
    /// A problem as a drawing, DXF.
    Drawing { id: u64, dxf: Option<String>, error: Option<Wrong> },
    /// A run began.
    Begun { id: u64 },
    /// More is proven.
    Proven {
        id: u64,
        seconds: f64,
        #[serde(flatten)]
        proven: Proven,
    },
    /// How many cases are done.
    Cases { id: u64, done: u64, of: u64 },
    /// The run ended with bounds.
    Solved { id: u64, answer: &'a Answer, field: Option<Shown> },
    /// The run ended without.
    Failed { id: u64, error: Wrong },
    /// The file was written.
    #[cfg(not(target_family = "wasm"))]
    Saved { id: u64, name: String },
    /// The file was not written.
    NotSaved {
        id: u64,
        error: Wrong,
        /// Whether it holds what the page has not read, so that the page must ask.
        changed: bool,
    },
    /// What proves the bounds that were found last; no files where there are none.
    Certificate { id: u64, files: Vec<Certificate>, error: Option<Wrong> },
    /// The calculation of what was found last, as a page.
    Report { id: u64, html: Option<String>, error: Option<Wrong> },
    /// What is found along a line, or why nothing is.
    Probed { id: u64, shown: Option<probe::Shown>, error: Option<Wrong> },
    /// What a saved solution proves, or why it is none; with the hash of its bytes.
    Certified { id: u64, sha256: String, answer: Option<certify::Answer>, error: Option<Wrong> },
    /// Forces of a plate in a soil, or why there are none.
    Plate { id: u64, shown: Option<plate::Shown>, error: Option<Wrong> },
    /// What strokes say of their soil, or what is wrong with their table.
    Strokes { id: u64, shown: Option<Box<strokes::Shown>>, error: Option<Wrong> },
    /// Which stroke would shrink the region most, the best first.
    Next { id: u64, strokes: Option<Vec<NextStroke>>, error: Option<Wrong> },
    /// A message was refused.
    Error { error: Wrong },
}

/// A saved solution.
#[derive(Debug, Serialize)]
pub(crate) struct Certificate {
    /// Which bound it proves, where each has a file of its own.
    pub(crate) part: Option<&'static str>,
    pub(crate) sha256: String,
    pub(crate) text: String,
}

impl Told<'_> {
    /// Says that a message was refused.
    pub(crate) fn refusal(words: &str) -> String {
        Self::Error { error: Wrong::words(words) }.text()
    }

    /// As it is sent.
    pub(crate) fn text(&self) -> String {
        serde_json::to_string(self)
            .unwrap_or_else(|problem| format!("{{\"type\":\"error\",\"error\":{{\"words\":\"{problem}\"}}}}"))
    }
}

/// A problem in JSON form.
pub(crate) fn problem(value: Value) -> Result<Description, Wrong> {
    serde_json::from_value(value).map_err(|problem| Wrong::words(format!("this is no problem: {problem}")))
}
