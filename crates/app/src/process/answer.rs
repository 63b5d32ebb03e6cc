//! What is answered of logs.

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_process::table::StrokeRecord;

use super::findings::Analysis;
use super::manifest::{Entry, Found, Skipped, bad_log};
use super::scans::Scan;
use super::work::Done;
use crate::{AppError, Outcome};

/// Strokes of logs.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Answer {
    /// Strokes with a failure force, in the order of the logs.
    pub strokes: Vec<StrokeRecord>,
    /// What became of each log.
    pub logs: Vec<LogOutcome>,
    /// Logs that were taken over from an earlier run, since they are as they were.
    pub reused: usize,
    /// Whether the work was stopped before the last log.
    pub stopped: bool,
    /// What the strokes say together.
    pub analysis: Analysis,
    /// Files that were written.
    pub written: Vec<String>,
    /// Whether only a share of the logs was read.
    #[serde(skip)]
    pub(super) is_share: bool,
}

/// What became of a log.
#[derive(Debug, Serialize, JsonSchema)]
pub struct LogOutcome {
    /// The file.
    pub log: String,
    /// What its strokes are named after.
    #[serde(skip)]
    pub name: String,
    /// `done` or `failed`.
    pub status: &'static str,
    /// Why nothing could be made of it; null if something could.
    pub error: Option<String>,
    /// Whether soilctl wrote it.
    pub own: bool,
    /// Strokes with a failure force.
    pub strokes: usize,
    /// What gave none, and why.
    pub skipped: Vec<Skipped>,
    /// Damaged parts, which were left out.
    pub damage: Vec<String>,
    /// Messages that could not be used, or whose times had to be mended.
    pub unusable: Vec<String>,
    /// What else was found in a log of another program; null for a log of soilctl.
    pub found: Option<Found>,
    /// What clouds of points before and after each stroke say of where the ground broke; empty if there are none.
    pub scans: Vec<Scan>,
    /// Whether data that matter are missing: a stroke could not be weighed, or has a gap where the force rises, or clouds that were asked for
    /// cannot be used.
    pub is_partial: bool,
}

impl LogOutcome {
    fn of(entry: Entry) -> Self {
        Self {
            log: entry.log,
            name: entry.name,
            status: if entry.error.is_some() { "failed" } else { "done" },
            error: entry.error,
            own: entry.own,
            strokes: entry.strokes.len(),
            skipped: entry.skipped,
            damage: entry.damage,
            unusable: entry.unusable,
            found: entry.found,
            scans: entry.scans,
            is_partial: entry.is_partial,
        }
    }
}

impl Answer {
    pub(super) fn new(
        done: Done,
        strokes: Vec<StrokeRecord>,
        analysis: Analysis,
        written: Vec<String>,
        is_share: bool,
    ) -> Self {
        let Done { entries, reused, stopped } = done;
        let logs = entries.into_values().map(LogOutcome::of).collect();
        Self { strokes, logs, reused, stopped, analysis, written, is_share }
    }

    /// Whether something was left out: the work was stopped, or a log is bad or damaged.
    #[must_use]
    pub fn is_partial(&self) -> bool {
        let lost = |log: &LogOutcome| log.error.is_some() || !log.damage.is_empty() || log.is_partial;
        self.stopped || self.logs.iter().any(lost)
    }

    /// Why no log can be used; `None` if one can, or if the work was stopped before the last.
    pub(super) fn refusal(&self) -> Option<AppError> {
        let mut problems = self.logs.iter().map(|log| Some(bad_log(&log.log, log.error.as_ref()?)));
        let first = problems.next()??;
        if self.stopped || problems.any(|problem| problem.is_none()) {
            return None;
        }
        Some(match self.logs.len() {
            1 => AppError::Request(first),
            logs => AppError::NoLog { logs, first },
        })
    }
}

impl crate::Answer for Answer {
    const SCHEMA: &'static str = "soilctl.process/1";

    fn outcome(&self) -> Outcome {
        match () {
            () if self.is_partial() => Outcome::Partial,
            // A share without a stroke says nothing of the whole.
            () if self.strokes.is_empty() && !self.is_share => Outcome::Negative,
            () => Outcome::Done,
        }
    }
}
