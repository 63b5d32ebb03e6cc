//! A first look at a log: which topics it has, the URDF, and the frame of the wrenches.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use soilctl_bag::{Contents, Early, Item, Kind, RawMessage, Readers, Reading, scan};

use crate::ProcessError;
use crate::log::LogSettings;
use crate::robot::Robot;

/// Usual names of the topics.
const JOINTS: &str = "/joint_states";
const WRENCHES: &str = "/wrench";
/// Link at the plate's lower edge, unless told otherwise.
const PLATE: &str = "plate_tip";
/// Once all is there that is needed, so many more messages are looked at for a topic with the usual name.
const PATIENCE: u32 = 5000;

/// What is needed to read a log.
#[derive(Debug)]
pub(crate) struct Look {
    pub(crate) joint_topics: Vec<String>,
    pub(crate) wrench_topic: String,
    pub(crate) robot: Robot,
}

#[derive(Default)]
struct Seen {
    contents: Contents,
    readers: Readers,
    /// Joints that a topic named.
    named: BTreeMap<String, BTreeSet<String>>,
    /// Frame of the first wrench of a topic.
    frames: BTreeMap<String, String>,
}

/// Looks until all that is needed was seen, or to the end.
///
/// # Errors
/// [`ProcessError::Log`] if the file cannot be read or is no log, [`ProcessError::Missing`], [`ProcessError::Topic`],
/// [`ProcessError::Joints`], [`ProcessError::Urdf`] or [`ProcessError::NoFrame`] if something is missing,
/// [`ProcessError::Stopped`].
pub(crate) fn look(path: &Path, settings: &LogSettings, stop: &AtomicBool) -> Result<Look, ProcessError> {
    let mut seen = Seen::default();
    let (mut patience, mut ready) = (PATIENCE, false);
    let scanned = scan(path, &mut |item| {
        if stop.load(Ordering::Relaxed) {
            return Err(Early::Failed(soilctl_bag::BagError::Stopped));
        }
        if seen.item(&item) {
            ready = seen.look(settings).is_ok();
        }
        patience -= u32::from(ready && patience > 0);
        let usual = seen.contents.topics.contains_key(JOINTS) || settings.joint_topic.is_some();
        if ready && (usual || patience == 0) { Err(Early::Enough) } else { Ok(()) }
    });
    if let Err(Early::Failed(error)) = scanned {
        return Err(error.into());
    }
    if seen.contents.topics.is_empty() {
        return Err(ProcessError::Log("it has no messages".into()));
    }
    seen.look(settings)
}

impl Seen {
    /// Whether something new was seen that may matter.
    fn item(&mut self, item: &Item<'_>) -> bool {
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
            Some(Kind::Text) | None => false,
        };
        if !wanted {
            return false;
        }
        match self.readers.read(message) {
            Some(Ok(Reading::Joints { names, .. })) => {
                let known = self.named.entry(topic.clone()).or_default();
                let before = known.len();
                known.extend(names);
                known.len() > before
            }
            Some(Ok(Reading::Wrench { frame, .. })) => {
                self.frames.insert(topic.clone(), frame);
                true
            }
            Some(Ok(Reading::Text(_)) | Err(_)) | None => false,
        }
    }

    fn look(&self, settings: &LogSettings) -> Result<Look, ProcessError> {
        let wrench_topic = self.contents.choose(settings.wrench_topic.as_deref(), WRENCHES, Kind::Wrench)?;
        let frame = self.frames.get(&wrench_topic).map_or("", String::as_str);
        let urdf =
            settings.urdf.as_deref().or(self.contents.urdf.as_deref()).ok_or(ProcessError::Missing {
                what: "--urdf",
                advice: "the log has neither a /robot_description nor a URDF attached; give the arm's URDF"
                    .into(),
            })?;
        let plate = settings.plate_frame.as_deref().unwrap_or(PLATE);
        let sensor = match (&settings.sensor_frame, frame) {
            (Some(given), _) => given.as_str(),
            (None, "") => "ft_sensor",
            (None, named) => named,
        };
        let robot = Robot::from_urdf(urdf, plate, sensor)?;
        let joint_topics = self.joint_topics(settings, robot.joint_names())?;
        Ok(Look { joint_topics, wrench_topic, robot })
    }

    /// The topic that was asked for, or the usual one, or any one that names all joints that matter, or else all that name some.
    fn joint_topics(&self, settings: &LogSettings, joints: &[String]) -> Result<Vec<String>, ProcessError> {
        let joints_in = |topic: &soilctl_bag::Topic| topic.kind == Some(Kind::Joints);
        let of_kind: Vec<&String> =
            self.contents.topics.iter().filter(|(_, topic)| joints_in(topic)).map(|(name, _)| name).collect();
        let names = |topic: &str, joint: &String| self.named.get(topic).is_some_and(|n| n.contains(joint));
        let all = |topic: &str| joints.iter().all(|joint| names(topic, joint));
        if settings.joint_topic.is_some() || of_kind.is_empty() {
            let only = self.contents.choose(settings.joint_topic.as_deref(), JOINTS, Kind::Joints)?;
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
            return Err(ProcessError::Missing { what: "--joint-topic", advice });
        }
        let parts: Vec<String> = of_kind
            .iter()
            .filter(|topic| joints.iter().any(|joint| names(topic, joint)))
            .map(|topic| (**topic).clone())
            .collect();
        self.complete(parts, joints)
    }

    /// Refuses topics that leave a joint out.
    fn complete(&self, topics: Vec<String>, joints: &[String]) -> Result<Vec<String>, ProcessError> {
        let named =
            |joint: &&String| topics.iter().any(|t| self.named.get(t).is_some_and(|n| n.contains(*joint)));
        let missing: Vec<&String> = joints.iter().filter(|joint| !named(joint)).collect();
        if missing.is_empty() {
            return Ok(topics);
        }
        let looked: Vec<&String> =
            if topics.is_empty() { self.named.keys().collect() } else { topics.iter().collect() };
        let all = looked.iter().filter_map(|topic| self.named.get(*topic)).flatten();
        Err(ProcessError::Joints {
            topic: listed(looked.iter().map(|topic| topic.as_str())),
            missing: listed(missing.into_iter().map(String::as_str)),
            named: listed(all.map(String::as_str)),
        })
    }
}

fn listed<T: AsRef<str>>(names: impl Iterator<Item = T>) -> String {
    let names: Vec<String> = names.map(|name| name.as_ref().to_owned()).collect();
    if names.is_empty() { "none".into() } else { names.join(", ") }
}
