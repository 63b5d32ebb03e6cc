//! Figure 5-6: the direction of the tip's force for an error along r or z, under the joint PID and under Cartesian stiffness.
#![allow(clippy::unwrap_used, clippy::print_stdout)]

use soilctl_controller::Params;
use soilctl_kinematics::{JointTorques, TaskPose, TaskVelocity, Wrist};

const INCH_M: f64 = 0.0254;

/// Angle in degrees from the error (along r or z) to the force, both in the plane (r, z), with the wrist locked.
fn skew_deg([r, _, z]: [f64; 3], error: [f64; 2]) -> f64 {
    libm::atan2(error[0] * z - error[1] * r, error[0] * r + error[1] * z).to_degrees()
}

/// Skew of PID and of stiffness control for an error of one unit at a radius.
fn skews(params: &Params, radius_m: f64, error: [f64; 2]) -> [f64; 2] {
    let arm = params.arm();
    let pose = TaskPose::digging(radius_m, 0.0, -12.5 * INCH_M, std::f64::consts::FRAC_PI_2).unwrap();
    let joints = arm.inverse(&pose).unwrap();
    let jacobian = arm.jacobian(&joints).unwrap();
    // Rows r and z (at a base angle of 0: x and z), columns shoulder and elbow.
    let [[a, b], [c, d]] = [0, 2].map(|row| [jacobian.0[row][1], jacobian.0[row][2]]);
    let det = a * d - b * c;
    let turned = [(d * error[0] - b * error[1]) / det, (a * error[1] - c * error[0]) / det];
    let gains = &params.config().gains;
    let gain = |joint: usize| gains.motor_p_nm_per_rad[joint] + gains.external_p_nm_per_rad[joint];
    let pid = JointTorques([0.0, gain(1) * turned[0], gain(2) * turned[1], 0.0, 0.0]);

    let [k_r, k_t, k_z] = gains.stiffness_n_per_m;
    let springs = soilctl_kinematics::CylindricalStiffness::diagonal([k_r, k_t, k_z, 0.0, 0.0]);
    let dx = TaskVelocity([error[0], 0.0, error[1], 0.0, 0.0]);
    let stiff =
        springs.to_cartesian(joints.0[0]).unwrap().joint_torques(&jacobian, &dx, Wrist::Locked).unwrap();
    [pid, stiff].map(|torques| skew_deg(arm.tip_force(&joints, &torques).unwrap(), error))
}

#[test]
fn pid_skews_the_force_and_stiffness_control_does_not() {
    let params = Params::thesis();
    println!("radius | error | PID | stiffness");
    let mut worst = 0.0_f64;
    for inches in [8.0, 12.0, 17.0] {
        for (name, error) in [("r", [1.0, 0.0]), ("z", [0.0, 1.0])] {
            let [pid, stiffness] = skews(&params, inches * INCH_M, error);
            println!("{inches} in | {name} | {pid:.1} deg | {stiffness:.1e} deg");
            assert!(stiffness.abs() <= 1e-6, "{stiffness} deg");
            worst = worst.max(pid.abs());
        }
    }
    // "Widely skewed": no loop about it could do with one gain.
    assert!(worst > 30.0, "{worst} deg");
}
