//! The channels of a log.

use std::collections::BTreeMap;

/// Joints by the external encoders; efforts are joint torques before the transmission.
pub const JOINT_STATES: &str = "/joint_states";
/// Motors in their own coordinates; efforts are motor torques.
pub const MOTOR_STATES: &str = "/motor_states";
/// The force sensor's reading, bias included.
pub const WRENCH: &str = "/wrench";
/// Moving frames.
pub const TF: &str = "/tf";
/// Frames that stand still.
pub const TF_STATIC: &str = "/tf_static";
/// The URDF.
pub const ROBOT_DESCRIPTION: &str = "/robot_description";
/// Inputs and outputs of every step.
pub const STEP: &str = "/controller/step";
/// States to replay from.
pub const KEYFRAME: &str = "/controller/keyframe";
/// True joints of a simulated arm.
pub const TRUE_JOINTS: &str = "/truth/joint_states";
/// What a simulated soil knows.
pub const TRUE_SOIL: &str = "/truth/soil";

/// A channel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Topic {
    pub(crate) name: &'static str,
    pub(crate) message_type: &'static str,
    /// Whether late subscribers get the last message.
    latched: bool,
}

const fn topic(name: &'static str, message_type: &'static str, latched: bool) -> Topic {
    Topic { name, message_type, latched }
}

/// All channels, in the order of their numbers in a file.
pub(crate) const ALL: [Topic; 10] = [
    topic(ROBOT_DESCRIPTION, "std_msgs/msg/String", true),
    topic(TF_STATIC, "tf2_msgs/msg/TFMessage", true),
    topic(STEP, "soilctl_msgs/msg/ControllerStep", false),
    topic(KEYFRAME, "soilctl_msgs/msg/Keyframe", false),
    topic(JOINT_STATES, "sensor_msgs/msg/JointState", false),
    topic(MOTOR_STATES, "sensor_msgs/msg/JointState", false),
    topic(WRENCH, "geometry_msgs/msg/WrenchStamped", false),
    topic(TF, "tf2_msgs/msg/TFMessage", false),
    topic(TRUE_JOINTS, "sensor_msgs/msg/JointState", false),
    topic(TRUE_SOIL, "soilctl_msgs/msg/SoilTruth", false),
];

impl Topic {
    /// Metadata of the channel: the complete quality of service, without which some readers refuse a bag. The numbers
    /// are those of rosbag2: keep last, reliable, transient local or volatile, automatic liveliness.
    pub(crate) fn metadata(self) -> BTreeMap<String, String> {
        let durability = if self.latched { 1 } else { 2 };
        let forever = "  sec: 9223372036\n  nsec: 854775807\n".replace("  ", "    ");
        let profile = format!(
            "- history: 1\n  depth: 10\n  reliability: 1\n  durability: {durability}\n  deadline:\n{forever}  lifespan:\n\
             {forever}  liveliness: 1\n  liveliness_lease_duration:\n{forever}  avoid_ros_namespace_conventions: false\n"
        );
        BTreeMap::from([("offered_qos_profiles".to_owned(), profile)])
    }
}
