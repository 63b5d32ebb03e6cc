//! Postures and tolerances shared by the tests.
#![allow(dead_code, clippy::unwrap_used, clippy::needless_range_loop)]

use std::f64::consts::TAU;

use proptest::prelude::*;
use soilctl_kinematics::{Arm, JointAngles, TaskPose};

/// Any posture within the limits of the thesis's arm.
pub(crate) fn posture() -> impl Strategy<Value = JointAngles> {
    let arm = Arm::thesis();
    let (lower, upper) = (arm.lower_limits().0, arm.upper_limits().0);
    prop::array::uniform5(0.0..1.0_f64).prop_map(move |part| {
        JointAngles(std::array::from_fn(|i| lower[i] + part[i] * (upper[i] - lower[i])))
    })
}

/// A posture on the branch of the inverse: the tip in front of the base axis, the hand not sideways.
pub(crate) fn branch_posture() -> impl Strategy<Value = JointAngles> {
    posture().prop_filter("tip in front of the base", |joints| {
        let pose = Arm::thesis().forward(joints).unwrap();
        forwards(&Arm::thesis(), joints) > 0.02 && pose.n2_rad.abs() < 1.5
    })
}

/// A posture as used for digging: plate level, elbow well bent.
pub(crate) fn digging_posture() -> impl Strategy<Value = JointAngles> {
    (0.2..0.55_f64, -0.6..0.6_f64, -0.36..-0.30_f64, 1.2..1.75_f64).prop_filter_map(
        "within the limits",
        |(radius, base, height, alpha)| {
            Arm::thesis().inverse(&TaskPose::digging(radius, base, height, alpha).unwrap()).ok()
        },
    )
}

/// The tip's coordinate r' in the arm's plane.
pub(crate) fn forwards(arm: &Arm, joints: &JointAngles) -> f64 {
    let pose = arm.forward(joints).unwrap();
    pose.x_m * joints.0[0].cos() + pose.y_m * joints.0[0].sin()
}

/// Difference of two poses, n1 taken modulo a turn.
pub(crate) fn pose_error(a: &TaskPose, b: &TaskPose) -> f64 {
    let turn = a.n1_rad - b.n1_rad;
    let parts =
        [a.x_m - b.x_m, a.y_m - b.y_m, a.z_m - b.z_m, turn - TAU * (turn / TAU).round(), a.n2_rad - b.n2_rad];
    largest(parts)
}

/// Largest size among some numbers.
pub(crate) fn largest<const N: usize>(values: [f64; N]) -> f64 {
    values.into_iter().fold(0.0, |most, value| f64::max(most, value.abs()))
}

/// Product of two 5 x 5 matrices.
pub(crate) fn product(a: &[[f64; 5]; 5], b: &[[f64; 5]; 5]) -> [[f64; 5]; 5] {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..5).map(|k| a[i][k] * b[k][j]).sum()))
}

/// Determinant by elimination with pivots.
pub(crate) fn determinant(mut m: [[f64; 5]; 5]) -> f64 {
    let mut result = 1.0;
    for k in 0..5 {
        let pivot = (k..5).max_by(|&a, &b| m[a][k].abs().total_cmp(&m[b][k].abs())).unwrap();
        if pivot != k {
            m.swap(pivot, k);
            result = -result;
        }
        result *= m[k][k];
        if m[k][k] == 0.0 {
            return 0.0;
        }
        for i in k + 1..5 {
            let factor = m[i][k] / m[k][k];
            for j in k..5 {
                m[i][j] -= factor * m[k][j];
            }
        }
    }
    result
}
