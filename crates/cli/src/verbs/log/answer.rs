use std::collections::BTreeMap;
use std::path::Path;

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_session::{Export, Info, Recovery};

use crate::output::Answer;
use crate::text::{columns, number};

/// What a log holds, or what was made of it.
#[derive(Debug, Default, Serialize, JsonSchema)]
pub(crate) struct LogAnswer {
    /// `info`, `doctor`, `recover` or `export`.
    action: &'static str,
    /// Whether the file is whole and its checksums hold.
    whole: bool,
    /// What is wrong with the file; empty if it is whole.
    damage: Vec<String>,
    /// What is wrong with the content; only `doctor` fills it.
    problems: Vec<String>,
    /// What is in the log; of `recover`, in the new one. Null for `export`.
    content: Option<Content>,
    /// What was written; null for `info` and `doctor`.
    written: Option<Written>,
}

/// What is in a log.
#[derive(Debug, Serialize, JsonSchema)]
struct Content {
    /// Log time of the first message in s; null if there is none.
    start_s: Option<f64>,
    /// Log time of the last message in s.
    end_s: Option<f64>,
    /// Steps of the controller.
    steps: u64,
    /// Steps that are missing between them.
    missing_steps: u64,
    /// Key frames, from which a replay can begin.
    keyframes: u64,
    /// What made the log, as the log says: version, seed, model.
    session: BTreeMap<String, String>,
    /// Boundaries and settings of the strokes, as the log says.
    strokes: Vec<BTreeMap<String, String>>,
    /// Topics.
    topics: Vec<Topic>,
    /// Names of the attachments.
    attachments: Vec<String>,
}

/// A topic.
#[derive(Debug, Serialize, JsonSchema)]
struct Topic {
    /// Its name.
    topic: String,
    /// Type of its messages.
    #[serde(rename = "type")]
    message_type: String,
    /// How many there are.
    messages: u64,
}

/// What was written.
#[derive(Debug, Serialize, JsonSchema)]
struct Written {
    /// The file.
    file: String,
    /// The exported topic; null for `recover`.
    topic: Option<String>,
    /// Messages, or rows of the table.
    rows: u64,
    /// Columns of the table; null for `recover`.
    columns: Option<usize>,
}

impl LogAnswer {
    pub(crate) fn info(info: Info) -> Self {
        Self { problems: Vec::new(), ..Self::doctor(info).called("info") }
    }

    pub(crate) fn doctor(info: Info) -> Self {
        Self {
            action: "doctor",
            whole: info.ending.is_whole(),
            damage: info.ending.damage.clone(),
            problems: info.problems.clone(),
            content: Some(Content::new(info)),
            written: None,
        }
    }

    pub(crate) fn recover(new: Info, saved: Recovery, out: &Path) -> Self {
        let file = out.display().to_string();
        Self {
            action: "recover",
            whole: saved.ending.is_whole(),
            damage: saved.ending.damage,
            problems: Vec::new(),
            content: Some(Content::new(new)),
            written: Some(Written { file, topic: None, rows: saved.messages, columns: None }),
        }
    }

    pub(crate) fn export(table: Export, topic: &str, out: &Path) -> Self {
        Self {
            action: "export",
            whole: table.ending.is_whole(),
            damage: table.ending.damage,
            written: Some(Written {
                file: out.display().to_string(),
                topic: Some(topic.to_owned()),
                rows: table.rows,
                columns: Some(table.columns),
            }),
            ..Self::default()
        }
    }

    fn called(self, action: &'static str) -> Self {
        Self { action, ..self }
    }

    pub(crate) fn is_whole(&self) -> bool {
        self.whole
    }

    pub(crate) fn is_well(&self) -> bool {
        self.whole && self.problems.is_empty()
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
        }
    }

    fn text(&self) -> String {
        let mut text = String::new();
        for (key, value) in &self.session {
            text += &format!("{key}: {value}\n");
        }
        if let (Some(start), Some(end)) = (self.start_s, self.end_s) {
            text += &format!("time: {} to {} s\n", number(start), number(end));
        }
        text += &format!(
            "steps: {}, {} missing, {} key frames\n",
            self.steps, self.missing_steps, self.keyframes
        );
        let rows = self
            .topics
            .iter()
            .map(|topic| vec![topic.messages.to_string(), topic.topic.clone(), topic.message_type.clone()]);
        text += &columns(&rows.collect::<Vec<_>>());
        for stroke in &self.strokes {
            let words: Vec<String> = stroke.iter().map(|(key, value)| format!("{key} {value}")).collect();
            text += &format!("stroke: {}\n", words.join(", "));
        }
        for name in &self.attachments {
            text += &format!("attachment: {name}\n");
        }
        text
    }
}

impl Answer for LogAnswer {
    const SCHEMA: &'static str = "soilctl.log/1";

    fn text(&self) -> String {
        let mut text = self.content.as_ref().map_or_else(String::new, Content::text);
        if let Some(written) = &self.written {
            let what = match (&written.topic, written.columns) {
                (Some(topic), Some(columns)) => {
                    format!("{} rows, {columns} columns of {topic}", written.rows)
                }
                _ => format!("{} messages", written.rows),
            };
            text += &format!("written: {}, {what}\n", written.file);
        }
        for damage in &self.damage {
            text += &format!("damaged: {damage}\n");
        }
        for problem in &self.problems {
            text += &format!("problem: {problem}\n");
        }
        if self.action == "doctor" && self.is_well() {
            text += "the log is well\n";
        }
        text
    }
}
