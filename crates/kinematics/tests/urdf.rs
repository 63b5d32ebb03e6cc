//! The URDF as others read it: `urdf-rs` parses it, and the kinematics of `k` agree with ours.
#![allow(clippy::unwrap_used, clippy::needless_range_loop)]

mod common;

use common::posture;
use proptest::prelude::*;
use soilctl_kinematics::{Arm, Joint, JointAngles, urdf};

fn chain(arm: &Arm) -> k::Chain<f64> {
    k::Chain::from(urdf_rs::read_from_string(&urdf(arm)).unwrap())
}

#[test]
fn joints_limits_and_masses_survive() {
    let arm = Arm::thesis();
    let robot = urdf_rs::read_from_string(&urdf(&arm)).unwrap();
    assert_eq!(robot.name, "thesis");
    let moving: Vec<_> =
        robot.joints.iter().filter(|j| j.joint_type == urdf_rs::JointType::Revolute).collect();
    assert_eq!(moving.len(), 5);
    for (joint, parsed) in Joint::ALL.into_iter().zip(moving) {
        let i = joint.index();
        assert_eq!(parsed.name, joint.name());
        assert_eq!(parsed.limit.lower.to_bits(), arm.lower_limits().0[i].to_bits());
        assert_eq!(parsed.limit.upper.to_bits(), arm.upper_limits().0[i].to_bits());
        assert!(parsed.limit.effort > 0.0 && parsed.limit.velocity > 0.0);
    }
    let links: Vec<_> = robot.links.iter().map(|link| link.name.as_str()).collect();
    let ours = arm.frames(&JointAngles([0.0; 5])).unwrap();
    assert_eq!(links[0], "base_link");
    assert_eq!(links[1..], ours.named().map(|(name, _)| name));
    for link in &robot.links[1..6] {
        let inertia = &link.inertial.inertia;
        let (x, y, z) = (inertia.ixx, inertia.iyy, inertia.izz);
        // A real body: positive, and no moment above the sum of the others.
        assert!(x > 0.0 && z > 0.0 && x + y >= z && y + z >= x, "{}: {x} {y} {z}", link.name);
        assert_eq!(link.visual.len(), link.collision.len());
        assert!(!link.visual.is_empty());
    }
}

/// Potential energy from the URDF's masses is ours: counterweights included.
#[test]
fn masses_weigh_the_same() {
    let arm = Arm::thesis();
    let robot = urdf_rs::read_from_string(&urdf(&arm)).unwrap();
    for degrees in
        [[0.0, 90.0, 50.0, 0.0, 20.0], [20.0, 120.0, 80.0, -40.0, 60.0], [-50.0, -20.0, 140.0, 70.0, -80.0]]
    {
        let joints = JointAngles::from_degrees(degrees);
        let frames = arm.frames(&joints).unwrap();
        let energy: f64 = frames.named()[..5]
            .iter()
            .map(|(name, frame)| {
                let link = robot.links.iter().find(|link| link.name == *name).unwrap();
                let com = link.inertial.origin.xyz.0;
                link.inertial.mass.value * 9.80665 * frame.point_m(com)[2]
            })
            .sum();
        assert!((energy - arm.potential_energy_j(&joints).unwrap()).abs() < 1e-12, "{energy}");
    }
}

#[test]
fn degenerate_shapes_are_left_out() {
    let mut config = Arm::thesis().config().clone();
    config.links.base_height_m = 0.0;
    config.plate.height_m = config.links.hand_m;
    config.counterweights.elbow.mass_kg = 0.0;
    let text = urdf(&Arm::new(config).unwrap());
    urdf_rs::read_from_string(&text).unwrap();
    assert!(
        !text.contains("length=\"0\"") && !text.contains("radius=\"0\"") && !text.contains("NaN"),
        "{text}"
    );
}

proptest! {
    #[test]
    fn an_independent_chain_agrees(
        joints in posture(), twist_m in 0.0..0.2_f64, height_m in 0.0..0.6_f64, hand_m in 0.1..0.3_f64,
    ) {
        let mut config = Arm::thesis().config().clone();
        config.links.twist_m = twist_m;
        config.links.base_height_m = height_m;
        config.links.hand_m = hand_m;
        let arm = Arm::new(config).unwrap();
        let chain = chain(&arm);
        chain.set_joint_positions(&joints.0).unwrap();
        chain.update_transforms();
        for (name, ours) in arm.frames(&joints).unwrap().named() {
            let theirs = chain.find_link(name).unwrap().world_transform().unwrap();
            let rotation = theirs.rotation.to_rotation_matrix();
            for i in 0..3 {
                prop_assert!((theirs.translation.vector[i] - ours.origin_m[i]).abs() < 1e-12, "{name}");
                for j in 0..3 {
                    prop_assert!((rotation[(i, j)] - ours.rotation[i][j]).abs() < 1e-12, "{name}");
                }
            }
        }
        let tip = chain.find_link("plate_tip").unwrap().world_transform().unwrap();
        let pose = arm.forward(&joints).unwrap();
        for (theirs, ours) in tip.translation.vector.iter().zip(pose.position_m()) {
            prop_assert!((theirs - ours).abs() < 1e-12);
        }
    }
}
