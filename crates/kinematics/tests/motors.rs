//! Joints and motors: exact inverse, work, home, and the meaning of differential and coupling.
#![allow(clippy::unwrap_used, clippy::needless_range_loop)]

mod common;

use common::{largest, posture, product};
use proptest::prelude::*;
use soilctl_kinematics::{
    Arm, JointAngles, JointTorques, JointVelocities, MotorAngles, MotorTorques, MotorVelocities,
};

fn identity() -> [[f64; 5]; 5] {
    std::array::from_fn(|i| std::array::from_fn(|j| f64::from(u8::from(i == j))))
}

/// The arm with other signs: bit i set means joint i is reversed.
fn signed(bits: u32) -> Arm {
    let mut config = Arm::thesis().config().clone();
    let joints = &mut config.joints;
    let entries =
        [&mut joints.base, &mut joints.shoulder, &mut joints.elbow, &mut joints.twist, &mut joints.wrist];
    for (i, joint) in entries.into_iter().enumerate() {
        joint.motor_sign = if bits >> i & 1 == 1 { -1 } else { 1 };
    }
    Arm::new(config).unwrap()
}

#[test]
fn the_matrices_are_exact_inverses_for_all_signs() {
    for bits in 0..32 {
        let arm = signed(bits);
        let (there, back) = (arm.transmission().joint_to_motor(), arm.transmission().motor_to_joint());
        assert_eq!(product(&there, &back), identity());
        assert_eq!(product(&back, &there), identity());
    }
}

#[test]
fn the_printed_matrix_is_singular() {
    let mut printed = Arm::thesis().transmission().joint_to_motor();
    printed[2][3] = -printed[2][3];
    assert_eq!(common::determinant(printed), 0.0);
    assert!(common::determinant(Arm::thesis().transmission().joint_to_motor()).abs() > 1.0);
}

#[test]
fn difference_bends_and_sum_twists() {
    let transmission = *Arm::thesis().transmission();
    let joints = |motors| transmission.joint_velocities(&MotorVelocities(motors)).unwrap().0;
    assert_eq!(joints([0.0, 0.0, 1.0, -1.0, 0.0]), [0.0, 0.0, 1.0, 0.0, 0.0]);
    assert_eq!(joints([0.0, 0.0, 1.0, 1.0, 0.0]), [0.0, 0.0, 0.0, -1.0, 0.0]);
    // With the elbow's motors held, the shoulder bends the elbow by the coupling ratio.
    assert_eq!(joints([0.0, 1.0, 0.0, 0.0, 0.0]), [0.0, 1.0, 0.58, 0.0, 0.0]);
}

#[test]
fn motors_are_zero_at_home() {
    for bits in [0, 13, 31] {
        let arm = signed(bits);
        let home = arm.transmission().home();
        assert_eq!(home.degrees().map(f64::round), [-100.0, -30.0, 150.0, -90.0, -110.0]);
        assert_eq!(arm.transmission().motor_angles(&home).unwrap(), MotorAngles([0.0; 5]));
        assert_eq!(arm.transmission().joint_angles(&MotorAngles([0.0; 5])).unwrap(), home);
    }
}

proptest! {
    #[test]
    fn angles_come_back(joints in posture(), bits in 0..32_u32) {
        let arm = signed(bits);
        let motors = arm.transmission().motor_angles(&joints).unwrap();
        let back = arm.transmission().joint_angles(&motors).unwrap();
        prop_assert!(largest(std::array::from_fn::<_, 5, _>(|i| back.0[i] - joints.0[i])) < 1e-14);
    }

    #[test]
    fn motors_and_joints_have_the_same_power(
        speeds in prop::array::uniform5(-3.0..3.0_f64),
        torques in prop::array::uniform5(-20.0..20.0_f64),
        bits in 0..32_u32,
    ) {
        let arm = signed(bits);
        let transmission = arm.transmission();
        let power = |a: [f64; 5], b: [f64; 5]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let motor_speeds = transmission.motor_velocities(&JointVelocities(speeds)).unwrap();
        let motor_torques = transmission.motor_torques(&JointTorques(torques)).unwrap();
        prop_assert!((power(speeds, torques) - power(motor_speeds.0, motor_torques.0)).abs() < 1e-12);
        let back = transmission.joint_torques(&motor_torques).unwrap();
        prop_assert!(largest(std::array::from_fn::<_, 5, _>(|i| back.0[i] - torques[i])) < 1e-13);
        let joint_torques = transmission.joint_torques(&MotorTorques(torques)).unwrap();
        let joint_speeds = transmission.joint_velocities(&MotorVelocities(speeds)).unwrap();
        prop_assert!((power(speeds, torques) - power(joint_speeds.0, joint_torques.0)).abs() < 1e-12);
    }

    #[test]
    fn other_ratios_are_inverse_to_rounding(coupling in -10.0..10.0_f64, differential in 0.01..100.0_f64) {
        let mut config = Arm::thesis().config().clone();
        config.transmission.coupling_ratio = coupling;
        config.transmission.differential_ratio = differential;
        let arm = Arm::new(config).unwrap();
        let found = product(&arm.transmission().joint_to_motor(), &arm.transmission().motor_to_joint());
        for (row, expected) in found.into_iter().zip(identity()) {
            prop_assert!(largest(std::array::from_fn::<_, 5, _>(|i| row[i] - expected[i])) < 1e-15);
        }
    }
}

/// The elbow's two motors share its torque equally; the shoulder's motor also carries the coupling's part.
#[test]
fn elbow_torque_is_shared() {
    let transmission = *Arm::thesis().transmission();
    let motors = transmission.motor_torques(&JointTorques([0.0, 0.0, 10.0, 0.0, 0.0])).unwrap();
    assert_eq!(motors.0, [0.0, 5.8, 5.0, -5.0, 0.0]);
    let _: JointAngles = transmission.home();
}
