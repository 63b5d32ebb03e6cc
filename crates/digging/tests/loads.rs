//! Torques of a push against virtual work, ways against the arm's geometry, and the best tool angle against brute force.
#![allow(clippy::unwrap_used, reason = "tests")]

use soilctl_controller::Params;
use soilctl_digging::{Aim, Push, Soils, Task, load, way};
use soilctl_earth_pressure::plane_model;
use soilctl_kinematics::{Arm, JointAngles, TaskPose};

const SURFACE_Z_M: f64 = -0.3302;

/// A point of the plate, `up` m from its lower edge, in the base frame.
fn point(arm: &Arm, joints: &JointAngles, up: f64) -> [f64; 3] {
    let hand = arm.frames(joints).unwrap().hand;
    hand.point_m([0.0, 0.0, arm.config().links.hand_m - up])
}

/// The joint torques do the work of the force on its point and lift the arm's weight: both by finite differences.
#[test]
fn torques_do_the_work_of_the_force() {
    let params = Params::thesis();
    let arm = params.arm();
    for (radius, base_deg, alpha_deg, inclination_deg) in
        [(0.3048, 20.0_f64, 70.0_f64, 23.0_f64), (0.4318, -15.0, 95.0, -10.0), (0.36, 0.0, 85.0, 0.0)]
    {
        let pose = TaskPose::digging(radius, base_deg.to_radians(), -0.355, alpha_deg.to_radians()).unwrap();
        let joints = arm.inverse(&pose).unwrap();
        let push = Push { force_n: 12.0, inclination_rad: inclination_deg.to_radians(), up_m: 0.009 };
        let found = load(&params, &joints, &push, &[0.0; 5]).unwrap();
        // The force's direction, told by the plate itself: its normal towards the base, and down along it.
        let hand = arm.frames(&joints).unwrap().hand;
        let axis = |column: usize| [0, 1, 2].map(|row: usize| hand.rotation[row][column]);
        let (normal, down) = (axis(0), axis(2));
        let (sin, cos) = push.inclination_rad.sin_cos();
        let force: [f64; 3] = std::array::from_fn(|i| 12.0 * (cos * normal[i] + sin * down[i]));
        assert!(
            (found.ahead_n
                - -(force[0] * base_deg.to_radians().cos() + force[1] * base_deg.to_radians().sin()))
            .abs()
                < 1e-9
        );
        for joint in 0..5 {
            let moved = |step: f64| {
                let mut moved = joints;
                moved.0[joint] += step;
                let at = point(arm, &moved, push.up_m);
                let work: f64 = (0..3).map(|i| force[i] * at[i]).sum();
                work + arm.potential_energy_j(&moved).unwrap()
            };
            let torque = (moved(1e-5) - moved(-1e-5)) / 2e-5;
            assert!((torque - found.joints.0[joint]).abs() < 1e-6, "{joint}: {torque} {:?}", found.joints);
        }
        // Motors do the same work for any motion.
        let rates = soilctl_kinematics::JointVelocities([0.1, -0.2, 0.3, 0.05, 0.4]);
        let motors = arm.transmission().motor_velocities(&rates).unwrap();
        let power = |a: [f64; 5], b: [f64; 5]| -> f64 { a.iter().zip(b).map(|(x, y)| x * y).sum() };
        assert!((power(found.joints.0, rates.0) - power(found.motors.0, motors.0)).abs() < 1e-9);
    }
}

#[test]
fn a_way_keeps_wrist_and_line() {
    let params = Params::thesis();
    let task = Task {
        radius_m: 0.36,
        base_rad: 0.3,
        surface_z_m: SURFACE_Z_M,
        depth_m: 0.02,
        length_m: 0.05,
        friction_nm: [0.0; 5],
    };
    let found = way(&params, &task.stroke(80.0, 23.0), SURFACE_Z_M, 0.05).unwrap();
    let first = found.joints[0];
    for (joints, travel) in found.joints.iter().zip(&found.travel_m) {
        let pose = params.arm().forward(joints).unwrap();
        assert!((pose.z_m - (SURFACE_Z_M - 0.02 - 0.21 * travel)).abs() < 1e-8);
        assert!((pose.x_m.hypot(pose.y_m) - (0.36 - travel)).abs() < 1e-8);
        assert_eq!((joints.0[0], joints.0[3], joints.0[4]), (first.0[0], first.0[3], first.0[4]));
    }
    let far = Task { radius_m: 0.95, ..task };
    assert!(way(&params, &far.stroke(80.0, 23.0), SURFACE_Z_M, 0.05).is_err());
}

/// Whatever is to be least, no tool angle of a fine grid beats the one found.
#[test]
fn the_best_tool_angle_is_that_of_brute_force() {
    let params = Params::thesis();
    let model = plane_model("table").unwrap();
    let soils = Soils::within([38.0, 43.0], [20.0, 24.0], [1450.0, 1550.0], 9.80665).unwrap();
    for (radius_m, angles_deg) in [(0.34, [60.0, 100.0]), (0.4318, [72.0, 98.0])] {
        let task = Task {
            radius_m,
            base_rad: 0.0,
            surface_z_m: SURFACE_Z_M,
            depth_m: 0.02,
            length_m: 0.025,
            friction_nm: [0.5, 0.8, 0.68, 0.68, 0.3],
        };
        for aim in [Aim::Torque, Aim::Heat, Aim::Work] {
            let best = task.best(&params, model.as_ref(), &soils, angles_deg, aim, &[]).unwrap().unwrap();
            let steps = 4.0 * (angles_deg[1] - angles_deg[0]);
            let grid = (0..=steps as u32).filter_map(|i| {
                let deg = angles_deg[0] + f64::from(i) / 4.0;
                task.cost(&params, model.as_ref(), &soils, deg, &[]).ok()
            });
            let least = grid.map(|cost| cost.of(aim)).fold(f64::INFINITY, f64::min);
            assert!(best.of(aim) <= least * (1.0 + 2e-3), "{aim:?} {radius_m}: {} {least}", best.of(aim));
        }
    }
}
