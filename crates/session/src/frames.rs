//! Frames of a log as transforms between parent and child, along the tree of the URDF.

use soilctl_kinematics::{Arm, Frame, JointAngles, KinematicsError};

use crate::messages::{Header, Quaternion, TfMessage, Time, Transform, TransformStamped};

/// The base frame of the arm and of the URDF.
pub(crate) const BASE: &str = "base_link";
/// The frame of the force sensor.
pub(crate) const SENSOR: &str = "ft_sensor";
/// The soil's surface below the base's origin, parallel to the base frame.
const SURFACE: &str = "soil_surface";
/// What `ft_sensor` and `plate_tip` are fixed to.
const HAND: &str = "hand_link";

/// The moving links at these joints.
///
/// # Errors
/// Those of [`Arm::frames`].
pub(crate) fn moving(arm: &Arm, joints: &JointAngles, stamp: Time) -> Result<TfMessage, KinematicsError> {
    let mut transforms = Vec::new();
    let mut parent: Option<(&str, Frame)> = None;
    for (name, frame) in arm.frames(joints)?.named().into_iter().take_while(|(name, _)| *name != SENSOR) {
        transforms.push(match parent {
            None => stamped(stamp, BASE, name, frame.origin_m, &frame),
            Some((parent_name, parent)) => between(stamp, (parent_name, &parent), (name, &frame)),
        });
        parent = Some((name, frame));
    }
    Ok(TfMessage { transforms })
}

/// What does not move: sensor and tip on the hand, the soil's surface below the base.
///
/// # Errors
/// Those of [`Arm::frames`].
pub(crate) fn fixed(arm: &Arm, surface_z_m: f64, stamp: Time) -> Result<TfMessage, KinematicsError> {
    let frames = arm.frames(&JointAngles::default())?;
    let mut transforms: Vec<_> = frames
        .named()
        .iter()
        .skip_while(|(name, _)| *name != SENSOR)
        .map(|(name, frame)| between(stamp, (HAND, &frames.hand), (name, frame)))
        .collect();
    transforms.push(TransformStamped {
        header: Header { stamp, frame_id: BASE.to_owned() },
        child_frame_id: SURFACE.to_owned(),
        transform: Transform {
            translation: [0.0, 0.0, surface_z_m].into(),
            rotation: Quaternion { x: 0.0, y: 0.0, z: 0.0, w: 1.0 },
        },
    });
    Ok(TfMessage { transforms })
}

/// The child seen from its parent: both are given in the base frame.
fn between(
    stamp: Time,
    (parent_name, parent): (&str, &Frame),
    (name, child): (&str, &Frame),
) -> TransformStamped {
    let column = |matrix: &[[f64; 3]; 3], j: usize| [matrix[0][j], matrix[1][j], matrix[2][j]];
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let axes = [0, 1, 2].map(|i| column(&parent.rotation, i));
    let step = [0, 1, 2].map(|i| child.origin_m[i] - parent.origin_m[i]);
    let relative = Frame {
        rotation: axes.map(|axis| [0, 1, 2].map(|j| dot(axis, column(&child.rotation, j)))),
        origin_m: axes.map(|axis| dot(axis, step)),
    };
    stamped(stamp, parent_name, name, relative.origin_m, &relative)
}

fn stamped(stamp: Time, parent: &str, child: &str, origin_m: [f64; 3], frame: &Frame) -> TransformStamped {
    let [x, y, z, w] = frame.quaternion_xyzw();
    TransformStamped {
        header: Header { stamp, frame_id: parent.to_owned() },
        child_frame_id: child.to_owned(),
        transform: Transform { translation: origin_m.into(), rotation: Quaternion { x, y, z, w } },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rotate(q: Quaternion, v: [f64; 3]) -> [f64; 3] {
        let u = [q.x, q.y, q.z];
        let cross = |a: [f64; 3], b: [f64; 3]| {
            [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
        };
        let t = cross(u, v).map(|part| 2.0 * part);
        let s = cross(u, t);
        [0, 1, 2].map(|i| v[i] + q.w * t[i] + s[i])
    }

    /// Following the chain from the plate's tip to the base gives the pose of the closed form.
    #[test]
    fn the_chain_of_transforms_ends_at_the_forward_kinematics() {
        let arm = Arm::thesis();
        let joints = JointAngles([0.3, 0.7, 1.1, -0.4, 0.6]);
        let mut tree = moving(&arm, &joints, Time::default()).unwrap().transforms;
        tree.extend(fixed(&arm, -0.33, Time::default()).unwrap().transforms);
        let (mut point, mut frame) = ([0.0; 3], "plate_tip".to_owned());
        while frame != BASE {
            let link = tree.iter().find(|link| link.child_frame_id == frame).unwrap();
            let turned = rotate(link.transform.rotation, point);
            let t = link.transform.translation;
            point = [turned[0] + t.x, turned[1] + t.y, turned[2] + t.z];
            frame.clone_from(&link.header.frame_id);
        }
        let expected = arm.forward(&joints).unwrap().position_m();
        for (a, b) in point.iter().zip(expected) {
            assert!((a - b).abs() < 1e-12, "{point:?} {expected:?}");
        }
    }
}
