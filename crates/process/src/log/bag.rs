//! Bags of any program: joint states and wrenches.

use std::collections::{BTreeMap, BTreeSet, VecDeque};
use std::path::Path;

use soilctl_session::messages::{Header, JointState, StringMessage, WrenchStamped, decode};
use soilctl_session::read::{Early, Item, RawMessage, scan};

use super::cut::Cutter;
use super::{Found, LogSettings};
use crate::{Aligner, ProcessError, Robot};

const JOINT_STATE: &str = "sensor_msgs/msg/JointState";
pub(super) const WRENCH: &str = "geometry_msgs/msg/WrenchStamped";
const TEXT: &str = "std_msgs/msg/String";
/// Messages may come so late, by their stamps, in s.
const WAIT_S: f64 = 0.5;
/// Stamps from this one on, in s, are taken to be those of a wall clock; windows may then count from the first stamp.
const WALL_CLOCK_S: f64 = 1e6;

/// Joins the two topics of a bag.
pub(super) struct Bag {
    settings: LogSettings,
    urdf: Option<String>,
    joint_topic: String,
    wrench_topic: String,
    /// Made with the first wrench, whose header may name its frame.
    aligner: Option<Aligner>,
    /// Joint states that came before the first wrench.
    early: VecDeque<(f64, Vec<(String, f64)>)>,
    cutter: Cutter,
    named: BTreeSet<String>,
    /// Time of the first stamp, from which the log's clock counts, in ns.
    origin_ns: Option<i64>,
    malformed: u64,
}

impl Bag {
    /// Looks through the log once for its topics and, if need be, its URDF.
    pub(super) fn new(path: &Path, settings: &LogSettings) -> Result<Self, ProcessError> {
        let mut topics: BTreeMap<String, String> = BTreeMap::new();
        let mut urdf = settings.urdf.clone();
        let mut both = false;
        let scanned = scan(path, &mut |item| {
            match item {
                Item::Message(message) if !message.channel.topic.starts_with("/truth") => {
                    let channel = message.channel;
                    if !topics.contains_key(&channel.topic) {
                        topics.insert(channel.topic.clone(), channel.message_type.clone());
                        let has = |wanted: &str| topics.values().any(|known| known == wanted);
                        both = has(JOINT_STATE) && has(WRENCH);
                    }
                    if urdf.is_none() && channel.message_type == TEXT {
                        urdf = description(message.data);
                    }
                }
                Item::Attachment { data, .. } if urdf.is_none() => {
                    urdf = std::str::from_utf8(data).ok().filter(|text| is_urdf(text)).map(str::to_owned);
                }
                _ => {}
            }
            let named = |name: &Option<String>| name.as_ref().is_none_or(|name| topics.contains_key(name));
            if both && urdf.is_some() && named(&settings.joint_topic) && named(&settings.wrench_topic) {
                // All is known; the rest comes in the second pass.
                return Err(Early::Enough);
            }
            Ok(())
        });
        if let Err(Early::Failed(error)) = scanned {
            return Err(error.into());
        }
        let joint_topic = choose(&topics, settings.joint_topic.as_deref(), "/joint_states", JOINT_STATE)?;
        let wrench_topic = choose(&topics, settings.wrench_topic.as_deref(), "/wrench", WRENCH)?;
        Ok(Self {
            settings: settings.clone(),
            urdf,
            joint_topic,
            wrench_topic,
            aligner: None,
            early: VecDeque::new(),
            cutter: Cutter::new(settings),
            named: BTreeSet::new(),
            origin_ns: None,
            malformed: 0,
        })
    }

    pub(super) fn message(
        &mut self,
        message: &RawMessage<'_>,
        found: &mut dyn FnMut(Found),
    ) -> Result<(), ProcessError> {
        let topic = &message.channel.topic;
        if *topic == self.joint_topic {
            if self.joints(message).is_none() {
                self.malformed += 1;
            }
        } else if *topic == self.wrench_topic {
            match self.wrench(message)? {
                Some(()) => self.drain(false, found)?,
                None => self.malformed += 1,
            }
        }
        Ok(())
    }

    /// The stamp, or else the log's time, from the first one on, in s.
    fn time_s(&mut self, header: &Header, message: &RawMessage<'_>) -> f64 {
        let ns = header.stamp.ns().unwrap_or_else(|| i64::try_from(message.log_time_ns).unwrap_or(i64::MAX));
        // Whole seconds, so that times stay as they were stamped but for the origin.
        let wall = ns / 1_000_000_000 >= WALL_CLOCK_S as i64;
        let origin = *self.origin_ns.get_or_insert(if wall { ns - ns % 1_000_000_000 } else { 0 });
        ns.saturating_sub(origin) as f64 * 1e-9
    }

    fn joints(&mut self, message: &RawMessage<'_>) -> Option<()> {
        let state: JointState = decode(message.data).ok()?;
        // Positions may be left out altogether, as ROS allows.
        if state.position.len() != state.name.len() {
            return None;
        }
        let t_s = self.time_s(&state.header, message);
        for name in &state.name {
            if !self.named.contains(name) {
                self.named.insert(name.clone());
            }
        }
        match &mut self.aligner {
            Some(aligner) => {
                aligner
                    .joints(t_s, state.name.iter().map(String::as_str).zip(state.position.iter().copied()));
            }
            None => {
                let all = state.name.into_iter().zip(state.position).collect();
                self.early.push_back((t_s, all));
                // Wrenches of so long ago could not be joined anyway.
                if self.early.len() > 100_000 {
                    self.early.pop_front();
                }
            }
        }
        Some(())
    }

