//! What the trace of a stroke tells beside its failure force: columns that the table lacks, and readings phase by phase.

mod course;
mod derive;
mod phase;
mod recorded;
mod step;

use std::collections::BTreeMap;

pub use course::{Course, courses, typical_course};
pub use recorded::{AddedTraces, RecordedTraces};
use soilctl_effects::Channel;
use soilctl_strokes::{StrokeRow, TraceTable};

/// A part of a stroke.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Phase {
    /// From a tenth of the failure force to failure.
    Loading,
    /// Up to half a depth after failure.
    After,
}

impl Phase {
    /// As answers have it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Loading => "loading",
            Self::After => "after",
        }
    }

    /// In words, for people.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::Loading => "while the force rises",
            Self::After => "after failure",
        }
    }
}

/// A reading in a phase of each stroke: the column it belongs to, and when.
pub(crate) type PhaseKey = (&'static str, Phase);

/// What traces say, by stroke of the table; `None` where a stroke has no trace or the trace does not show it.
#[derive(Debug, Clone, Default)]
pub(crate) struct Traced {
    pub(crate) channels: BTreeMap<Channel, Vec<Option<f64>>>,
    pub(crate) phases: BTreeMap<PhaseKey, Vec<Option<f64>>>,
    /// Strokes with a trace in which their failure was found.
    pub(crate) used: usize,
}

/// Reads the traces of all strokes; `failure_time_s` says, by stroke, when the soil failed on the clock of the traces,
/// where that is known.
pub(crate) fn traced(rows: &[StrokeRow], traces: &TraceTable, failure_time_s: &[Option<f64>]) -> Traced {
    let mut found = Traced::default();
    for (i, row) in rows.iter().enumerate() {
        let samples = row.stroke_id.as_deref().and_then(|id| traces.get(id));
        let time_s = failure_time_s.get(i).copied().flatten();
        let Some(parts) = samples.and_then(|samples| phase::Parts::of(samples, row, time_s)) else {
            continue;
        };
        found.used += 1;
        let empty = || vec![None; rows.len()];
        for (channel, value) in derive::channels(&parts, row) {
            found.channels.entry(channel).or_insert_with(empty)[i] = Some(value);
        }
        for (key, value) in derive::phases(&parts) {
            found.phases.entry(key).or_insert_with(empty)[i] = Some(value);
        }
    }
    found
}
