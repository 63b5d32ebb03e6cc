//! What an operator asks for to get one batch done.

use soilctl_controller::{EventKind, Mode, Outputs, Request, SequenceId, State};

/// Ticks that one stroke, or homing, may take with everything around it: 4 minutes.
const MOST_TICKS: u64 = 120_000;
/// Ticks with the amplifiers off at the end, so that the log shows the arm at rest.
const LAST_TICKS: u64 = 250;

/// What is asked for next, or waited for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Stage {
    Enable,
    StartHoming,
    Homing { until: u64 },
    ChooseStroke,
    StartStrokes,
    Strokes { until: u64 },
    Reset,
    Abort,
    Disable,
    Rest { until: u64 },
    Done,
}

/// The requests of one batch: enable, home if wanted, all its strokes, disable.
///
/// A stroke that fails is noted and left; the next one begins above the soil. After a fault the arm is reset first. A
/// second failure without a stroke in between ends the batch.
#[derive(Debug, Clone)]
pub(crate) struct Script {
    stage: Stage,
    to_home: bool,
    next: usize,
    end: usize,
    /// Strokes that were made to their end.
    pub(crate) done: usize,
    /// Why strokes failed, in words.
    pub(crate) failures: Vec<String>,
    failed_in_a_row: u32,
    tick: u64,
}

impl Script {
    /// The strokes `from..end` of the plan.
    pub(crate) const fn new(from: usize, end: usize, homing: bool) -> Self {
        Self {
            stage: Stage::Enable,
            to_home: homing,
            next: from,
            end,
            done: 0,
            failures: Vec::new(),
            failed_in_a_row: 0,
            tick: 0,
        }
    }

    /// Whether there is nothing more to do.
    pub(crate) fn is_done(&self) -> bool {
        self.stage == Stage::Done
    }

    /// Number of the stroke in the plan that is being made or comes next.
    pub(crate) const fn stroke(&self) -> usize {
        self.next
    }

    /// The request of the next tick.
    pub(crate) fn request(&mut self) -> Option<Request> {
        self.tick += 1;
        let (next, request) = match self.stage {
            Stage::Enable if self.to_home => (Stage::StartHoming, Request::Enable),
            Stage::Enable => (Stage::ChooseStroke, Request::Enable),
            Stage::StartHoming => {
                self.to_home = false;
                (Stage::Homing { until: self.tick + MOST_TICKS }, Request::Start(SequenceId::Homing))
            }
            Stage::ChooseStroke => {
                // A plan has at most 1024 strokes.
                let stroke = u16::try_from(self.next).unwrap_or(u16::MAX);
                (Stage::StartStrokes, Request::PlanIndex(stroke))
            }
            Stage::StartStrokes => {
                (Stage::Strokes { until: self.tick + MOST_TICKS }, Request::Start(SequenceId::Campaign))
            }
            Stage::Reset => (Stage::Enable, Request::Reset),
            Stage::Abort => (Stage::Disable, Request::Abort),
            Stage::Disable => (Stage::Rest { until: self.tick + LAST_TICKS }, Request::Disable),
            Stage::Homing { .. } | Stage::Strokes { .. } | Stage::Rest { .. } | Stage::Done => return None,
        };
        self.stage = next;
        Some(request)
    }

    /// What the tick has brought.
    pub(crate) fn note(&mut self, outputs: &Outputs, state: &State) {
        let has = |kind| outputs.events.as_slice().iter().any(|event| event.kind == kind);
        match self.stage {
            Stage::Homing { until } => {
                if has(EventKind::SequenceSucceeded(SequenceId::Homing)) {
                    self.stage = Stage::ChooseStroke;
                } else if let Some(why) = self.trouble(outputs, state, SequenceId::Homing, until) {
                    self.failures.push(format!("homing: {why}"));
                    self.stage = self.end(state);
                }
            }
            Stage::Strokes { until } => {
                if has(EventKind::SequenceSucceeded(SequenceId::InsertStrokePullout)) {
                    self.done += 1;
                    self.next += 1;
                    self.failed_in_a_row = 0;
                    self.stage = if self.next < self.end {
                        Stage::Strokes { until: self.tick + MOST_TICKS }
                    } else {
                        Stage::Abort
                    };
                } else if let Some(why) = self.trouble(outputs, state, SequenceId::Campaign, until) {
                    self.failures.push(format!("stroke {}: {why}", self.next + 1));
                    self.next += 1;
                    self.failed_in_a_row += 1;
                    let goes_on = self.next < self.end && self.failed_in_a_row < 2;
                    self.stage = match (goes_on, state.mode) {
                        (false, _) => self.end(state),
                        (true, Mode::Ready) => Stage::ChooseStroke,
                        (true, _) => Stage::Reset,
                    };
                }
            }
            Stage::Rest { until } if self.tick >= until => self.stage = Stage::Done,
            _ => {}
        }
    }

    fn end(&self, state: &State) -> Stage {
        if state.mode == Mode::Ready { Stage::Abort } else { Stage::Rest { until: self.tick + LAST_TICKS } }
    }

    fn trouble(&self, outputs: &Outputs, state: &State, sequence: SequenceId, until: u64) -> Option<String> {
        let failed = EventKind::SequenceFailed(sequence);
        if let Some(record) = state.fault {
            return Some(format!(
                "fault {:?}: {} against a limit of {}",
                record.fault, record.value, record.limit
            ));
        }
        if outputs.events.as_slice().iter().any(|event| event.kind == failed) {
            return Some("the sequence gave up".to_owned());
        }
        (self.tick > until).then(|| "it took too long".to_owned())
    }
}
