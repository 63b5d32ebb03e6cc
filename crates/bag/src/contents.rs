use std::collections::BTreeMap;
use std::path::Path;
use std::sync::atomic::AtomicBool;

use soilctl_session::read::{Ending, Item, RawMessage};

use crate::{BagError, Kind, Readers, Reading, scan_until};

/// What is in a recording. What stands below `/truth` is left out: it is known of a simulated soil only, and nothing may be found with
/// its help.
#[derive(Debug, Default)]
pub struct Contents {
    /// Topics that have messages, by name.
    pub topics: BTreeMap<String, Topic>,
    /// The first URDF: of a text on a topic such as `/robot_description`, or attached.
    pub urdf: Option<String>,
    /// Names of the attachments.
    pub attachments: Vec<String>,
    /// The profile of the file, `ros1` or `ros2` for most; empty if it does not say.
    pub profile: String,
    /// What wrote the file, if it says.
    pub library: String,
    /// How the reading ended; [`contents`] fills it in.
    pub ending: Ending,
    readers: Readers,
}

/// Messages of a topic.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Topic {
    /// Their type.
    pub message_type: String,
    /// How they are encoded.
    pub message_encoding: String,
    /// What they tell, if it is of a kind.
    pub kind: Option<Kind>,
    /// Why they cannot be read, if they cannot.
    pub problem: Option<String>,
    /// How many there are.
    pub messages: u64,
    /// The earliest log time in ns.
    pub first_ns: u64,
    /// The latest log time in ns.
    pub last_ns: u64,
}

/// Looks through a whole recording once.
///
/// # Errors
/// Those of [`scan`](crate::scan); damage is part of the answer.
pub fn contents(path: &Path) -> Result<Contents, BagError> {
    contents_until(path, &AtomicBool::new(false))
}

/// [`contents`] that ends when `stop` is set.
///
/// # Errors
/// [`BagError::Stopped`], and those of [`contents`].
pub fn contents_until(path: &Path, stop: &AtomicBool) -> Result<Contents, BagError> {
    let mut found = Contents::default();
    found.ending = scan_until(path, stop, &mut |item| {
        found.note(&item);
        Ok(())
    })?;
    Ok(found)
}

impl Contents {
    /// Notes what an item of the recording tells, for those who scan it themselves.
    pub fn note(&mut self, item: &Item<'_>) {
        match item {
            Item::Header { profile, library } => {
                (*profile).clone_into(&mut self.profile);
                (*library).clone_into(&mut self.library);
            }
            Item::Message(message) if !is_truth(&message.channel.topic) => self.message(message),
            Item::Attachment { name, data, .. } => {
                self.attachments.push((*name).to_owned());
                if self.urdf.is_none() {
                    self.urdf =
                        std::str::from_utf8(data).ok().filter(|text| is_urdf(text)).map(str::to_owned);
                }
            }
            Item::Message(_) | Item::Metadata { .. } => {}
        }
    }

    fn message(&mut self, message: &RawMessage<'_>) {
        let time = message.log_time_ns;
        let kind = match self.topics.get_mut(&message.channel.topic) {
            Some(topic) => {
                topic.messages += 1;
                topic.first_ns = topic.first_ns.min(time);
                topic.last_ns = topic.last_ns.max(time);
                topic.kind
            }
            None => {
                let topic = self.topic(message);
                let kind = topic.kind;
                self.topics.insert(message.channel.topic.clone(), topic);
                kind
            }
        };
        if self.urdf.is_none()
            && kind == Some(Kind::Text)
            && let Some(Ok(Reading::Text(text))) = self.readers.read(message)
            && is_urdf(&text)
        {
            self.urdf = Some(text);
        }
    }

    fn topic(&mut self, message: &RawMessage<'_>) -> Topic {
        let channel = message.channel;
        let (kind, problem) = match self.readers.reader(message) {
            Ok(reader) => (reader.kind(), None),
            Err(problem) => (None, Some(problem.to_owned())),
        };
        Topic {
            message_type: channel.message_type.clone(),
            message_encoding: channel.message_encoding.clone(),
            kind,
            problem,
            messages: 1,
            first_ns: message.log_time_ns,
            last_ns: message.log_time_ns,
        }
    }

    /// Whether a topic is of this kind.
    #[must_use]
    pub fn has_kind(&self, kind: Kind) -> bool {
        self.topics.values().any(|topic| topic.kind == Some(kind))
    }

    /// The topic of a kind that was asked for; or else the usual one, or the only one of its kind.
    ///
    /// # Errors
    /// [`BagError::Topic`] with the topics there are, or [`BagError::Unreadable`] if the topic asked for cannot be read.
    pub fn choose(&self, asked: Option<&str>, usual: &str, kind: Kind) -> Result<String, BagError> {
        let is = |name: &&str| self.topics.get(*name).is_some_and(|topic| topic.kind == Some(kind));
        let found = match asked {
            Some(name) => Some(name).filter(is),
            None => Some(usual).filter(is).or_else(|| {
                let mut all = self.topics.keys().map(String::as_str).filter(is);
                all.next().filter(|_| all.next().is_none())
            }),
        };
        let wanted = asked.unwrap_or(usual);
        found.map(str::to_owned).ok_or_else(|| match self.topics.get(wanted) {
            Some(Topic { problem: Some(reason), .. }) => {
                BagError::Unreadable { topic: wanted.to_owned(), reason: reason.clone() }
            }
            _ => BagError::Topic { wanted: wanted.to_owned(), kind, known: self.listed() },
        })
    }

    fn listed(&self) -> String {
        let names: Vec<String> =
            self.topics.iter().map(|(name, topic)| format!("{name} ({})", topic.message_type)).collect();
        if names.is_empty() { "none".to_owned() } else { names.join(", ") }
    }
}

/// Whether a topic tells what only a simulation knows.
pub(crate) fn is_truth(topic: &str) -> bool {
    topic.strip_prefix("/truth").is_some_and(|rest| rest.is_empty() || rest.starts_with('/'))
}

fn is_urdf(text: &str) -> bool {
    text.contains("<robot")
}
