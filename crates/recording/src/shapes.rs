//! The arm's shapes, from the URDF.

use std::collections::BTreeMap;

use urdf_rs::{Geometry, Pose, Robot, Visual};

use crate::rows::single;
use crate::rrd::{Column, Component, Values};

/// Where the URDF names no colour.
const GREY: [f64; 4] = [0.7, 0.7, 0.72, 1.0];
/// Filled, not as wires.
const SOLID: u8 = 3;

/// What is drawn of each link: name below the link's entity, and columns. Meshes are left out, since a log has none.
pub(crate) fn shapes(robot: &Robot) -> BTreeMap<String, Vec<(String, Vec<Column>)>> {
    let colours: BTreeMap<&str, [f64; 4]> = robot
        .materials
        .iter()
        .filter_map(|material| Some((material.name.as_str(), material.color.as_ref()?.rgba.0)))
        .collect();
    let of_link = |visuals: &[Visual]| {
        visuals
            .iter()
            .enumerate()
            .filter_map(|(number, visual)| {
                Some((format!("shape_{number}"), shape(visual, colour(visual, &colours))?))
            })
            .collect()
    };
    robot.links.iter().map(|link| (link.name.clone(), of_link(&link.visual))).collect()
}

fn colour(visual: &Visual, known: &BTreeMap<&str, [f64; 4]>) -> u32 {
    let material = visual.material.as_ref();
    let own = material.and_then(|material| Some(material.color.as_ref()?.rgba.0));
    let rgba = own.or_else(|| known.get(material?.name.as_str()).copied()).unwrap_or(GREY);
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to 255")]
    let bytes = rgba.map(|part| (part.clamp(0.0, 1.0) * 255.0).round() as u8);
    u32::from_be_bytes(bytes)
}

fn shape(visual: &Visual, colour: u32) -> Option<Vec<Column>> {
    let (archetype, mut columns) = match &visual.geometry {
        Geometry::Box { size } => {
            let half = single(size.0.map(|length| 0.5 * length));
            let sizes = Component::new("Boxes3D", "half_sizes", "HalfSize3D");
            ("Boxes3D", vec![Column::row(sizes, Values::Vectors(vec![half]))])
        }
        Geometry::Cylinder { radius, length } => {
            let [radius, length] = single([*radius, *length]);
            let lengths = Component::new("Cylinders3D", "lengths", "Length");
            let radii = Component::new("Cylinders3D", "radii", "Radius");
            let column = |component, value| Column::row(component, Values::Single(vec![value]));
            ("Cylinders3D", vec![column(lengths, length), column(radii, radius)])
        }
        Geometry::Sphere { radius } => {
            let sizes = Component::new("Ellipsoids3D", "half_sizes", "HalfSize3D");
            ("Ellipsoids3D", vec![Column::row(sizes, Values::Vectors(vec![single([*radius; 3])]))])
        }
        Geometry::Capsule { .. } | Geometry::Mesh { .. } => return None,
    };
    let Pose { xyz, rpy } = &visual.origin;
    let part = |field, kind| Component::new(archetype, field, kind);
    columns.extend([
        Column::row(part("centers", "Translation3D"), Values::Vectors(vec![single(xyz.0)])),
        Column::row(
            part("quaternions", "RotationQuat"),
            Values::Quaternions(vec![single(quaternion(rpy.0))]),
        ),
        Column::row(part("colors", "Color"), Values::Colours(vec![colour])),
        Column::row(part("fill_mode", "FillMode"), Values::Bytes(vec![SOLID])),
    ]);
    Some(columns)
}

/// URDF's roll, pitch and yaw, about fixed axes in this order, as a quaternion x, y, z, w.
fn quaternion([roll, pitch, yaw]: [f64; 3]) -> [f64; 4] {
    let [(sr, cr), (sp, cp), (sy, cy)] = [roll, pitch, yaw].map(|angle| (0.5 * angle).sin_cos());
    [
        sr * cp * cy - cr * sp * sy,
        cr * sp * cy + sr * cp * sy,
        cr * cp * sy - sr * sp * cy,
        cr * cp * cy + sr * sp * sy,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Quarter turns whose result is seen without computing: x goes to y, y to z, z to x.
    #[test]
    fn angles_turn_as_urdf_says() {
        let half = std::f64::consts::FRAC_1_SQRT_2;
        let quarter = std::f64::consts::FRAC_PI_2;
        let close = |a: [f64; 4], b: [f64; 4]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-15);
        assert!(close(quaternion([quarter, 0.0, 0.0]), [half, 0.0, 0.0, half]));
        assert!(close(quaternion([0.0, quarter, 0.0]), [0.0, half, 0.0, half]));
        assert!(close(quaternion([0.0, 0.0, quarter]), [0.0, 0.0, half, half]));
        // Roll first, then yaw, about the axes that stand still: the third of a turn about the diagonal.
        assert!(close(quaternion([quarter, 0.0, quarter]), [0.5, 0.5, 0.5, 0.5]));
    }

    #[test]
    fn every_shape_of_the_arm_is_drawn() {
        let text = soilctl_kinematics::urdf(&soilctl_kinematics::Arm::thesis());
        let robot = urdf_rs::read_from_string(&text).unwrap();
        let found = shapes(&robot);
        let count: usize = found.values().map(Vec::len).sum();
        assert_eq!(count, text.matches("<visual>").count());
        assert!(found["base_link"].is_empty() && found["hand_link"].len() == 2, "{:?}", found.keys());
    }
}
