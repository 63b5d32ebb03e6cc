//! The ROS 2 definitions of the messages, as they are embedded in a log.

const TIME: (&str, &str) = ("builtin_interfaces/Time", "int32 sec\nuint32 nanosec\n");
const HEADER: (&str, &str) = ("std_msgs/Header", "builtin_interfaces/Time stamp\nstring frame_id\n");
const VECTOR3: (&str, &str) = ("geometry_msgs/Vector3", "float64 x\nfloat64 y\nfloat64 z\n");
const QUATERNION: (&str, &str) =
    ("geometry_msgs/Quaternion", "float64 x 0\nfloat64 y 0\nfloat64 z 0\nfloat64 w 1\n");
const WRENCH: (&str, &str) =
    ("geometry_msgs/Wrench", "geometry_msgs/Vector3 force\ngeometry_msgs/Vector3 torque\n");
const TRANSFORM: (&str, &str) =
    ("geometry_msgs/Transform", "geometry_msgs/Vector3 translation\ngeometry_msgs/Quaternion rotation\n");
const TRANSFORM_STAMPED: (&str, &str) = (
    "geometry_msgs/TransformStamped",
    "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/Transform transform\n",
);
const EVENT: (&str, &str) = ("soilctl_msgs/Event", include_str!("../../msg/Event.msg"));

/// A definition with those of the types inside it, in the form of rosbag2; nothing for an unknown type.
pub(crate) fn definition(message_type: &str) -> Option<String> {
    let (body, parts): (&str, &[(&str, &str)]) = match message_type {
        "std_msgs/msg/String" => ("string data\n", &[]),
        "sensor_msgs/msg/JointState" => (
            "std_msgs/Header header\nstring[] name\nfloat64[] position\nfloat64[] velocity\nfloat64[] effort\n",
            &[HEADER, TIME],
        ),
        "geometry_msgs/msg/WrenchStamped" => {
            ("std_msgs/Header header\ngeometry_msgs/Wrench wrench\n", &[HEADER, TIME, WRENCH, VECTOR3])
        }
        "tf2_msgs/msg/TFMessage" => (
            "geometry_msgs/TransformStamped[] transforms\n",
            &[TRANSFORM_STAMPED, HEADER, TIME, TRANSFORM, VECTOR3, QUATERNION],
        ),
        "soilctl_msgs/msg/ControllerStep" => (include_str!("../../msg/ControllerStep.msg"), &[EVENT]),
        "soilctl_msgs/msg/Keyframe" => (include_str!("../../msg/Keyframe.msg"), &[]),
        "soilctl_msgs/msg/SoilTruth" => (include_str!("../../msg/SoilTruth.msg"), &[]),
        _ => return None,
    };
    let mut text = body.to_owned();
    for (name, body) in parts {
        text += &format!("{}\nMSG: {name}\n{body}", "=".repeat(80));
    }
    Some(text)
}
