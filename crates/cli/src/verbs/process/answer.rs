use schemars::JsonSchema;
use serde::Serialize;
use soilctl_process::table::StrokeRecord;

use super::findings::Analysis;
use super::manifest::{Entry, Skipped};
use super::words;
use super::work::Done;
use crate::output::Words;

/// Strokes of logs.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct ProcessAnswer {
    /// Strokes with a failure force, in the order of the logs.
    pub(crate) strokes: Vec<StrokeRecord>,
    /// What became of each log.
    pub(crate) logs: Vec<LogOutcome>,
    /// Logs that were taken over from an earlier run, since they are as they were.
    pub(crate) reused: usize,
    /// Whether the work was stopped before the last log.
    pub(crate) stopped: bool,
    /// What the strokes say together.
    pub(crate) analysis: Analysis,
    /// Files that were written.
    pub(crate) written: Vec<String>,
}

/// What became of a log.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct LogOutcome {
    /// The file.
    pub(crate) log: String,
    /// `done` or `failed`.
    pub(crate) status: &'static str,
    /// Why nothing could be made of it; null if something could.
    pub(crate) error: Option<String>,
    /// Whether soilctl wrote it.
    pub(crate) own: bool,
    /// Strokes with a failure force.
    pub(crate) strokes: usize,
    /// What gave none, and why.
    pub(crate) skipped: Vec<Skipped>,
    /// Damaged parts, which were left out.
    pub(crate) damage: Vec<String>,
    /// Messages that could not be used.
    pub(crate) unusable: Vec<String>,
}

impl LogOutcome {
    fn of(entry: &Entry) -> Self {
        Self {
            log: entry.log.clone(),
            status: if entry.error.is_some() { "failed" } else { "done" },
            error: entry.error.clone(),
            own: entry.own,
            strokes: entry.strokes.len(),
            skipped: entry.skipped.clone(),
            damage: entry.damage.clone(),
            unusable: entry.unusable.clone(),
        }
    }
}

impl ProcessAnswer {
    pub(super) fn new(done: &Done, analysis: Analysis, written: Vec<String>) -> Self {
        Self {
            strokes: done.strokes(),
            logs: done.entries.values().map(LogOutcome::of).collect(),
            reused: done.reused,
            stopped: done.stopped,
            analysis,
            written,
        }
    }

    /// Why no log can be used, unless it was `told` of each of them already.
    pub(super) fn failure(&self, told: bool) -> String {
        let first = self.logs.iter().find_map(|log| Some(bad_log(&log.log, log.error.as_ref()?)));
        match (first, self.logs.len()) {
            (Some(reason), 1) => reason,
            (Some(reason), logs) if !told => format!("none of {logs} logs can be used; the first: {reason}"),
            (_, logs) => format!("none of {logs} logs can be used"),
        }
    }
}

impl soilctl_app::Answer for ProcessAnswer {
    const SCHEMA: &'static str = "soilctl.process/1";
}

impl Words for ProcessAnswer {
    fn text(&self) -> String {
        words::text(self)
    }
}

/// What is wrong with a log, with its name once.
pub(super) fn bad_log(log: &str, problem: &str) -> String {
    if problem.starts_with(log) { problem.to_owned() } else { format!("{log}: {problem}") }
}
