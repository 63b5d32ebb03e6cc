//! Common types of ROS, for recordings that carry no definitions, as those of ROS 2 before Iron.

use super::Ros;

const TYPES: [(&str, &str); 19] = [
    ("geometry_msgs/Quaternion", "float64 x\nfloat64 y\nfloat64 z\nfloat64 w"),
    ("geometry_msgs/Transform", "geometry_msgs/Vector3 translation\ngeometry_msgs/Quaternion rotation"),
    (
        "geometry_msgs/TransformStamped",
        "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/Transform transform",
    ),
    ("geometry_msgs/Vector3", "float64 x\nfloat64 y\nfloat64 z"),
    ("geometry_msgs/Wrench", "geometry_msgs/Vector3 force\ngeometry_msgs/Vector3 torque"),
    ("geometry_msgs/WrenchStamped", "std_msgs/Header header\ngeometry_msgs/Wrench wrench"),
    (
        "sensor_msgs/JointState",
        "std_msgs/Header header\nstring[] name\nfloat64[] position\nfloat64[] velocity\nfloat64[] effort",
    ),
    (
        "sensor_msgs/PointCloud2",
        "std_msgs/Header header\nuint32 height\nuint32 width\nsensor_msgs/PointField[] fields\nbool is_bigendian\nuint32 point_step\n\
         uint32 row_step\nuint8[] data\nbool is_dense",
    ),
    ("sensor_msgs/PointField", "string name\nuint32 offset\nuint8 datatype\nuint32 count"),
    ("std_msgs/Bool", "bool data"),
    ("std_msgs/Empty", ""),
    ("std_msgs/Float32", "float32 data"),
    ("std_msgs/Float64", "float64 data"),
    ("std_msgs/Float64MultiArray", "std_msgs/MultiArrayLayout layout\nfloat64[] data"),
    ("std_msgs/Int32", "int32 data"),
    ("std_msgs/MultiArrayDimension", "string label\nuint32 size\nuint32 stride"),
    ("std_msgs/MultiArrayLayout", "std_msgs/MultiArrayDimension[] dim\nuint32 data_offset"),
    ("std_msgs/String", "string data"),
    ("tf2_msgs/TFMessage", "geometry_msgs/TransformStamped[] transforms"),
];

/// The fields of a common type, by its short name.
pub(super) fn body(ros: Ros, short_name: &str) -> Option<&'static str> {
    match (short_name, ros) {
        ("std_msgs/Header", Ros::One) => Some("uint32 seq\ntime stamp\nstring frame_id"),
        ("std_msgs/Header", Ros::Two) => Some("builtin_interfaces/Time stamp\nstring frame_id"),
        // The older name of the same, as ROS 1 recorded it for years.
        ("tf/tfMessage", _) => body(ros, "tf2_msgs/TFMessage"),
        _ => TYPES.iter().find(|(name, _)| *name == short_name).map(|(_, body)| *body),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::definition::Definition;

    #[test]
    fn all_can_be_resolved() {
        for ros in [Ros::One, Ros::Two] {
            for name in TYPES.iter().map(|(name, _)| *name).chain(["std_msgs/Header", "tf/tfMessage"]) {
                assert!(Definition::parse(ros, name, "").is_ok(), "{name}");
            }
        }
    }
}
