use soilctl_session::messages::{Header, JointState, WrenchStamped, decode};
use soilctl_session::read::RawMessage;

/// Type of the joint states in a bag.
pub const JOINT_STATE: &str = "sensor_msgs/msg/JointState";
/// Type of the wrenches.
pub const WRENCH: &str = "geometry_msgs/msg/WrenchStamped";
/// Stamps from this one on, in s, are taken to be those of a wall clock; windows may then count from the first stamp.
const WALL_CLOCK_S: i64 = 1_000_000;

/// Reads the joint states and wrenches of a bag, on one clock.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BagReader {
    joint_topic: String,
    wrench_topic: Option<String>,
    /// Time of the first stamp, from which the log's clock counts, in ns.
    origin_ns: Option<i64>,
    malformed: u64,
}

/// What a message says, its time in s.
#[derive(Debug, Clone, PartialEq)]
pub enum BagMessage {
    /// Joints.
    Joints {
        /// Stamp, or else the log's time.
        t_s: f64,
        /// Names of the joints.
        names: Vec<String>,
        /// Their positions in rad or m.
        positions: Vec<f64>,
    },
    /// A wrench.
    Wrench {
        /// Stamp, or else the log's time.
        t_s: f64,
        /// The frame in its header; may be empty.
        frame: String,
        /// Force in N and torque in N m.
        wrench: [f64; 6],
    },
}

impl BagReader {
    /// For these topics.
    #[must_use]
    pub fn new(joint_topic: String, wrench_topic: Option<String>) -> Self {
        Self { joint_topic, wrench_topic, origin_ns: None, malformed: 0 }
    }

    /// Topic of the joint states.
    #[must_use]
    pub fn joint_topic(&self) -> &str {
        &self.joint_topic
    }

    /// Topic of the wrenches.
    #[must_use]
    pub fn wrench_topic(&self) -> Option<&str> {
        self.wrench_topic.as_deref()
    }

    /// Messages that could not be read.
    #[must_use]
    pub fn malformed(&self) -> u64 {
        self.malformed
    }

    /// What a message says; none if it is on another topic or cannot be read.
    pub fn read(&mut self, message: &RawMessage<'_>) -> Option<BagMessage> {
        let topic = message.channel.topic.as_str();
        let heard = if topic == self.joint_topic {
            self.joints(message)
        } else if Some(topic) == self.wrench_topic.as_deref() {
            self.wrench(message)
        } else {
            return None;
        };
        self.malformed += u64::from(heard.is_none());
        heard
    }

    fn joints(&mut self, message: &RawMessage<'_>) -> Option<BagMessage> {
        let JointState { header, name: names, position: positions, .. } = decode(message.data).ok()?;
        // Positions may be left out altogether, as ROS allows.
        if positions.len() != names.len() {
            return None;
        }
        Some(BagMessage::Joints { t_s: self.time_s(&header, message), names, positions })
    }

    fn wrench(&mut self, message: &RawMessage<'_>) -> Option<BagMessage> {
        let (header, wrench) = read_wrench(message.data)?;
        Some(BagMessage::Wrench { t_s: self.time_s(&header, message), frame: header.frame_id, wrench })
    }

    /// The stamp, or else the log's time, from the first one on, in s.
    fn time_s(&mut self, header: &Header, message: &RawMessage<'_>) -> f64 {
        let ns = header.stamp.ns().unwrap_or_else(|| i64::try_from(message.log_time_ns).unwrap_or(i64::MAX));
        // Whole seconds, so that times stay as they were stamped but for the origin.
        let wall = ns / 1_000_000_000 >= WALL_CLOCK_S;
        let origin = *self.origin_ns.get_or_insert(if wall { ns - ns % 1_000_000_000 } else { 0 });
        ns.saturating_sub(origin) as f64 * 1e-9
    }
}

/// Header and wrench of a message.
fn read_wrench(message: &[u8]) -> Option<(Header, [f64; 6])> {
    let WrenchStamped { header, wrench } = decode(message).ok()?;
    let [f, t] = [wrench.force, wrench.torque];
    Some((header, [f.x, f.y, f.z, t.x, t.y, t.z]))
}
