//! A first look at a recording: which topics it has, the URDF, the joints that are named, and the frames of the wrenches.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use soilctl_bag::{BagError, Contents, Early, Ending, Item, Kind, RawMessage, Readers, Reading, Topic, scan};

use crate::MotionError;

/// Usual names of the topics.
pub(crate) const JOINTS: &str = "/joint_states";
pub(crate) const WRENCHES: &str = "/wrench";
/// More joints than this are not remembered; no robot has so many.
const MOST_NAMES: usize = 10_000;

/// What was seen of a recording.
#[derive(Debug, Default)]
pub struct Look {
    /// Topics, URDF, attachments.
    pub contents: Contents,
    readers: Readers,
    /// Joints that a topic named.
    named: BTreeMap<String, BTreeSet<String>>,
    /// Frame of the first wrench of a topic.
    frames: BTreeMap<String, String>,
}

/// Looks at a recording until `enough` says so, which is asked after every item, and told whether that one had something new.
///
/// # Errors
/// [`MotionError::Bag`] if the recording cannot be read, or to stop; [`MotionError::Empty`] without messages.
pub fn look(
    path: &Path,
    stop: &AtomicBool,
    enough: &mut dyn FnMut(&Look, bool) -> bool,
) -> Result<Look, MotionError> {
    let mut seen = Look::default();
    let ending = scan(path, &mut |item| {
        if stop.load(Ordering::Relaxed) {
            return Err(Early::Failed(BagError::Stopped));
        }
        let new = seen.note(&item);
        if enough(&seen, new) { Err(Early::Enough) } else { Ok(()) }
    });
    match ending {
        Ok(ending) => seen.contents.ending = ending,
        Err(Early::Enough) => {}
        Err(Early::Failed(error)) => return Err(error.into()),
    }
    seen.some()
}

