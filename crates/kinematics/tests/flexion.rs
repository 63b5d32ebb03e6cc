//! Cable stretch: found from pushes, taken out of the encoders.
#![allow(clippy::unwrap_used, clippy::needless_range_loop)]

mod common;

use common::{digging_posture, largest};
use proptest::prelude::*;
use soilctl_kinematics::{
    Arm, Compliance, JointAngles, KinematicsError, Push, TaskPose, thesis_elbow_offset_rad,
};

const TRUE: Compliance = Compliance { rad_per_nm: [[2e-4, 3e-5], [5e-5, 1.0 / 260.0]] };

/// The pushes of a synthetic arm: the end is held, the encoders move by C J^T F.
fn push(arm: &Arm, contact: JointAngles, plate_on_stop_n: [f64; 3]) -> Push {
    let [tau_1, tau_2] = arm.shoulder_elbow_torques(&contact, plate_on_stop_n).unwrap();
    let mut pressed = contact;
    for (joint, [a, b]) in [1, 2].into_iter().zip(TRUE.rad_per_nm) {
        pressed.0[joint] += a * tau_1 + b * tau_2;
    }
    Push { contact, pressed, plate_on_stop_n }
}

fn pushes(arm: &Arm) -> Vec<Push> {
    let mut list = Vec::new();
    for radius in [0.25, 0.35, 0.45] {
        for (x, z) in [(-15.0, 0.0), (-8.0, -10.0), (0.0, -20.0), (12.0, 3.0)] {
            let pose = TaskPose::digging(radius, 0.0, -0.33, 90f64.to_radians()).unwrap();
            list.push(push(arm, arm.inverse(&pose).unwrap(), [x, 0.0, z]));
        }
    }
    list
}

#[test]
fn the_compliance_is_recovered() {
    let arm = Arm::thesis();
    let fit = Compliance::fit(&arm, &pushes(&arm)).unwrap();
    let error = fit.compliance.rad_per_nm.map(|row| row.map(|c| c * 260.0));
    for (found, expected) in error.iter().flatten().zip(TRUE.rad_per_nm.iter().flatten()) {
        assert!((found - expected * 260.0).abs() < 1e-12, "{found}");
    }
    assert!(fit.rms_rad[0] < 1e-15 && fit.rms_rad[1] < 1e-15 && fit.pushes == 12, "{fit:?}");
    assert!((fit.compliance.elbow_stiffness_nm_per_rad().unwrap() - 260.0).abs() < 1e-9);
}

/// With 3600 counts a turn the elbow's stiffness still comes out within a few per cent.
#[test]
fn coarse_encoders_do_not_bias_the_elbow() {
    let arm = Arm::thesis();
    let count = (0.1_f64).to_radians();
    let coarse: Vec<Push> = pushes(&arm)
        .into_iter()
        .map(|mut push| {
            push.contact.0 = push.contact.0.map(|angle| (angle / count).round() * count);
            push.pressed.0 = push.pressed.0.map(|angle| (angle / count).round() * count);
            push
        })
        .collect();
    let fit = Compliance::fit(&arm, &coarse).unwrap();
    let stiffness = fit.compliance.elbow_stiffness_nm_per_rad().unwrap();
    println!("{stiffness} N m/rad, rms {:?}", fit.rms_rad);
    assert!((stiffness / 260.0 - 1.0).abs() < 0.05, "{stiffness}");
    assert!(fit.rms_rad[1] > 1e-5 && fit.rms_rad[1] < count, "{fit:?}");
}

#[test]
fn the_elbow_alone_needs_one_push() {
    let arm = Arm::thesis();
    let elbow = Compliance::of_elbow(260.0).unwrap();
    let pose = TaskPose::digging(0.4, 0.1, -0.33, 80f64.to_radians()).unwrap();
    let contact = arm.inverse(&pose).unwrap();
    let mut one = push(&arm, contact, [-14.0, 1.0, 0.0]);
    one.pressed = contact;
    one.pressed.0[2] += arm.shoulder_elbow_torques(&contact, one.plate_on_stop_n).unwrap()[1] / 260.0;
    let fit = Compliance::fit_elbow(&arm, &[one]).unwrap();
    assert!((fit.compliance.rad_per_nm[1][1] * 260.0 - 1.0).abs() < 1e-12);
    assert_eq!(arm.elbow_compliance(), elbow);
    let error = Compliance::fit(&arm, &[one, one]).unwrap_err();
    assert!(matches!(error, KinematicsError::Pushes { used: 2, given: 2, .. }), "{error}");
    let error = Compliance::fit_elbow(&arm, &[]).unwrap_err();
    assert!(matches!(error, KinematicsError::Pushes { given: 0, .. }), "{error}");
}

