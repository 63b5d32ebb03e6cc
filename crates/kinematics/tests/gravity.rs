//! Weight torques are the slope of the potential energy, and the counterweights do their work.
#![allow(clippy::unwrap_used, clippy::needless_range_loop)]

mod common;

use common::{digging_posture, posture};
use proptest::prelude::*;
use soilctl_kinematics::{Arm, JointAngles};

fn slopes(arm: &Arm, joints: &JointAngles) -> [f64; 5] {
    let h = 1e-3;
    let at = |i: usize, step: f64| {
        let mut moved = *joints;
        moved.0[i] += step;
        arm.potential_energy_j(&moved).unwrap()
    };
    std::array::from_fn(|i| (8.0 * (at(i, h) - at(i, -h)) - (at(i, 2.0 * h) - at(i, -2.0 * h))) / (12.0 * h))
}

proptest! {
    #[test]
    fn torques_are_the_slope_of_the_energy(joints in posture(), twist_m in 0.0..0.2_f64, hand_kg in 0.1..3.0_f64) {
        let mut config = Arm::thesis().config().clone();
        config.links.twist_m = twist_m;
        config.masses.hand.mass_kg = hand_kg;
        config.masses.twist.com_m = 0.03;
        let arm = Arm::new(config).unwrap();
        let torques = arm.gravity_torques(&joints).unwrap();
        for (torque, slope) in torques.0.into_iter().zip(slopes(&arm, &joints)) {
            prop_assert!((torque - slope).abs() < 1e-9, "{torque} {slope}");
        }
    }

    #[test]
    fn the_counterweights_balance_the_arm(joints in digging_posture()) {
        let arm = Arm::thesis();
        let mut config = arm.config().clone();
        config.counterweights.shoulder.mass_kg = 0.0;
        config.counterweights.elbow.mass_kg = 0.0;
        let bare = Arm::new(config).unwrap().gravity_torques(&joints).unwrap();
        let left = arm.gravity_torques(&joints).unwrap();
        prop_assert!(bare.0[1].abs() > 1.0, "{bare:?}");
        // Only the bent wrist is left: 0.169 kg at 63.5 mm are 0.105 N m.
        let bent = 0.1053 * 2.0 * (0.5 * joints.0[4]).sin().abs() + 0.01;
        prop_assert!(left.0[1].abs() < bent && left.0[2].abs() < bent, "{left:?}");
    }
}

#[test]
fn the_straight_arm_is_balanced() {
    let arm = Arm::thesis();
    let left = arm.gravity_torques(&JointAngles::from_degrees([0.0, 90.0, 0.0, 0.0, 0.0])).unwrap();
    assert!(left.0[1].abs() < 0.01 && left.0[2].abs() < 0.01, "{left:?}");
}