    fn wrench(&mut self, message: &RawMessage<'_>) -> Result<Option<()>, ProcessError> {
        let Some((header, wrench)) = read_wrench(message.data) else { return Ok(None) };
        let t_s = self.time_s(&header, message);
        if self.aligner.is_none() {
            self.begin(&header.frame_id)?;
        }
        if let Some(aligner) = &mut self.aligner {
            aligner.wrench(t_s, wrench);
        }
        Ok(Some(()))
    }

    /// With the first wrench all is known that a robot is made of.
    fn begin(&mut self, frame: &str) -> Result<(), ProcessError> {
        let urdf = self.urdf.as_deref().ok_or(ProcessError::Missing {
            what: "--urdf",
            advice: "the log has neither a /robot_description nor a URDF attached; give the arm's URDF"
                .into(),
        })?;
        let plate = self.settings.plate_frame.as_deref().unwrap_or("plate_tip");
        let sensor = match (&self.settings.sensor_frame, frame) {
            (Some(given), _) => given.as_str(),
            (None, "") => "ft_sensor",
            (None, named) => named,
        };
        let robot = Robot::from_urdf(urdf, plate, sensor)?;
        for (what, value) in [("--surface-z", self.settings.surface_z_m), ("--width", self.settings.width_m)]
        {
            if value.is_none() {
                let advice = "a bag of another program does not say it; give it in m".into();
                return Err(ProcessError::Missing { what, advice });
            }
        }
        let mut aligner = Aligner::new(robot, WAIT_S);
        for (t_s, joints) in self.early.drain(..) {
            aligner.joints(t_s, joints.iter().map(|(name, value)| (name.as_str(), *value)));
        }
        self.aligner = Some(aligner);
        Ok(())
    }

    fn drain(&mut self, end: bool, found: &mut dyn FnMut(Found)) -> Result<(), ProcessError> {
        let Some(aligner) = &mut self.aligner else { return Ok(()) };
        while let Some(sample) = aligner.next(end)? {
            self.cutter.push(sample, found);
        }
        Ok(())
    }

    /// Ends the bag; what could not be used.
    pub(super) fn end(mut self, found: &mut dyn FnMut(Found)) -> Result<Vec<String>, ProcessError> {
        self.drain(true, found)?;
        self.cutter.end(found);
        let Some(aligner) = &self.aligner else {
            return Err(ProcessError::Log(format!(
                "no message on {} can be read as {WRENCH}",
                self.wrench_topic
            )));
        };
        let missing = aligner.missing_joints();
        if !missing.is_empty() {
            return Err(ProcessError::Joints {
                topic: self.joint_topic.clone(),
                missing: missing.join(", "),
                named: listed(self.named.iter().map(String::as_str)),
            });
        }
        let lost = aligner.lost();
        let count = |number: u64, what: &str| (number > 0).then(|| format!("{number} {what}"));
        Ok([
            count(lost.late, "messages came more than 0.5 s late by their stamps"),
            count(lost.gaps, "wrenches have no joint states close before and after"),
            count(lost.repeated, "messages repeat a stamp"),
            count(lost.unusable, "messages have a number that is not finite"),
            count(self.malformed, "messages cannot be read"),
        ]
        .into_iter()
        .flatten()
        .collect())
    }
}

/// The topic that was asked for, the usual one, or the only one of its type.
fn choose(
    topics: &BTreeMap<String, String>,
    asked: Option<&str>,
    usual: &str,
    message_type: &'static str,
) -> Result<String, ProcessError> {
    let of_type: Vec<&String> =
        topics.iter().filter(|(_, known)| *known == message_type).map(|(name, _)| name).collect();
    let found = match asked {
        Some(name) => of_type.iter().find(|known| **known == name),
        None => of_type.iter().find(|known| **known == usual).or(match of_type.as_slice() {
            [only] => Some(only),
            _ => None,
        }),
    };
    found.map(|name| (*name).clone()).ok_or_else(|| ProcessError::Topic {
        wanted: asked.unwrap_or(usual).to_owned(),
        message_type,
        known: listed(topics.iter().map(|(name, known)| format!("{name} ({known})"))),
    })
}

fn listed<T: AsRef<str>>(names: impl Iterator<Item = T>) -> String {
    let names: Vec<String> = names.map(|name| name.as_ref().to_owned()).collect();
    if names.is_empty() { "none".into() } else { names.join(", ") }
}

/// Header and wrench of a message.
pub(super) fn read_wrench(message: &[u8]) -> Option<(Header, [f64; 6])> {
    let WrenchStamped { header, wrench } = decode(message).ok()?;
    let [f, t] = [wrench.force, wrench.torque];
    Some((header, [f.x, f.y, f.z, t.x, t.y, t.z]))
}

fn is_urdf(text: &str) -> bool {
    text.contains("<robot")
}

fn description(message: &[u8]) -> Option<String> {
    let StringMessage { data } = decode(message).ok()?;
    is_urdf(&data).then_some(data)
}
