use std::collections::BTreeMap;
use std::path::Path;
use std::sync::atomic::AtomicBool;

use crate::messages::{ControllerStep, Keyframe, definition};
use crate::read::{Ending, Item, RawMessage, scan_until};
use crate::setup::{CONFIGURATION_RECORD, END_RECORD, SESSION_RECORD, STROKE_RECORD};
use crate::write::{MESSAGE_ENCODING, PROFILE, SCHEMA_ENCODING, URDF_NAME};
use crate::{SessionError, cdr, topics};

/// What is in a log.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Info {
    /// Messages by topic.
    pub topics: BTreeMap<String, TopicInfo>,
    /// Log time of the first message in ns.
    pub start_ns: Option<u64>,
    /// Log time of the last message in ns.
    pub end_ns: Option<u64>,
    /// Steps of the controller.
    pub steps: u64,
    /// Key frames.
    pub keyframes: u64,
    /// Steps that the numbers of the steps leave out.
    pub missing_steps: u64,
    /// The record of what made the log, by key; empty for a log of another program.
    pub session: BTreeMap<String, String>,
    /// The records of the strokes, by key.
    pub strokes: Vec<BTreeMap<String, String>>,
    /// Names of the attachments.
    pub attachments: Vec<String>,
    /// What is wrong with the content of the log, though the file may be whole.
    pub problems: Vec<String>,
    /// How the reading of the file ended.
    pub ending: Ending,
}

/// Messages of one topic.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct TopicInfo {
    /// Their type.
    pub message_type: String,
    /// How many there are.
    pub messages: u64,
}

/// Reads a whole log, counts what is in it and checks what can be checked without running the controller.
///
/// # Errors
/// Those of [`scan`](crate::read::scan); damage and odd content are part of the answer.
pub fn info(path: &Path) -> Result<Info, SessionError> {
    info_until(path, &AtomicBool::new(false))
}

/// [`info`] that ends when `stop` is set.
///
/// # Errors
/// [`SessionError::Stopped`], and those of [`info`].
pub fn info_until(path: &Path, stop: &AtomicBool) -> Result<Info, SessionError> {
    let mut check = Check::default();
    let ending = scan_until(path, stop, &mut |item| {
        check.item(item);
        Ok(())
    })?;
    let mut info = check.finish();
    info.ending = ending;
    Ok(info)
}

#[derive(Default)]
struct Check {
    info: Info,
    next_step: Option<u64>,
    last_ns: u64,
    ended: bool,
    configured: bool,
}

impl Check {
    fn item(&mut self, item: Item<'_>) {
        match item {
            Item::Header { profile, .. } if profile != PROFILE => {
                self.problem(format!("the profile is `{profile}`, not `{PROFILE}`"));
            }
            Item::Header { .. } => {}
            Item::Attachment { name, .. } => self.info.attachments.push(name.to_owned()),
            Item::Metadata { name, content } => match name {
                SESSION_RECORD => self.info.session.clone_from(content),
                CONFIGURATION_RECORD => self.configured = true,
                STROKE_RECORD => self.info.strokes.push(content.clone()),
                END_RECORD => self.ended = true,
                _ => {}
            },
            Item::Message(message) => self.message(&message),
        }
    }

    fn message(&mut self, message: &RawMessage<'_>) {
        let topic = &message.channel.topic;
        if !self.info.topics.contains_key(topic) {
            self.channel(message);
            let message_type = message.channel.message_type.clone();
            self.info.topics.insert(topic.clone(), TopicInfo { message_type, messages: 0 });
        }
        let time = message.log_time_ns;
        self.info.start_ns = Some(self.info.start_ns.map_or(time, |start| start.min(time)));
        self.info.end_ns = Some(self.info.end_ns.map_or(time, |end| end.max(time)));
        if time < self.last_ns {
            self.problem("log times do not rise".to_owned());
        }
        self.last_ns = time;
        match topic.as_str() {
            topics::STEP => self.step(message),
            topics::KEYFRAME => {
                self.info.keyframes += 1;
                let state = cdr::decode::<Keyframe>(message.data)
                    .and_then(|frame| frame.state().map_err(|error| error.to_string()));
                if let Err(reason) = state {
                    self.problem(format!("key frame {}: {reason}", self.info.keyframes - 1));
                }
            }
            _ => {}
        }
        if let Some(info) = self.info.topics.get_mut(topic) {
            info.messages += 1;
        }
    }

    fn step(&mut self, message: &RawMessage<'_>) {
        match cdr::decode::<ControllerStep>(message.data) {
            Ok(step) => {
                if let Some(missing) = self.next_step.and_then(|next| step.step.checked_sub(next)) {
                    self.info.missing_steps += missing;
                } else if self.next_step.is_some() {
                    self.problem(format!("step {} comes late", step.step));
                }
                self.next_step = Some(step.step.saturating_add(1));
            }
            Err(reason) => self.problem(format!("step {}: {reason}", self.info.steps)),
        }
        self.info.steps += 1;
    }

    fn channel(&mut self, message: &RawMessage<'_>) {
        let channel = message.channel;
        let topic = &channel.topic;
        if channel.message_encoding != MESSAGE_ENCODING || channel.schema_encoding != SCHEMA_ENCODING {
            let (encoding, schema) = (&channel.message_encoding, &channel.schema_encoding);
            self.problem(format!(
                "{topic} is encoded as `{encoding}` with a schema in `{schema}`, not as \
                `{MESSAGE_ENCODING}` in `{SCHEMA_ENCODING}`"
            ));
        }
        if !channel.metadata.contains_key("offered_qos_profiles") {
            self.problem(format!("{topic} has no offered_qos_profiles"));
        }
        let known = topics::ALL.iter().find(|known| known.name == topic);
        if let Some(known) = known {
            let ours = definition(known.message_type).unwrap_or_default();
            if channel.message_type != known.message_type || channel.schema != ours.as_bytes() {
                self.problem(format!("{topic} is not of the type {} of this program", known.message_type));
            }
        }
    }

    fn problem(&mut self, problem: String) {
        const MOST: usize = 100;
        if self.info.problems.len() < MOST && !self.info.problems.contains(&problem) {
            self.info.problems.push(problem);
        }
    }

    fn finish(mut self) -> Info {
        if self.info.session.is_empty() {
            self.problem(format!(
                "there is no metadata record {SESSION_RECORD}: soilctl did not write this log"
            ));
        } else {
            if !self.configured {
                self.problem(format!("there is no metadata record {CONFIGURATION_RECORD}"));
            }
            if !self.ended {
                self.problem(format!("there is no metadata record {END_RECORD}: the run did not end well"));
            }
            if !self.info.attachments.iter().any(|name| name == URDF_NAME) {
                self.problem(format!("there is no attachment {URDF_NAME}"));
            }
            if self.info.keyframes == 0 {
                self.problem("there is no key frame, so nothing can be replayed".to_owned());
            }
        }
        if self.info.missing_steps > 0 {
            self.problem(format!("{} steps are missing", self.info.missing_steps));
        }
        self.info
    }
}
