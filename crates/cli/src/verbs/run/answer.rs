use std::fmt::Write;
use std::path::Path;

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_controller::TICK_S;
use soilctl_live::{BIN_ENDS_US, Report, Timing};
use soilctl_session::messages::word;

use crate::output::Words;

/// How a session went.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct RunAnswer {
    /// Why it ended.
    ended: String,
    /// Ticks.
    ticks: u64,
    /// Their time in s.
    time_s: f64,
    /// The fault in which it ended; null if in none.
    fault: Option<String>,
    /// The log.
    log: String,
    /// Steps in the log; null if it could not be written to its end.
    log_steps: Option<u64>,
    /// Steps that are not in the log, because the disk was too slow.
    log_dropped_steps: Option<u64>,
    /// How well it kept time; null if not in real time.
    timing: Option<Timing>,
    /// Upper ends of the bins of the histograms in microseconds; the last bin has none.
    bin_ends_us: [u32; BIN_ENDS_US.len()],
    /// Operators that connected.
    clients: u64,
    /// Messages that operators did not take in time.
    messages_dropped: u64,
    /// Lines of operators that were refused.
    lines_refused: u64,
    /// States that the server did not take in time.
    states_dropped: u64,
    /// Events that the server did not take in time.
    events_dropped: u64,
    /// Devices that connected to lead the plate by hand.
    devices: u64,
    /// Devices that were sent away: another one was there, or they sent what is no frame.
    devices_refused: u64,
    /// What went wrong; empty if nothing did.
    problems: Vec<String>,
}

impl RunAnswer {
    pub(super) fn new(report: &Report, log: &Path) -> Self {
        let mut problems = Vec::new();
        problems.extend(report.failed.as_ref().map(ToString::to_string));
        let written = report.log.as_ref();
        problems.extend(written.and_then(|log| log.as_ref().err()).map(ToString::to_string));
        let written = written.and_then(|log| log.as_ref().ok());
        if let Some(lost) = written.filter(|log| log.dropped_steps > 0) {
            problems.push(format!("{} steps are not in the log: the disk was too slow", lost.dropped_steps));
        }
        #[allow(clippy::cast_precision_loss, reason = "exact for 500 000 years")]
        let time_s = report.ticks as f64 * TICK_S;
        Self {
            ended: report.ending.words().to_owned(),
            ticks: report.ticks,
            time_s,
            fault: report.fault.map(|fault| word(&fault.fault)),
            log: log.display().to_string(),
            log_steps: written.map(|log| log.steps),
            log_dropped_steps: written.map(|log| log.dropped_steps),
            timing: report.timing,
            bin_ends_us: BIN_ENDS_US,
            clients: report.clients,
            messages_dropped: report.messages_dropped,
            lines_refused: report.lines_refused,
            states_dropped: report.states_dropped,
            events_dropped: report.events_dropped,
            devices: report.devices,
            devices_refused: report.devices_refused,
            problems,
        }
    }

    pub(super) fn problems(&self) -> &[String] {
        &self.problems
    }

    pub(super) const fn ended_in_fault(&self) -> bool {
        self.fault.is_some()
    }
}

impl soilctl_app::Answer for RunAnswer {
    const SCHEMA: &'static str = "soilctl.run/1";
}

impl Words for RunAnswer {
    fn text(&self) -> String {
        let mut text = format!("{} ticks ({:.3} s); {}\n", self.ticks, self.time_s, self.ended);
        if let Some(fault) = &self.fault {
            let _ = writeln!(text, "fault: {fault}");
        }
        let steps = self.log_steps.map_or("not complete".to_owned(), |steps| format!("{steps} steps"));
        let _ = writeln!(text, "log: {}, {steps}", self.log);
        if let Some(timing) = &self.timing {
            let _ = writeln!(text, "overruns: {} ({} ticks given up)", timing.overruns, timing.skipped);
            let _ = writeln!(text, "late by: {}", timing.lateness.words());
            let _ = writeln!(text, "busy for: {}", timing.busy.words());
        }
        let _ = writeln!(
            text,
            "operators: {}, {} messages not taken, {} lines refused; {} states and {} events dropped",
            self.clients, self.messages_dropped, self.lines_refused, self.states_dropped, self.events_dropped
        );
        for problem in &self.problems {
            let _ = writeln!(text, "problem: {problem}");
        }
        text
    }
}