/// Looks at a whole recording, which may have no messages, and shows its items to `also`.
///
/// # Errors
/// [`MotionError::Bag`].
pub(crate) fn look_through(
    path: &Path,
    stop: &AtomicBool,
    also: &mut dyn FnMut(&Item<'_>),
) -> Result<Look, MotionError> {
    let mut seen = Look::default();
    let ending: Ending = scan(path, &mut |item| -> Result<(), BagError> {
        if stop.load(Ordering::Relaxed) {
            return Err(BagError::Stopped);
        }
        seen.note(&item);
        also(&item);
        Ok(())
    })?;
    seen.contents.ending = ending;
    Ok(seen)
}

impl Look {
    pub(crate) fn some(self) -> Result<Self, MotionError> {
        if self.contents.topics.is_empty() { Err(MotionError::Empty) } else { Ok(self) }
    }

    /// Notes an item; whether something new was seen that may matter.
    fn note(&mut self, item: &Item<'_>) -> bool {
        let before = (self.contents.topics.len(), self.contents.urdf.is_some());
        self.contents.note(item);
        let new = before != (self.contents.topics.len(), self.contents.urdf.is_some());
        let told = match item {
            Item::Message(message) => self.message(message),
            Item::Header { .. } | Item::Metadata { .. } | Item::Attachment { .. } => false,
        };
        new || told
    }

    fn message(&mut self, message: &RawMessage<'_>) -> bool {
        let topic = &message.channel.topic;
        let kind = self.contents.topics.get(topic).and_then(|known| known.kind);
        let wanted = match kind {
            Some(Kind::Joints) => true,
            Some(Kind::Wrench) => !self.frames.contains_key(topic),
            Some(Kind::Text | Kind::Points) | None => false,
        };
        if !wanted {
            return false;
        }
        match self.readers.read(message) {
            Some(Ok(Reading::Joints { names, .. })) => {
                let known = self.named.entry(topic.clone()).or_default();
                let before = known.len();
                if before < MOST_NAMES {
                    known.extend(names);
                }
                known.len() > before
            }
            Some(Ok(Reading::Wrench { frame, .. })) => {
                self.frames.insert(topic.clone(), frame);
                true
            }
            Some(Ok(Reading::Text(_) | Reading::Points { .. }) | Err(_)) | None => false,
        }
    }

    /// Whether a topic has the usual name of joint states.
    #[must_use]
    pub fn has_usual_joints(&self) -> bool {
        self.contents.topics.contains_key(JOINTS)
    }

    /// The topic of the wrenches: the one that was asked for, or `/wrench`, or the only one.
    ///
    /// # Errors
    /// [`MotionError::Bag`] with the topics there are.
    pub fn wrench_topic(&self, asked: Option<&str>) -> Result<String, MotionError> {
        Ok(self.contents.choose(asked, WRENCHES, Kind::Wrench)?)
    }

    /// The frame that the first wrench of a topic names; empty if it names none.
    #[must_use]
    pub fn frame(&self, topic: &str) -> &str {
        self.frames.get(topic).map_or("", String::as_str)
    }

    /// The URDF that was given, or else the one in the recording.
    ///
    /// # Errors
    /// [`MotionError::Missing`] if there is none.
    pub fn urdf<'a>(&'a self, given: Option<&'a str>) -> Result<&'a str, MotionError> {
        given.or(self.contents.urdf.as_deref()).ok_or(MotionError::Missing {
            what: "--urdf",
            advice: "the log has neither a /robot_description nor a URDF attached; give the arm's URDF"
                .into(),
        })
    }

    /// The topic of joint states that was asked for, or the usual one, or any one that names all joints that matter, or else all
    /// that name some.
    ///
    /// # Errors
    /// [`MotionError::Bag`], [`MotionError::Missing`] if several name all of them, [`MotionError::Joints`] if a joint is never
    /// named.
    pub fn joint_topics(&self, asked: Option<&str>, joints: &[String]) -> Result<Vec<String>, MotionError> {
        let of_kind = self.of_joints();
        let all = |topic: &str| joints.iter().all(|joint| self.names(topic, joint));
        if asked.is_some() || of_kind.is_empty() {
            let only = self.contents.choose(asked, JOINTS, Kind::Joints)?;
            return self.complete(vec![only], joints);
        }
        let whole: Vec<&&String> = of_kind.iter().filter(|topic| all(topic)).collect();
        let one = whole.iter().find(|topic| topic.as_str() == JOINTS).or(match whole.as_slice() {
            [only] => Some(only),
            _ => None,
        });
        if let Some(one) = one {
            return Ok(vec![(***one).clone()]);
        }
        if !whole.is_empty() && !joints.is_empty() {
            let names = listed(whole.iter().map(|topic| topic.as_str()));
            let advice = format!("{names} all name the joints; say which counts");
            return Err(MotionError::Missing { what: "--joint-topic", advice });
        }
        let parts: Vec<String> = of_kind
            .iter()
            .filter(|topic| joints.iter().any(|joint| self.names(topic, joint)))
            .map(|topic| (**topic).clone())
            .collect();
        self.complete(parts, joints)
    }

    /// Topics of joint states, begun with those of `first`, that each name a joint which those before do not, of those for which
    /// `matters`; and all these joints.
    #[must_use]
    pub fn cover(
        &self,
        first: Vec<String>,
        matters: &dyn Fn(&str) -> bool,
    ) -> (Vec<String>, BTreeSet<String>) {
        let joints_of =
            |topic: &str| self.named.get(topic).into_iter().flatten().filter(|name| matters(name)).cloned();
        let mut found: BTreeSet<String> = first.iter().flat_map(|topic| joints_of(topic)).collect();
        let mut topics = first;
        let usual = self.of_joints().into_iter().filter(|topic| *topic == JOINTS);
        let others = self.of_joints().into_iter().filter(|topic| *topic != JOINTS);
        for topic in usual.chain(others) {
            if !topics.contains(topic) && joints_of(topic).any(|name| !found.contains(&name)) {
                found.extend(joints_of(topic));
                topics.push(topic.clone());
            }
        }
        (topics, found)
    }

    /// Topics of joint states by name.
    fn of_joints(&self) -> Vec<&String> {
        let is = |topic: &Topic| topic.kind == Some(Kind::Joints);
        self.contents.topics.iter().filter(|(_, topic)| is(topic)).map(|(name, _)| name).collect()
    }

    fn names(&self, topic: &str, joint: &str) -> bool {
        self.named.get(topic).is_some_and(|names| names.contains(joint))
    }

    /// Refuses topics that leave a joint out.
    fn complete(&self, topics: Vec<String>, joints: &[String]) -> Result<Vec<String>, MotionError> {
        let named = |joint: &&String| topics.iter().any(|topic| self.names(topic, joint));
        let missing: Vec<&String> = joints.iter().filter(|joint| !named(joint)).collect();
        if missing.is_empty() {
            return Ok(topics);
        }
        let looked: Vec<&String> =
            if topics.is_empty() { self.named.keys().collect() } else { topics.iter().collect() };
        let all = looked.iter().filter_map(|topic| self.named.get(*topic)).flatten();
        Err(MotionError::Joints {
            topic: listed(looked.iter().map(|topic| topic.as_str())),
            missing: listed(missing.into_iter().map(String::as_str)),
            named: listed(all.map(String::as_str)),
        })
    }
}

pub(crate) fn listed<T: AsRef<str>>(names: impl Iterator<Item = T>) -> String {
    let names: Vec<String> = names.map(|name| name.as_ref().to_owned()).collect();
    if names.is_empty() { "none".into() } else { names.join(", ") }
}
