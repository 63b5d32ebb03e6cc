//! Forward and inverse kinematics undo each other, and the inverse keeps to its branch.
#![allow(clippy::unwrap_used, clippy::needless_range_loop)]

mod common;

use common::{branch_posture, forwards, largest, pose_error, posture};
use proptest::prelude::*;
use soilctl_kinematics::{Arm, JointAngles, KinematicsError, Singularity, TaskPose};

#[test]
fn straight_up_and_straight_forward() {
    let arm = Arm::thesis();
    let up = arm.forward(&JointAngles([0.0; 5])).unwrap();
    assert_eq!((up.x_m, up.y_m, up.n1_rad, up.n2_rad), (0.0, 0.0, 0.0, 0.0));
    assert!((up.z_m - (0.3302 + 0.9144)).abs() < 1e-15);
    let forward = arm.forward(&JointAngles::from_degrees([90.0, 90.0, 0.0, 0.0, 0.0])).unwrap();
    // 36 in, to the left since the base has turned by 90 degrees.
    assert!((forward.y_m - 36.0 * 0.0254).abs() < 1e-15 && forward.x_m.abs() < 1e-15);
    assert!((forward.z_m - 0.3302).abs() < 1e-15);
}

#[test]
fn a_grid_of_postures_comes_back() {
    let arm = Arm::thesis();
    let (lower, upper) = (arm.lower_limits().0, arm.upper_limits().0);
    let (mut worst_pose, mut worst_joint, mut count): (f64, f64, u32) = (0.0, 0.0, 0);
    let steps = [5, 9, 9, 7, 9];
    for n in 0..steps.iter().product::<usize>() {
        let mut rest = n;
        let joints = JointAngles(std::array::from_fn(|i| {
            let step = rest % steps[i];
            rest /= steps[i];
            lower[i] + (upper[i] - lower[i]) * step as f64 / (steps[i] - 1) as f64
        }));
        let pose = arm.forward(&joints).unwrap();
        if forwards(&arm, &joints) < 0.01 || pose.n2_rad.abs() > 1.55 {
            continue;
        }
        let found = arm.inverse(&pose).unwrap_or_else(|error| panic!("{:?}: {error}", joints.degrees()));
        worst_pose = worst_pose.max(pose_error(&arm.forward(&found).unwrap(), &pose));
        let loose = joints.0[4].sin().abs() * pose.n2_rad.cos();
        // A twist of 90 degrees one way with the wrist bent is the same as the other way with the wrist bent back.
        let unique = joints.0[3].abs() < 1.5;
        if loose > 1e-9 && unique {
            let error: [f64; 5] = std::array::from_fn(|i| found.0[i] - joints.0[i]);
            worst_joint = worst_joint.max(largest(error) * loose);
        }
        count += 1;
    }
    println!("{count} postures: pose {worst_pose:.1e}, joints {worst_joint:.1e}");
    assert!(count > 5000, "{count}");
    assert!(worst_pose < 1e-12, "{worst_pose:e}");
    assert!(worst_joint < 1e-11, "{worst_joint:e}");
}

#[test]
fn a_grid_of_poses_is_reached_or_refused() {
    let arm = Arm::thesis();
    let (mut reached, mut worst): (u32, f64) = (0, 0.0);
    for x in -4..=9 {
        for y in -8..=8 {
            for z in -7..=12 {
                for n1 in -2..=7 {
                    for n2 in [-1.2, -0.3, 0.0, 0.01, 0.8] {
                        let pose = TaskPose {
                            x_m: 0.1 * f64::from(x),
                            y_m: 0.1 * f64::from(y),
                            z_m: 0.1 * f64::from(z),
                            n1_rad: 0.6 * f64::from(n1),
                            n2_rad: n2,
                        };
                        let Ok(joints) = arm.inverse(&pose) else { continue };
                        reached += 1;
                        assert!(joints.0[2] > 0.0 && joints.0[3].abs() <= std::f64::consts::FRAC_PI_2);
                        arm.check_limits(&joints).unwrap();
                        assert!(forwards(&arm, &joints) > 0.0);
                        worst = worst.max(pose_error(&arm.forward(&joints).unwrap(), &pose));
                    }
                }
            }
        }
    }
    println!("{reached} poses: {worst:.1e}");
    assert!(reached > 10_000, "{reached}");
    assert!(worst < 1e-12, "{worst:e}");
}

