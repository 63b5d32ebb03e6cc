//! What is answered about a log.

use std::collections::BTreeMap;
use std::path::Path;

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_session::{Info, Recovery};

use crate::Outcome;

/// What a log holds, or what was made of it.
#[derive(Debug, Default, Serialize, JsonSchema)]
pub struct Answer {
    /// `info`, `doctor`, `recover` or `export`.
    pub action: &'static str,
    /// Whether the file is whole and its checksums hold.
    pub whole: bool,
    /// What is wrong with the file; empty if it is whole.
    pub damage: Vec<String>,
    /// What is wrong with the content; only `doctor` fills it.
    pub problems: Vec<String>,
    /// What is in the log; of `recover`, in the new one. Null for `export`.
    pub content: Option<Content>,
    /// What was written; null for `info` and `doctor`.
    pub written: Option<Written>,
}

/// What is in a log.
#[derive(Debug, Default, Serialize, JsonSchema)]
pub struct Content {
    /// Log time of the first message in s, of a recording of another program the earliest time on its clock; null if there is none.
    pub start_s: Option<f64>,
    /// Log time of the last message in s, or the latest time.
    pub end_s: Option<f64>,
    /// Steps of the controller.
    pub steps: u64,
    /// Steps that are missing between them.
    pub missing_steps: u64,
    /// Key frames, from which a replay can begin.
    pub keyframes: u64,
    /// What made the log, as the log says: version, seed, model.
    pub session: BTreeMap<String, String>,
    /// Boundaries and settings of the strokes, as the log says.
    pub strokes: Vec<BTreeMap<String, String>>,
    /// Topics.
    pub topics: Vec<Topic>,
    /// Names of the attachments.
    pub attachments: Vec<String>,
    /// What else was found; only of recordings of other programs.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub found: Option<Found>,
}

/// What else was found in a recording of another program.
#[derive(Debug, Default, Serialize, JsonSchema)]
pub struct Found {
    /// What it is kept in, such as `MCAP` or `ROS 1 bag`.
    pub container: String,
    /// Compressions of its chunks, messages or file; empty if nothing is compressed.
    pub compression: Vec<String>,
    /// Where the times of this answer begin, in s of the stamps: a whole second of a wall clock, or 0. It is the clock of
    /// `process --strokes`.
    pub clock_origin_s: i64,
    /// From the earliest to the latest time in s.
    pub duration_s: f64,
    /// Whether there is a URDF in it.
    pub has_urdf: bool,
    /// What wrote it, as it says; may be empty.
    pub library: String,
    /// What is odd about the messages of joint states and wrenches, such as clocks that were set.
    pub oddities: Vec<String>,
    /// Numbers that cannot be in the units of ROS.
    pub implausible: Vec<String>,
}

/// A topic.
#[derive(Debug, Default, Serialize, JsonSchema)]
pub struct Topic {
    /// Its name.
    pub topic: String,
    /// Type of its messages.
    #[serde(rename = "type")]
    pub message_type: String,
    /// How many there are.
    pub messages: u64,
    /// What they tell: `joints`, `wrench`, `text` or `points`, if one of these. This and what follows is there only of recordings of other
    /// programs.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub kind: Option<&'static str>,
    /// Earliest time in s.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub start_s: Option<f64>,
    /// Latest time in s.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub end_s: Option<f64>,
    /// Messages a second, by the median of the times between two; missing for fewer than three of these.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rate_hz: Option<f64>,
    /// Times between two messages that are longer than five medians.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gaps: Option<u64>,
    /// The longest of them, ten at most, in order of time.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub longest_gaps: Option<Vec<Gap>>,
    /// Why the messages cannot be read, if they cannot.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub problem: Option<String>,
}

/// A time without messages.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct Gap {
    /// Time of the message before it in s.
    pub from_s: f64,
    /// Time of the message after it in s.
    pub to_s: f64,
}

/// What was written.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Written {
    /// The file.
    pub file: String,
    /// The exported topic; null for `recover`.
    pub topic: Option<String>,
    /// Messages, or rows of the table.
    pub rows: u64,
    /// Columns of the table; null for `recover`.
    pub columns: Option<usize>,
    /// Where `time_s` begins, in s of the stamps; only of recordings of other programs.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub clock_origin_s: Option<i64>,
}

impl Answer {
    pub(super) fn info(info: Info) -> Self {
        Self { problems: Vec::new(), ..Self::doctor(info).called("info") }
    }

    pub(super) fn doctor(info: Info) -> Self {
        Self {
            action: "doctor",
            whole: info.ending.is_whole(),
            damage: info.ending.damage.clone(),
            problems: info.problems.clone(),
            content: Some(Content::new(info)),
            written: None,
        }
    }

    pub(super) fn recover(new: Info, saved: Recovery, out: &Path) -> Self {
        let file = out.display().to_string();
        Self {
            action: "recover",
            whole: saved.ending.is_whole(),
            damage: saved.ending.damage,
            problems: Vec::new(),
            content: Some(Content::new(new)),
            written: Some(Written {
                file,
                topic: None,
                rows: saved.messages,
                columns: None,
                clock_origin_s: None,
            }),
        }
    }

    /// A table of the messages of a topic.
    pub(super) fn exported(damage: Vec<String>, written: Written) -> Self {
        let whole = damage.is_empty();
        Self { action: "export", whole, damage, written: Some(written), ..Self::default() }
    }

    fn called(self, action: &'static str) -> Self {
        Self { action, ..self }
    }

    /// Whether the file is whole and nothing is wrong with its content.
    #[must_use]
    pub fn is_well(&self) -> bool {
        self.whole && self.problems.is_empty()
    }
}

impl crate::Answer for Answer {
    const SCHEMA: &'static str = "soilctl.log/1";

    fn outcome(&self) -> Outcome {
        match (self.whole, self.problems.is_empty()) {
            (false, _) => Outcome::Partial,
            (true, false) => Outcome::Negative,
            (true, true) => Outcome::Done,
        }
    }
}

impl Content {
    fn new(info: Info) -> Self {
        #[allow(clippy::cast_precision_loss, reason = "exact to a tick for 285 years")]
        let seconds = |time_ns: u64| time_ns as f64 / 1e9;
        let topics = info.topics.into_iter().map(|(topic, found)| Topic {
            topic,
            message_type: found.message_type,
            messages: found.messages,
            ..Topic::default()
        });
        Self {
            start_s: info.start_ns.map(seconds),
            end_s: info.end_ns.map(seconds),
            steps: info.steps,
            missing_steps: info.missing_steps,
            keyframes: info.keyframes,
            session: info.session,
            strokes: info.strokes,
            topics: topics.collect(),
            attachments: info.attachments,
            found: None,
        }
    }
}
