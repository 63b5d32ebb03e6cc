//! Rotating a stiffness changes the coordinates, not the springs.
#![allow(clippy::unwrap_used, clippy::needless_range_loop)]

mod common;

use common::{digging_posture, largest, product};
use proptest::prelude::*;
use soilctl_kinematics::{Arm, CartesianStiffness, CylindricalStiffness, TaskVelocity, Wrist};

/// A symmetric matrix with coupled springs.
fn springs() -> impl Strategy<Value = CylindricalStiffness> {
    prop::array::uniform15(-1000.0..1000.0_f64).prop_map(|list| {
        let mut k = [[0.0; 5]; 5];
        let mut next = list.into_iter();
        for i in 0..5 {
            for j in 0..=i {
                let value = next.next().unwrap() + if i == j { 3000.0 } else { 0.0 };
                k[i][j] = value;
                k[j][i] = value;
            }
        }
        CylindricalStiffness(k)
    })
}

fn energy(k: &[[f64; 5]; 5], dx: [f64; 5]) -> f64 {
    0.5 * (0..5).map(|i| (0..5).map(|j| dx[i] * k[i][j] * dx[j]).sum::<f64>()).sum::<f64>()
}

proptest! {
    #[test]
    fn energy_does_not_depend_on_the_frame(
        springs in springs(), angle in -7.0..7.0_f64, dx in prop::array::uniform5(-0.1..0.1_f64),
    ) {
        let (s, c) = angle.sin_cos();
        let in_plane = [dx[0] * c + dx[1] * s, dx[1] * c - dx[0] * s, dx[2], dx[3], dx[4]];
        let fixed = springs.to_cartesian(angle).unwrap();
        let (a, b) = (energy(&fixed.0, dx), energy(&springs.0, in_plane));
        prop_assert!((a - b).abs() < 1e-12 * 3000.0, "{a} {b}");
        let back = fixed.to_cylindrical(angle).unwrap();
        for i in 0..5 {
            prop_assert!(largest(std::array::from_fn::<_, 5, _>(|j| back.0[i][j] - springs.0[i][j])) < 1e-11);
            prop_assert!(largest(std::array::from_fn::<_, 5, _>(|j| fixed.0[i][j] - fixed.0[j][i])) < 1e-11);
        }
    }

    #[test]
    fn turning_the_base_turns_the_response(joints in digging_posture(), turn in -0.5..0.5_f64) {
        // The same radial error at another base angle needs the same torques.
        let arm = Arm::thesis();
        let springs = CylindricalStiffness::diagonal([2000.0, 500.0, 3000.0, 0.0, 0.0]);
        let torques = |base: f64| {
            let mut joints = joints;
            joints.0[0] = base;
            let k = springs.to_cartesian(base).unwrap();
            let dx = TaskVelocity([0.01 * base.cos(), 0.01 * base.sin(), -0.004, 0.0, 0.0]);
            k.joint_torques(&arm.jacobian(&joints).unwrap(), &dx, Wrist::Locked).unwrap().0
        };
        let (a, b) = (torques(joints.0[0]), torques(turn));
        prop_assert!(largest(std::array::from_fn::<_, 5, _>(|i| a[i] - b[i])) < 1e-11);
    }

    #[test]
    fn the_torques_are_the_joint_stiffness_times_the_error(
        joints in digging_posture(), springs in springs(), dq in prop::array::uniform5(-0.01..0.01_f64),
    ) {
        // J^T K J as a matrix.
        let arm = Arm::thesis();
        let jacobian = arm.jacobian(&joints).unwrap();
        let k = springs.to_cartesian(joints.0[0]).unwrap();
        let transposed = std::array::from_fn(|i| std::array::from_fn(|j| jacobian.0[j][i]));
        let joint_stiffness = product(&transposed, &product(&k.0, &jacobian.0));
        let dx = jacobian.task_velocity(&soilctl_kinematics::JointVelocities(dq)).unwrap();
        let torques = k.joint_torques(&jacobian, &dx, Wrist::Driven).unwrap();
        for i in 0..5 {
            let expected: f64 = (0..5).map(|j| joint_stiffness[i][j] * dq[j]).sum();
            prop_assert!((torques.0[i] - expected).abs() < 1e-10);
        }
    }

    #[test]
    fn a_locked_wrist_presses_along_the_error(
        joints in digging_posture(), error in prop::array::uniform3(-0.01..0.01_f64),
    ) {
        // The point of Cartesian stiffness in the thesis (figure 5-6): the force has the direction of the error.
        let arm = Arm::thesis();
        let stiffness = CylindricalStiffness::diagonal([1500.0, 1500.0, 1500.0, 9.0, 9.0]);
        let k = stiffness.to_cartesian(joints.0[0]).unwrap();
        let dx = TaskVelocity([error[0], error[1], error[2], 0.3, -0.2]);
        let torques = k.joint_torques(&arm.jacobian(&joints).unwrap(), &dx, Wrist::Locked).unwrap();
        prop_assert_eq!(torques.0[4], 0.0);
        let force = arm.tip_force(&joints, &torques).unwrap();
        for i in 0..3 {
            prop_assert!((force[i] - 1500.0 * error[i]).abs() < 1e-11);
        }
    }
}

#[test]
fn a_quarter_turn_swaps_the_axes() {
    let k = CylindricalStiffness::diagonal([1.0, 2.0, 3.0, 4.0, 5.0]);
    let CartesianStiffness(turned) = k.to_cartesian(std::f64::consts::FRAC_PI_2).unwrap();
    assert!((turned[0][0] - 2.0).abs() < 1e-15 && (turned[1][1] - 1.0).abs() < 1e-15);
    assert_eq!((turned[2][2], turned[3][3], turned[4][4]), (3.0, 4.0, 5.0));
}
