//! The Jacobian against differences, its determinant, and virtual work.
#![allow(clippy::unwrap_used, clippy::needless_range_loop)]

mod common;

use std::f64::consts::TAU;

use common::{determinant, forwards, posture};
use proptest::prelude::*;
use soilctl_kinematics::{Arm, JointAngles, JointVelocities, KinematicsError, Singularity, TaskForce};

fn pose_vector(arm: &Arm, joints: &JointAngles) -> [f64; 5] {
    let p = arm.forward(joints).unwrap();
    [p.x_m, p.y_m, p.z_m, p.n1_rad, p.n2_rad]
}

proptest! {
    #[test]
    fn central_differences(joints in posture()) {
        let arm = Arm::thesis();
        let cos_n2 = arm.forward(&joints).unwrap().n2_rad.cos();
        prop_assume!(cos_n2 > 0.1);
        let jacobian = arm.jacobian(&joints).unwrap();
        let here = pose_vector(&arm, &joints);
        let at = |column: usize, step: f64| {
            let mut moved = joints;
            moved.0[column] += step;
            let mut there = pose_vector(&arm, &moved);
            // Beyond |theta_3| = 90 deg, n1 jumps by a turn if the wrist is bent by more than a right angle.
            there[3] -= TAU * ((there[3] - here[3]) / TAU).round();
            there
        };
        for column in 0..5 {
            // Fourth order, so that neither truncation nor rounding is above 1e-10 where cos n2 is not small.
            let h = 1e-3;
            let (near_up, near_down) = (at(column, h), at(column, -h));
            let (far_up, far_down) = (at(column, 2.0 * h), at(column, -2.0 * h));
            for row in 0..5 {
                let slope = (8.0 * (near_up[row] - near_down[row]) - (far_up[row] - far_down[row])) / (12.0 * h);
                let error = (slope - jacobian.0[row][column]).abs();
                prop_assert!(error < 1e-8_f64.max(1e-11 / cos_n2.powi(5)), "{row} {column}: {error:e}");
            }
        }
    }

    #[test]
    fn determinant_is_the_product_of_the_singularities(joints in posture()) {
        let arm = Arm::thesis();
        let n2 = arm.forward(&joints).unwrap().n2_rad;
        prop_assume!(n2.cos() > 0.05);
        let links = arm.config().links;
        let [_, _, theta_2, _, theta_4] = joints.0;
        let expected = -forwards(&arm, &joints) * links.upper_arm_m * links.forearm_m * theta_2.sin() * theta_4.sin()
            / n2.cos();
        let found = determinant(arm.jacobian(&joints).unwrap().0);
        prop_assert!((found - expected).abs() < 1e-13 / n2.cos().powi(2), "{found} {expected}");
    }

    #[test]
    fn force_and_velocity_do_the_same_work(
        joints in posture(),
        rates in prop::array::uniform5(-2.0..2.0_f64),
        force in prop::array::uniform5(-20.0..20.0_f64),
    ) {
        let arm = Arm::thesis();
        let jacobian = arm.jacobian(&joints).unwrap();
        let (rates, force) = (JointVelocities(rates), TaskForce(force));
        let velocity = jacobian.task_velocity(&rates).unwrap();
        let torques = jacobian.joint_torques(&force).unwrap();
        let at_tip: f64 = velocity.0.iter().zip(force.0).map(|(a, b)| a * b).sum();
        let at_joints: f64 = torques.0.iter().zip(rates.0).map(|(a, b)| a * b).sum();
        let cos_n2 = arm.forward(&joints).unwrap().n2_rad.cos();
        prop_assert!((at_tip - at_joints).abs() < 1e-12 / cos_n2.powi(2), "{at_tip} {at_joints}");
    }

    #[test]
    fn tip_force_is_found_from_three_torques(
        joints in common::digging_posture(),
        force in prop::array::uniform3(-20.0..20.0_f64),
    ) {
        let arm = Arm::thesis();
        let [x, y, z] = force;
        let mut torques = arm.jacobian(&joints).unwrap().joint_torques(&TaskForce([x, y, z, 0.0, 0.0])).unwrap();
        // The locked joints' torques are not looked at.
        torques.0[3] = 77.0;
        torques.0[4] = -77.0;
        let found = arm.tip_force(&joints, &torques).unwrap();
        for i in 0..3 {
            prop_assert!((found[i] - force[i]).abs() < 1e-11, "{found:?} {force:?}");
        }
    }
}

#[test]
fn a_sideways_hand_has_no_pitch() {
    let arm = Arm::thesis();
    let joints = JointAngles::from_degrees([0.0, 90.0, 60.0, 90.0, 90.0]);
    let error = arm.jacobian(&joints).unwrap_err();
    assert!(matches!(error, KinematicsError::Singular { place: Singularity::SidewaysHand, .. }), "{error}");
    // The position is still known.
    assert!((arm.forward(&joints).unwrap().n2_rad.to_degrees() - 90.0).abs() < 1e-12);
}
