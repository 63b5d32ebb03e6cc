//! Arms whose poses can be written down.
#![allow(clippy::unwrap_used)]

use std::f64::consts::FRAC_PI_2;

use nalgebra::{Isometry3, Point3, Translation3, UnitQuaternion, Vector3};
use soilctl_robot::{Chain, Urdf};

fn chain(joints: &str, end: &str) -> Chain {
    let links: String = ["a", "b", "c", "d"].iter().map(|name| format!("<link name=\"{name}\"/>")).collect();
    // Links that no joint holds hang on the root.
    let rest: String = ["b", "c", "d"]
        .iter()
        .filter(|name| !joints.contains(&format!("<child link=\"{name}\"/>")))
        .map(|name| {
            format!("<joint name=\"rest_{name}\" type=\"fixed\"><parent link=\"a\"/><child link=\"{name}\"/></joint>")
        })
        .collect();
    Urdf::parse(&format!("<robot name=\"arm\">{links}{joints}{rest}</robot>")).unwrap().chain(end).unwrap()
}

fn joint(kind: &str, [parent, child]: [&str; 2], xyz: &str, rpy: &str, axis: &str) -> String {
    format!(
        "<joint name=\"{parent}{child}\" type=\"{kind}\"><parent link=\"{parent}\"/><child link=\"{child}\"/>\
         <origin xyz=\"{xyz}\" rpy=\"{rpy}\"/><axis xyz=\"{axis}\"/></joint>"
    )
}

fn assert_at(pose: &Isometry3<f64>, expected: [f64; 3]) {
    let off = pose.translation.vector - Vector3::from(expected);
    assert!(off.norm() < 1e-14, "{pose}, expected {expected:?}");
}

#[test]
fn a_planar_arm_of_two_links() {
    let arm = chain(
        &[
            joint("revolute", ["a", "b"], "0 0 0", "0 0 0", "0 0 1"),
            joint("continuous", ["b", "c"], "0.4 0 0", "0 0 0", "0 0 2"),
            joint("fixed", ["c", "d"], "0.3 0 0", "0 0 0", "0 0 0"),
        ]
        .concat(),
        "d",
    );
    assert_eq!(
        (arm.link(), arm.joint_names(), arm.sliding()),
        ("d", &["ab".into(), "bc".into()][..], &[false; 2][..])
    );
    assert!(arm.turns());
    for (first, second) in [(0.0, 0.0), (0.3, -1.2), (-2.5, 3.0), (20.0, 0.1)] {
        let pose = arm.pose(&[first, second]).unwrap();
        let (x, y) = (0.4 * f64::cos(first), 0.4 * f64::sin(first));
        let sum: f64 = first + second;
        assert_at(&pose, [x + 0.3 * sum.cos(), y + 0.3 * sum.sin(), 0.0]);
        assert!(pose.rotation.angle_to(&UnitQuaternion::from_axis_angle(&Vector3::z_axis(), sum)) < 1e-7);
    }
}

#[test]
fn a_gantry_shifts_and_never_turns() {
    let gantry = chain(
        &[
            joint("prismatic", ["a", "b"], "0 0 1", "0 0 0", "1 0 0"),
            joint("prismatic", ["b", "c"], "0 0.2 0", "0 0 0", "0 -3 0"),
            joint("prismatic", ["c", "d"], "0 0 0", "0 0 0", "0 0 0.1"),
        ]
        .concat(),
        "d",
    );
    assert!(!gantry.turns());
    assert_eq!(gantry.sliding(), [true; 3]);
    let pose = gantry.pose(&[0.5, 0.7, -0.3]).unwrap();
    assert_at(&pose, [0.5, 0.2 - 0.7, 1.0 - 0.3]);
    assert_eq!(pose.rotation, UnitQuaternion::identity());
}

