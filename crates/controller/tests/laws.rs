//! The laws one by one: step responses, bounds, safe forces.
#![allow(clippy::unwrap_used)]

mod common;

use common::Rig;
use soilctl_controller::laws::{LeadAngle, LeadBounds, accommodation_speed, beyond_dead_zone};
use soilctl_controller::{ControllerConfig, DEFAULT, Params, Request, StrokePlan, Trajectory};
use soilctl_kinematics::{Arm, JointAngles, JointVelocities, TaskPose};

/// Every joint by 10 degrees: arrives, hardly overshoots, ends within what the external encoders resolve.
#[test]
fn joint_moves_arrive() {
    let params = Params::thesis();
    let start = JointAngles::from_degrees([0.0, 40.0, 90.0, 0.0, 40.0]);
    for joint in 0..5 {
        let mut rig = Rig::homed(params.clone(), start);
        let mut target = start;
        target.0[joint] += 10f64.to_radians();
        rig.request(Request::Push(Trajectory::JointMove { target }));
        let mut highest: f64 = 0.0;
        for _ in 0..2500 {
            rig.tick();
            highest = highest.max(rig.plant.q[joint] - target.0[joint]);
        }
        let left = (rig.plant.q[joint] - target.0[joint]).to_degrees();
        println!("joint {joint}: overshoot {:.3} deg, left {left:.3} deg", highest.to_degrees());
        assert!(highest.to_degrees() < 0.5, "joint {joint} overshoots by {} deg", highest.to_degrees());
        assert!(left.abs() < 0.1, "joint {joint} ends {left} deg off");
    }
}

#[test]
fn a_cartesian_move_is_straight() {
    let params = Params::thesis();
    let from = TaskPose::digging(0.4318, -0.3, -0.25, 1.5).unwrap();
    let to = TaskPose::digging(0.3048, 0.4, -0.2, 1.3).unwrap();
    let start = params.arm().inverse(&from).unwrap();
    let mut rig = Rig::homed(params, start);
    rig.request(Request::Push(Trajectory::CartesianMove { target: to }));
    let way = [to.x_m - from.x_m, to.y_m - from.y_m, to.z_m - from.z_m];
    let length = way.iter().map(|w| w * w).sum::<f64>().sqrt();
    let mut worst: f64 = 0.0;
    while !rig.state.idle || !rig.state.ring.is_empty() {
        rig.tick();
        assert!(rig.state.fault.is_none(), "{:?}", rig.state.fault);
        let pose = rig.plant.arm.forward(&JointAngles(rig.plant.q)).unwrap();
        let at = [pose.x_m - from.x_m, pose.y_m - from.y_m, pose.z_m - from.z_m];
        let share = at.iter().zip(way).map(|(a, w)| a * w).sum::<f64>() / (length * length);
        let off = at.iter().zip(way).map(|(a, w)| (a - share * w).powi(2)).sum::<f64>().sqrt();
        worst = worst.max(off);
    }
    rig.run(500);
    let end = rig.plant.arm.forward(&JointAngles(rig.plant.q)).unwrap();
    println!("{worst} m off the line");
    assert!(worst < 0.004, "{worst} m off the line");
    assert!((end.x_m - to.x_m).hypot(end.y_m - to.y_m).hypot(end.z_m - to.z_m) < 0.001, "{end:?}");
}

#[test]
fn velocity_control_keeps_its_speed() {
    let params = Params::thesis();
    let mut rig = Rig::homed(params, JointAngles::from_degrees([0.0, 40.0, 90.0, 0.0, 40.0]));
    let rates = JointVelocities([0.2, 0.0, 0.0, 0.0, 0.0]);
    rig.request(Request::Push(Trajectory::JointVelocity { rates, ticks: Some(1500) }));
    rig.run(1200);
    assert!((rig.plant.v[0] - 0.2).abs() < 0.005, "{}", rig.plant.v[0]);
    rig.run(1000);
    assert!(rig.plant.v[0].abs() < 1e-3 && rig.state.idle, "{}", rig.plant.v[0]);
}

#[test]
fn the_lead_stays_in_its_bounds_and_does_not_wind_up() {
    let bounds = LeadBounds::new(0.0, 23f64.to_radians(), 10f64.to_radians(), 60f64.to_radians());
    assert!((bounds.lower_rad.to_degrees() + 13.0).abs() < 1e-9);
    let mut angle = LeadAngle::default();
    for _ in 0..100_000 {
        let lead = angle.update(0.4, 0.3, [5.0, 5.0], 1.0, bounds);
        assert!(lead <= bounds.upper_rad);
    }
    // Away from the bound as soon as the error turns.
    assert!(angle.update(0.4, -0.02, [5.0, 5.0], 1.0, bounds) < bounds.upper_rad);
    for _ in 0..100_000 {
        assert!(angle.update(0.4, -0.3, [5.0, 5.0], 1.0, bounds) >= bounds.lower_rad);
    }
}

#[test]
fn dead_zone_and_accommodation() {
    assert!(beyond_dead_zone(0.1, 0.2).abs() < 1e-15 && beyond_dead_zone(-0.2, 0.2).abs() < 1e-15);
    assert!((beyond_dead_zone(0.5, 0.2) - 0.3).abs() < 1e-15);
    assert!((beyond_dead_zone(-0.5, 0.2) + 0.3).abs() < 1e-15);
    assert!((accommodation_speed(1.2, 0.2, 0.001, 1.0) - 0.001).abs() < 1e-15);
    assert!((accommodation_speed(-100.0, 0.2, 0.001, 0.01) + 0.01).abs() < 1e-15);
}

#[test]
fn safe_forces_are_interpolated() {
    let mut config: ControllerConfig = toml::from_str(DEFAULT).unwrap();
    assert_eq!(Params::thesis().safe_force().largest_n(0.0), None);
    config.stroke.safe_force.angle_deg = vec![0.0, 20.0, 40.0];
    config.stroke.safe_force.force_n = vec![4.0, 10.0, 30.0];
    let params = Params::new(Arm::thesis(), config, StrokePlan::default()).unwrap();
    let at = |deg: f64| params.safe_force().largest_n(deg.to_radians()).unwrap();
    assert!((at(-5.0) - 4.0).abs() < 1e-12 && (at(90.0) - 30.0).abs() < 1e-12);
    assert!((at(10.0) - 7.0).abs() < 1e-9 && (at(30.0) - 20.0).abs() < 1e-9);
}
