//! The arm file against what the thesis prints about its arm.
#![allow(clippy::unwrap_used, clippy::needless_range_loop)]

use soilctl_kinematics::{Arm, JointAngles, TaskPose};

const INCH_M: f64 = 0.0254;

#[test]
fn reach_forwards_and_down() {
    let arm = Arm::thesis();
    let out = arm.forward(&JointAngles::from_degrees([0.0, 90.0, 0.0, 0.0, 0.0])).unwrap();
    assert!((out.x_m - 36.0 * INCH_M).abs() < 1e-12);
    let down = arm.forward(&JointAngles::from_degrees([0.0, 180.0, 0.0, 0.0, 0.0])).unwrap();
    assert!((down.z_m + 23.0 * INCH_M).abs() < 1e-12);
}

/// Why 70 degrees was done at 12 in only: there the wrist bends by 15 degrees, at 17 in by 36.
#[test]
fn a_70_degree_tool_is_easier_near_the_base() {
    let arm = Arm::thesis();
    for (radius_in, wrist_deg) in [(17.0, 36.0), (12.0, 15.0)] {
        let pose = TaskPose::digging(radius_in * INCH_M, 0.0, -13.0 * INCH_M, 70f64.to_radians()).unwrap();
        let wrist = arm.inverse(&pose).unwrap().degrees()[4];
        println!("{radius_in} in: {wrist}");
        assert!((wrist - wrist_deg).abs() < 2.0, "{radius_in} in: {wrist} deg");
    }
}

/// Every place and tool angle of the experiments, from 4 in above the soil to 1 in inside, is within the limits.
#[test]
fn the_experiments_fit_into_the_limits() {
    let arm = Arm::thesis();
    for (radius_in, bases) in [
        (17.0, [-25.0, 0.0, 25.0]),
        (12.0, [-35.0, 0.0, 35.0]),
        (17.0, [-15.0, 15.0, 20.0]),
        (8.0, [-20.0, 0.0, 20.0]),
    ] {
        for base in bases {
            for alpha in [70.0_f64, 80.0, 90.0, 100.0] {
                for z_in in [-14.0, -13.0, -12.5, -9.0] {
                    let (radius, height) = (radius_in * INCH_M, z_in * INCH_M);
                    let base: f64 = base;
                    let pose =
                        TaskPose::digging(radius, base.to_radians(), height, alpha.to_radians()).unwrap();
                    assert!((pose.tool_angle_rad().to_degrees() - alpha).abs() < 1e-12);
                    let joints = arm
                        .inverse(&pose)
                        .unwrap_or_else(|e| panic!("{radius_in} {base} {alpha} {z_in}: {e}"));
                    assert!((joints.degrees()[0] - base).abs() < 1e-12 && joints.0[3] == 0.0);
                }
            }
        }
    }
}