/// Roll, pitch and yaw are about axes that stay where they are: x, then y, then z.
#[test]
fn angles_of_an_origin_are_about_fixed_axes() {
    let arm =
        chain(&joint("fixed", ["a", "b"], "1 2 3", "1.5707963267948966 0 1.5707963267948966", "1 0 0"), "b");
    let pose = arm.pose(&[]).unwrap();
    // y: rolled up to z, where yaw leaves it. x: stays, then yaw takes it to y. z: rolled to -y, then yaw takes it to x.
    for (from, to) in
        [([0., 1., 0.], [0., 0., 1.]), ([1., 0., 0.], [0., 1., 0.]), ([0., 0., 1.], [1., 0., 0.])]
    {
        let turned = pose.rotation * Vector3::from(from);
        assert!((turned - Vector3::from(to)).norm() < 1e-15, "{from:?} to {turned}");
    }
    // Roll and pitch only: x is not rolled, but pitched down to -z; y is rolled to z and then pitched to x.
    let arm =
        chain(&joint("fixed", ["a", "b"], "0 0 0", "1.5707963267948966 1.5707963267948966 0", "1 0 0"), "b");
    let rotation = arm.pose(&[]).unwrap().rotation;
    assert!((rotation * Vector3::x() + Vector3::z()).norm() < 1e-15);
    assert!((rotation * Vector3::y() - Vector3::x()).norm() < 1e-15);
}

/// An axis is in the joint's frame, which its origin has turned already; the pose maps points of the link to the root.
#[test]
fn axes_are_in_the_frame_of_the_joint() {
    let arm = chain(&joint("revolute", ["a", "b"], "0 0 0.5", "1.5707963267948966 0 0", "0 1 0"), "b");
    let pose = arm.pose(&[FRAC_PI_2]).unwrap();
    // The axis is y, which the roll has put along z: a quarter turn about the vertical.
    let vertical = Isometry3::from_parts(
        Translation3::new(0.0, 0.0, 0.5),
        UnitQuaternion::from_axis_angle(&Vector3::z_axis(), FRAC_PI_2)
            * UnitQuaternion::from_axis_angle(&Vector3::x_axis(), FRAC_PI_2),
    );
    let point = Point3::new(0.1, 0.2, 0.3);
    assert!((pose * point - vertical * point).norm() < 1e-15);
}

/// Both fingers of a gripper, one of which follows the other at half the speed and in the other direction.
#[test]
fn a_follower_takes_the_position_of_its_leader() {
    let fingers = "<joint name=\"left\" type=\"prismatic\"><parent link=\"a\"/><child link=\"b\"/><axis xyz=\"0 1 0\"/></joint>\
        <joint name=\"right\" type=\"prismatic\"><parent link=\"a\"/><child link=\"c\"/><axis xyz=\"0 1 0\"/>\
        <mimic joint=\"left\" multiplier=\"-0.5\" offset=\"0.01\"/></joint>\
        <joint name=\"nail\" type=\"revolute\"><parent link=\"c\"/><child link=\"d\"/><axis xyz=\"1 0 0\"/>\
        <mimic joint=\"right\" multiplier=\"2\"/></joint>";
    let right = chain(fingers, "c");
    assert_eq!((right.joint_names(), right.sliding()), (&["left".to_owned()][..], &[true][..]));
    assert_at(&right.pose(&[0.04]).unwrap(), [0.0, -0.01, 0.0]);
    // It turns by a position in m: that of the finger.
    let nail = chain(fingers, "d");
    assert_eq!((nail.joint_names(), nail.sliding()), (&["left".to_owned()][..], &[true][..]));
    assert!(nail.turns() && !right.turns());
    assert!(
        (nail.pose(&[0.04]).unwrap().rotation.scaled_axis() - Vector3::new(-0.02, 0.0, 0.0)).norm() < 1e-15
    );
}

#[test]
fn positions_must_be_as_many_as_joints_and_finite() {
    let arm = chain(&joint("prismatic", ["a", "b"], "0 0 0", "0 0 0", "1 1 0"), "b");
    for bad in [&[][..], &[1.0, 2.0], &[f64::NAN], &[f64::INFINITY]] {
        assert_eq!(arm.pose(bad), None);
    }
    let turned = chain(&joint("revolute", ["a", "b"], "0 0 0", "0 0 0", "1 1 0"), "b");
    assert!(turned.pose(&[1e300]).is_some() && turned.pose(&[f64::NEG_INFINITY]).is_none());
    // The root itself, which nothing moves.
    let root = chain("", "a");
    assert!(!root.turns() && root.joint_names().is_empty() && root.pose(&[]) == Some(Isometry3::identity()));
}
