//! Inverse velocities: exact away from the straight wrist, exact at the tip everywhere.
#![allow(clippy::unwrap_used, clippy::needless_range_loop)]

mod common;

use common::{branch_posture, digging_posture, largest};
use proptest::prelude::*;
use soilctl_kinematics::{Arm, JointAngles, KinematicsError, Singularity, TaskVelocity};

fn error(arm: &Arm, joints: &JointAngles, wanted: &TaskVelocity) -> ([f64; 5], [f64; 2], [f64; 5]) {
    let solution = arm.inverse_velocity(joints, wanted).unwrap();
    let achieved = arm.jacobian(joints).unwrap().task_velocity(&solution.joints).unwrap();
    (std::array::from_fn(|i| wanted.0[i] - achieved.0[i]), solution.shortfall_rad_s, solution.joints.0)
}

fn velocity() -> impl Strategy<Value = TaskVelocity> {
    prop::array::uniform5(-1.0..1.0_f64).prop_map(TaskVelocity)
}

proptest! {
    #[test]
    fn exact_away_from_the_straight_wrist(
        joints in branch_posture().prop_filter("bent wrist", |joints| joints.0[4].sin().abs() >= 0.1),
        wanted in velocity(),
    ) {
        let arm = Arm::thesis();
        let n2 = arm.forward(&joints).unwrap().n2_rad;
        let (error, shortfall, rates) = error(&arm, &joints, &wanted);
        prop_assert_eq!(shortfall, [0.0; 2]);
        prop_assert!(largest(error) < 1e-13 * (10.0 + largest(rates)) / n2.cos().powi(2), "{:e}", largest(error));
    }

    #[test]
    fn the_tip_follows_and_the_shortfall_is_told(
        joints in branch_posture(), wrist in -0.12..0.12_f64, wanted in velocity(),
    ) {
        let arm = Arm::thesis();
        let mut joints = joints;
        joints.0[4] = wrist;
        prop_assume!(common::forwards(&arm, &joints).abs() > 0.02);
        let (error, shortfall, rates) = error(&arm, &joints, &wanted);
        let scale = 1e-13 * (10.0 + largest(rates));
        prop_assert!(largest([error[0], error[1], error[2]]) < scale, "{error:?}");
        prop_assert!((error[3] - shortfall[0]).abs() < scale && (error[4] - shortfall[1]).abs() < scale);
    }

    #[test]
    fn in_the_arms_plane_only_n2_is_damped(
        joints in digging_posture(), wrist in -0.12..0.12_f64, wanted in velocity(),
    ) {
        let arm = Arm::thesis();
        let mut joints = joints;
        joints.0[4] = wrist;
        prop_assert_eq!(joints.0[3], 0.0);
        let (error, shortfall, rates) = error(&arm, &joints, &wanted);
        let scale = 1e-13 * (10.0 + largest(rates));
        prop_assert!(largest([error[0], error[1], error[2], error[3]]) < scale, "{error:?}");
        prop_assert!((error[4] - shortfall[1]).abs() < scale);
        // Damping never asks for more than half of 1/damping times the wanted rate.
        prop_assert!(rates[3].abs() <= 0.5 / 0.05 * wanted.0[4].abs() * 1.2 + 1e-12, "{rates:?}");
        // A motion that keeps n2 needs no twist at all.
        let mut level = wanted;
        level.0[4] = 0.0;
        let solution = arm.inverse_velocity(&joints, &level).unwrap();
        prop_assert_eq!(solution.joints.0[3], 0.0);
        prop_assert!(largest(solution.shortfall_rad_s) == 0.0);
    }
}

#[test]
fn through_the_straight_wrist_without_a_jump() {
    let arm = Arm::thesis();
    let wanted = TaskVelocity([0.01, 0.02, -0.01, 0.1, 0.2]);
    let mut last: Option<[f64; 5]> = None;
    for step in -3000..=3000 {
        let wrist = 1e-4 * f64::from(step);
        let joints = JointAngles([0.2, 1.9, 1.0, 0.3, wrist]);
        let rates = arm.inverse_velocity(&joints, &wanted).unwrap().joints.0;
        if let Some(last) = last {
            let jump: [f64; 5] = std::array::from_fn(|i| rates[i] - last[i]);
            assert!(largest(jump) < 0.02, "{wrist}: {jump:?}");
        }
        last = Some(rates);
    }
}

#[test]
fn singular_postures_are_refused() {
    let arm = Arm::thesis();
    let wanted = TaskVelocity([0.01, 0.0, 0.0, 0.0, 0.0]);
    let place = |degrees| match arm.inverse_velocity(&JointAngles::from_degrees(degrees), &wanted) {
        Err(KinematicsError::Singular { place, .. }) => place,
        other => panic!("{other:?}"),
    };
    assert_eq!(place([0.0, 90.0, 0.0, 0.0, 30.0]), Singularity::StraightElbow);
    assert_eq!(place([0.0, 0.0, 0.0, 0.0, 0.0]), Singularity::BaseAxis);
    assert_eq!(place([0.0, 90.0, 60.0, 90.0, 90.0]), Singularity::SidewaysHand);
    // Where the tip is in line with the upper arm, forces at the tip cannot be told apart.
    let reach = 0.381 + 0.127 * 40f64.to_radians().cos();
    let bend = -(0.127 * 40f64.to_radians().sin()).atan2(reach).to_degrees();
    let joints = JointAngles::from_degrees([0.0, 90.0, bend, 0.0, 40.0]);
    let error =
        arm.tip_force(&joints, &soilctl_kinematics::JointTorques([0.0, 1.0, 1.0, 0.0, 0.0])).unwrap_err();
    assert!(matches!(error, KinematicsError::Singular { place: Singularity::TipInLine, .. }), "{error}");
}
