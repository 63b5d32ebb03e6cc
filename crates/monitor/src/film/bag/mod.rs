//! A log of any program: joint states, a URDF, and wrenches if there are any.

mod load;
mod track;

pub(super) use load::load;
pub(crate) use track::Track;

/// What is to be taken of a log of another program, where it does not say so itself.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct BagSettings {
    /// Text of the URDF; without it the one in the log.
    pub urdf: Option<String>,
    /// Topic of the joint states (`sensor_msgs/msg/JointState`); without it `/joint_states`, or the only one.
    pub joint_topic: Option<String>,
    /// Topic of the wrenches (`geometry_msgs/msg/WrenchStamped`); without it `/wrench`, or the only one; there may be none.
    pub wrench_topic: Option<String>,
    /// The link whose origin is marked; without it `plate_tip`, or the link behind most joints.
    pub end_link: Option<String>,
    /// Link of the wrenches; without it the frame that their headers name.
    pub sensor_link: Option<String>,
    /// Height of the ground in the URDF's root frame in m; without it it is not shown and the floor is at 0.
    pub surface_z_m: Option<f64>,
}

impl BagSettings {
    /// Whether a log shall be read as a bag of topics, even if it is one of ours.
    pub(super) fn wants_bag(&self) -> bool {
        *self != Self::default()
    }
}