/// An arm of other lengths and one of its postures on the branch of the inverse.
fn other_arm() -> impl Strategy<Value = (Arm, JointAngles)> {
    (posture(), prop::array::uniform4(0.05..1.0_f64), 0.0..0.3_f64).prop_filter_map(
        "tip in front of the base",
        |(joints, lengths, twist_m)| {
            let mut config = Arm::thesis().config().clone();
            let links = &mut config.links;
            [links.base_height_m, links.upper_arm_m, links.forearm_m, links.hand_m] = lengths;
            links.twist_m = twist_m;
            config.plate.height_m = 0.02;
            config.sensor.before_tip_m = 0.03;
            let arm = Arm::new(config).unwrap();
            let upright = arm.forward(&joints).unwrap().n2_rad.abs() < 1.5;
            (upright && forwards(&arm, &joints) > 0.01).then_some((arm, joints))
        },
    )
}

proptest! {
    #[test]
    fn the_inverse_finds_the_posture(joints in branch_posture()) {
        let arm = Arm::thesis();
        let pose = arm.forward(&joints).unwrap();
        let found = arm.inverse(&pose).unwrap();
        prop_assert!(pose_error(&arm.forward(&found).unwrap(), &pose) < 1e-12);
        // A nearly straight wrist or an upright hand determines theta_3 and theta_4 badly.
        let loose = joints.0[4].sin().abs() * pose.n2_rad.cos();
        for i in 0..5 {
            prop_assert!((found.0[i] - joints.0[i]).abs() * loose < 1e-12, "{i}: {joints:?} {found:?}");
        }
    }

    #[test]
    fn other_arms_are_inverted_too((arm, joints) in other_arm()) {
        let pose = arm.forward(&joints).unwrap();
        let found = arm.inverse(&pose).unwrap();
        prop_assert!(pose_error(&arm.forward(&found).unwrap(), &pose) < 1e-12);
        prop_assert!((found.0[2] - joints.0[2]).abs() < 1e-11, "{joints:?} {found:?}");
    }

    #[test]
    fn the_tip_frame_is_the_pose(joints in posture()) {
        let arm = Arm::thesis();
        let pose = arm.forward(&joints).unwrap();
        let frames = arm.frames(&joints).unwrap();
        for (a, b) in frames.plate_tip.origin_m.into_iter().zip(pose.position_m()) {
            prop_assert!((a - b).abs() < 1e-14);
        }
        // u_e of eq. B.40 from n1 and n2.
        let (s0, c0) = joints.0[0].sin_cos();
        let (s1, c1) = pose.n1_rad.sin_cos();
        let (s2, c2) = pose.n2_rad.sin_cos();
        let expected = [c2 * s1 * c0 - s2 * s0, c2 * s1 * s0 + s2 * c0, c2 * c1];
        for (a, b) in frames.plate_tip.direction([0.0, 0.0, 1.0]).into_iter().zip(expected) {
            prop_assert!((a - b).abs() < 1e-13);
        }
    }

    #[test]
    fn quaternions_turn_as_the_matrices_do(joints in posture(), point in prop::array::uniform3(-1.0..1.0_f64)) {
        for (_, frame) in Arm::thesis().frames(&joints).unwrap().named() {
            let [x, y, z, w] = frame.quaternion_xyzw();
            let cross = |a: [f64; 3], b: [f64; 3]| {
                [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
            };
            let inner = cross([x, y, z], point);
            let turned = cross([x, y, z], std::array::from_fn(|i| inner[i] + w * point[i]));
            for i in 0..3 {
                let by_quaternion = point[i] + 2.0 * turned[i];
                prop_assert!((by_quaternion - frame.direction(point)[i]).abs() < 1e-14);
            }
        }
    }
}

#[test]
fn refusals_name_their_reason() {
    let arm = Arm::thesis();
    let down = |x_m, y_m, z_m| TaskPose { x_m, y_m, z_m, n1_rad: std::f64::consts::PI, n2_rad: 0.0 };
    let far = arm.inverse(&down(1.0, 0.0, 0.0)).unwrap_err();
    assert!(matches!(far, KinematicsError::Unreachable { distance_m, .. } if distance_m > 0.78), "{far}");
    assert!(far.to_string().contains("reach from 0.0254 m to 0.7874 m"), "{far}");
    let behind = arm.inverse(&down(-0.4, 0.0, -0.3)).unwrap_err();
    assert!(behind.to_string().starts_with("the base joint would be at 180 deg"), "{behind}");
    let axis = arm.inverse(&down(0.0, 0.0, 0.0)).unwrap_err();
    assert!(matches!(axis, KinematicsError::Singular { place: Singularity::BaseAxis, .. }), "{axis}");
    let sideways = TaskPose { n2_rad: std::f64::consts::FRAC_PI_2, ..down(0.4, 0.0, 0.0) };
    let sideways = arm.inverse(&sideways).unwrap_err();
    assert!(
        matches!(sideways, KinematicsError::Singular { place: Singularity::SidewaysHand, .. }),
        "{sideways}"
    );
    let nan = arm.inverse(&down(0.4, f64::NAN, 0.0)).unwrap_err();
    assert!(matches!(nan, KinematicsError::NonFinite { quantity: "task position", .. }), "{nan}");
    let folded = arm.inverse(&down(0.15, 0.0, 0.2)).unwrap_err();
    assert!(matches!(folded, KinematicsError::OutOfLimits { .. }), "{folded}");
}

#[test]
fn limits_count_as_inside_and_are_not_moved() {
    let arm = Arm::thesis();
    for pick in 0..32_u32 {
        let joints = JointAngles(std::array::from_fn(|i| {
            if pick >> i & 1 == 0 { arm.lower_limits().0[i] } else { arm.upper_limits().0[i] }
        }));
        arm.check_limits(&joints).unwrap();
    }
    let mut beyond = JointAngles::from_degrees([0.0, 90.0, 60.0, 0.0, 0.0]);
    beyond.0[2] = arm.upper_limits().0[2] + 1e-6;
    let error = arm.check_limits(&beyond).unwrap_err();
    assert!(error.to_string().contains("elbow joint would be at 150.0000"), "{error}");
}

#[test]
fn a_twist_length_lengthens_the_forearm() {
    let mut config = Arm::thesis().config().clone();
    config.links.twist_m = 0.05;
    config.links.forearm_m -= 0.05;
    let split = Arm::new(config).unwrap();
    let joints = JointAngles::from_degrees([10.0, 100.0, 50.0, 20.0, 30.0]);
    let (a, b) = (split.forward(&joints).unwrap(), Arm::thesis().forward(&joints).unwrap());
    assert!(pose_error(&a, &b) < 1e-15);
    assert!(pose_error(&split.forward(&split.inverse(&a).unwrap()).unwrap(), &a) < 1e-12);
}

/// The force sensor's frame, turned joint by joint, against the short way.
#[test]
fn the_sensor_turns_as_its_frame_does() {
    let arm = Arm::thesis();
    let joints = JointAngles([0.3, 0.7, 1.1, -0.4, 0.6]);
    let force = [1.0, -2.0, 3.0];
    let expected = arm.frames(&joints).unwrap().ft_sensor.direction(force);
    let here = arm.at(&joints).unwrap();
    for (a, b) in here.rtz_to_base(here.sensor_to_rtz(force)).iter().zip(expected) {
        assert!((a - b).abs() < 1e-12, "{a} {b}");
    }
}
