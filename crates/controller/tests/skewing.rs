//! Figure 5-6: the direction of the tip's force for an error, under the joint PID and under Cartesian stiffness.
#![allow(clippy::unwrap_used, clippy::print_stdout)]

use soilctl_controller::Params;
use soilctl_controller::laws::Skew;
use soilctl_kinematics::{
    CylindricalStiffness, JointTorques, KinematicsError, TaskPose, TaskVelocity, Wrist,
};

const INCH_M: f64 = 0.0254;

fn digging(inches: f64, base_rad: f64, alpha_deg: f64) -> TaskPose {
    TaskPose::digging(inches * INCH_M, base_rad, -12.5 * INCH_M, alpha_deg.to_radians()).unwrap()
}

#[test]
fn pid_skews_the_force_and_stiffness_control_does_not() {
    let params = Params::thesis();
    println!("radius | error | PID | stiffness");
    let mut worst = 0.0_f64;
    for (inches, base_rad) in [(8.0, 0.0), (12.0, 0.3), (17.0, -0.4)] {
        for direction_deg in [0.0, 45.0, 90.0, 135.0, 180.0, 270.0] {
            let skew =
                Skew::new(&params, &digging(inches, base_rad, 90.0), f64::to_radians(direction_deg)).unwrap();
            let (pid, stiffness) = (skew.pid_rad.to_degrees(), skew.stiffness_rad.to_degrees());
            println!("{inches} in | {direction_deg} deg | {pid:.1} deg | {stiffness:.1e} deg");
            assert!(stiffness.abs() <= 1e-6, "{stiffness} deg");
            worst = worst.max(pid.abs());
        }
    }
    // "Widely skewed": no loop about it could do with one gain.
    assert!(worst > 30.0, "{worst} deg");
}

/// The work of the springs, found without the Jacobian: along its error the force of springs in the joints is positive, and the
/// opposite error has the opposite force.
#[test]
fn springs_pull_towards_where_they_are_to_go() {
    let params = Params::thesis();
    for inches in [8.0, 12.0, 17.0] {
        for direction_deg in [10.0, 100.0, 200.0, 330.0_f64] {
            let at = |deg: f64| Skew::new(&params, &digging(inches, 0.2, 90.0), deg.to_radians()).unwrap();
            let (here, opposite) = (at(direction_deg), at(direction_deg + 180.0));
            assert!(here.pid_rad.abs() < std::f64::consts::FRAC_PI_2, "{} rad", here.pid_rad);
            assert!((here.pid_rad - opposite.pid_rad).abs() < 1e-9);
        }
    }
}

/// Equal springs: the force is the error times their stiffness in all three directions, found from the torques, and it does their work,
/// torque times joint rate being force times tip speed.
#[test]
fn the_force_of_equal_springs_is_along_the_error_and_does_the_work_of_the_torques() {
    let params = Params::thesis();
    let arm = params.arm();
    for (inches, base_rad) in [(8.0, 0.0), (12.0, 0.3), (17.0, -0.4)] {
        let joints = arm.inverse(&digging(inches, base_rad, 90.0)).unwrap();
        let jacobian = arm.jacobian(&joints).unwrap();
        let springs = CylindricalStiffness::diagonal([4000.0, 4000.0, 4000.0, 0.0, 0.0]);
        let springs = springs.to_cartesian(base_rad).unwrap();
        let (s, c) = libm::sincos(base_rad);
        for error in [[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0], [0.6, 0.2, -0.5]] {
            let error = error.map(|part| 0.001 * part);
            let displacement = TaskVelocity([error[0], error[1], error[2], 0.0, 0.0]);
            let torques = springs.joint_torques(&jacobian, &displacement, Wrist::Locked).unwrap();
            let force = arm.tip_force(&joints, &torques).unwrap();
            for i in 0..3 {
                assert!((force[i] - 4000.0 * error[i]).abs() < 1e-9, "{force:?} for {error:?}");
                let work: f64 = (0..3).map(|row| force[row] * jacobian.0[row][i]).sum();
                assert!((work - torques.0[i]).abs() < 1e-9, "{work} {}", torques.0[i]);
            }
        }
        let none = arm.tip_force(&joints, &JointTorques::default()).unwrap();
        assert!(none.iter().all(|part| part.abs() < 1e-12));
    }
}

/// Turning the base turns error and force alike.
#[test]
fn skewing_does_not_depend_on_the_base_angle() {
    let params = Params::thesis();
    let at = |base_rad: f64| Skew::new(&params, &digging(12.0, base_rad, 80.0), 0.7).unwrap().pid_rad;
    for base_rad in [-1.2, 0.4, 1.5] {
        assert!((at(base_rad) - at(0.0)).abs() < 1e-9, "{base_rad}");
    }
}

#[test]
fn a_place_out_of_reach_has_no_skew() {
    let found = Skew::new(&Params::thesis(), &digging(60.0, 0.0, 90.0), 0.0);
    assert!(matches!(found, Err(KinematicsError::Unreachable { .. })), "{found:?}");
}
