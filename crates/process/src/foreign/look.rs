//! A first look at a log: which topics it has, the URDF, and the frame of the wrenches.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use soilctl_bag::{Early, Item, Kind, RawMessage, Readers, Reading, scan};

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
    /// Kind of each topic, and its type.
    topics: BTreeMap<String, (Option<Kind>, String)>,
    /// Joints that a topic named.
    named: BTreeMap<String, BTreeSet<String>>,
    /// Frame of the first wrench of a topic.
    frames: BTreeMap<String, String>,
    urdf: Option<String>,
}

/// Looks until all that is needed was seen, or to the end.
///
/// # Errors
/// [`ProcessError::Log`] if the file cannot be read or is no log, [`ProcessError::Missing`], [`ProcessError::Topic`],
/// [`ProcessError::Joints`], [`ProcessError::Urdf`] or [`ProcessError::NoFrame`] if something is missing.
pub(crate) fn look(path: &Path, settings: &LogSettings) -> Result<Look, ProcessError> {
    let mut readers = Readers::default();
    let mut seen = Seen { urdf: settings.urdf.clone(), ..Seen::default() };
    let mut patience = PATIENCE;
    let mut ready = false;
    let scanned = scan(path, &mut |item| {
        if seen.item(item, &mut readers) || (seen.topics.len() > 1 && patience.is_multiple_of(500)) {
            ready = seen.look(settings).is_ok();
        }
        patience -= u32::from(ready && patience > 0);
        let usual = seen.topics.contains_key(JOINTS) || settings.joint_topic.is_some();
        if ready && (usual || patience == 0) { Err(Early::Enough) } else { Ok(()) }
    });
    if let Err(Early::Failed(error)) = scanned {
        return Err(error.into());
    }
    if seen.topics.is_empty() {
        return Err(ProcessError::Log("it has no messages".into()));
    }
    seen.look(settings)
}

impl Seen {
    /// Whether something new was seen that may matter.
    fn item(&mut self, item: Item<'_>, readers: &mut Readers) -> bool {
        match item {
            Item::Message(message) if !message.channel.topic.starts_with("/truth") => {
                self.message(&message, readers)
            }
            Item::Attachment { data, .. } if self.urdf.is_none() => {
                self.urdf = std::str::from_utf8(data).ok().filter(|text| is_urdf(text)).map(str::to_owned);
                self.urdf.is_some()
            }
            _ => false,
        }
    }

    fn message(&mut self, message: &RawMessage<'_>, readers: &mut Readers) -> bool {
        let topic = &message.channel.topic;
        let known = self.topics.get(topic).map(|(kind, _)| *kind);
        let kind = match known {
            Some(kind) => kind,
            None => {
                let kind = readers.kind(message.channel);
                self.topics.insert(topic.clone(), (kind, message.channel.message_type.clone()));
                kind
            }
        };
        let new = known.is_none();
        match kind {
            Some(Kind::Wrench) if self.frames.contains_key(topic) => new,
            Some(Kind::Text) if self.urdf.is_some() => new,
            Some(Kind::Joints | Kind::Wrench | Kind::Text) => match readers.read(message) {
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
                Some(Ok(Reading::Text(text))) if is_urdf(&text) => {
                    self.urdf = Some(text);
                    true
                }
                _ => new,
            },
            None => new,
        }
    }

    fn look(&self, settings: &LogSettings) -> Result<Look, ProcessError> {
        let wrench_topic = self.choose(settings.wrench_topic.as_deref(), WRENCHES, Kind::Wrench)?;
        let frame = self.frames.get(&wrench_topic).map_or("", String::as_str);
        let urdf = self.urdf.as_deref().ok_or(ProcessError::Missing {
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
        let of_kind: Vec<&String> = self
            .topics
            .iter()
            .filter(|(_, (kind, _))| *kind == Some(Kind::Joints))
            .map(|(name, _)| name)
            .collect();
        let names = |topic: &str, joint: &String| self.named.get(topic).is_some_and(|n| n.contains(joint));
        let all = |topic: &str| joints.iter().all(|joint| names(topic, joint));
        if settings.joint_topic.is_some() || of_kind.is_empty() {
            let only = self.choose(settings.joint_topic.as_deref(), JOINTS, Kind::Joints)?;
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
            return Err(ProcessError::Topic {
                wanted: JOINTS.to_owned(),
                message_type: type_of(Kind::Joints),
                known: format!(
                    "{}, which all name the joints; say which by --joint-topic",
                    listed(whole.iter().map(|topic| topic.as_str()))
                ),
            });
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

    /// The topic of a kind that was asked for, the usual one, or the only one.
    fn choose(&self, asked: Option<&str>, usual: &str, kind: Kind) -> Result<String, ProcessError> {
        let of_kind: Vec<&String> =
            self.topics.iter().filter(|(_, (known, _))| *known == Some(kind)).map(|(name, _)| name).collect();
        let found = match asked {
            Some(name) => of_kind.iter().find(|known| **known == name),
            None => of_kind.iter().find(|known| **known == usual).or(match of_kind.as_slice() {
                [only] => Some(only),
                _ => None,
            }),
        };
        found.map(|name| (*name).clone()).ok_or_else(|| ProcessError::Topic {
            wanted: asked.unwrap_or(usual).to_owned(),
            message_type: type_of(kind),
            known: listed(self.topics.iter().map(|(name, (_, known))| format!("{name} ({known})"))),
        })
    }
}

/// The usual type of a kind of message.
fn type_of(kind: Kind) -> &'static str {
    match kind {
        Kind::Joints => "sensor_msgs/msg/JointState",
        Kind::Wrench => "geometry_msgs/msg/WrenchStamped",
        Kind::Text => "std_msgs/msg/String",
    }
}

fn is_urdf(text: &str) -> bool {
    text.contains("<robot")
}

fn listed<T: AsRef<str>>(names: impl Iterator<Item = T>) -> String {
    let names: Vec<String> = names.map(|name| name.as_ref().to_owned()).collect();
    if names.is_empty() { "none".into() } else { names.join(", ") }
}