proptest! {
    #[test]
    fn compensation_finds_the_true_posture(
        truth in digging_posture(), force in prop::array::uniform3(-20.0..20.0_f64),
    ) {
        let arm = Arm::thesis();
        // The soil turns the true joints; the encoders lag behind.
        let [tau_1, tau_2] = arm.shoulder_elbow_torques(&truth, force).unwrap();
        let mut encoder = truth;
        for (joint, [a, b]) in [1, 2].into_iter().zip(TRUE.rad_per_nm) {
            encoder.0[joint] -= a * tau_1 + b * tau_2;
        }
        let found = arm.compensate_flexion(&encoder, force, &TRUE).unwrap();
        prop_assert!(largest(std::array::from_fn::<_, 5, _>(|i| found.0[i] - truth.0[i])) < 1e-7);
    }

    #[test]
    fn a3_is_exact_for_a_straight_wrist(
        theta_1 in 1.5..2.2_f64, theta_2 in 0.5..1.5_f64, delta in -1.5..1.5_f64, size in 0.0..20.0_f64,
    ) {
        let arm = Arm::thesis();
        let joints = JointAngles([0.0, theta_1, theta_2, 0.0, 0.0]);
        let hand = arm.frames(&joints).unwrap().hand;
        let force = hand.direction([size * delta.cos(), 0.0, size * delta.sin()]);
        let torque = arm.shoulder_elbow_torques(&joints, force).unwrap()[1];
        let lever = 0.381 + 0.127;
        let a3 = thesis_elbow_offset_rad(size, lever, 0.0, delta, 260.0).unwrap();
        prop_assert!((a3 - torque / 260.0).abs() < 1e-15);
    }

    #[test]
    fn what_a3_neglects_for_a_bent_wrist(joints in digging_posture(), delta in -1.5..1.5_f64) {
        // Exact: forearm and hand have levers of their own, l2 cos(theta_4 - delta) + l4 cos(delta).
        let arm = Arm::thesis();
        let frames = arm.frames(&joints).unwrap();
        let force = frames.hand.direction([15.0 * delta.cos(), 0.0, 15.0 * delta.sin()]);
        let exact = arm.shoulder_elbow_torques(&joints, force).unwrap()[1] / 260.0;
        let gap: [f64; 3] = std::array::from_fn(|i| frames.plate_tip.origin_m[i] - frames.forearm.origin_m[i]);
        let lever = gap.iter().map(|g| g * g).sum::<f64>().sqrt();
        let a3 = thesis_elbow_offset_rad(15.0, lever, joints.0[4], delta, 260.0).unwrap();
        let (along, bent) = (delta.cos(), (joints.0[4] - delta).cos());
        let neglected = (0.127 * (along - bent) + (0.381 + 0.127 - lever) * bent) * 15.0 / 260.0;
        prop_assert!((exact - a3 - neglected).abs() < 1e-15, "{a3} {exact} {neglected}");
    }
}

#[test]
fn an_arm_of_rubber_is_refused() {
    let arm = Arm::thesis();
    let joints = JointAngles::from_degrees([0.0, 110.0, 60.0, 0.0, 10.0]);
    let rubber = Compliance::of_elbow(3.0).unwrap();
    let error = arm.compensate_flexion(&joints, [0.0, 0.0, 100.0], &rubber).unwrap_err();
    assert!(error.to_string().contains("too soft"), "{error}");
    assert!(Compliance::of_elbow(0.0).is_err() && Compliance::of_elbow(f64::NAN).is_err());
}
