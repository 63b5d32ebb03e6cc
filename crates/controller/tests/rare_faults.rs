//! Faults that a sound arm under sound settings never shows, each provoked.
#![allow(clippy::unwrap_used)]

mod common;

use common::{Plant, Rig};
use soilctl_controller::{
    ControllerConfig, DEFAULT, Fault, Mode, Params, Request, Sensed, StrokeLaw, StrokePlan, Trajectory,
};
use soilctl_kinematics::{Arm, JointAngles, TaskPose};

fn rig(change: impl Fn(&mut ControllerConfig)) -> Rig {
    let mut config: ControllerConfig = toml::from_str(DEFAULT).unwrap();
    change(&mut config);
    let params = Params::new(Arm::thesis(), config, StrokePlan::default()).unwrap();
    let pose = TaskPose::digging(0.4318, 0.0, -0.25, 90f64.to_radians()).unwrap();
    let start = params.arm().inverse(&pose).unwrap();
    let mut rig = Rig::homed(params, start);
    rig.run(50);
    rig
}

/// Runs until a fault; it must be safe in the tick in which it is raised.
fn fault(rig: &mut Rig, ticks: usize, spoil: impl Fn(&mut Sensed)) -> Fault {
    for _ in 0..ticks {
        let (mut sensed, commands) = (rig.plant.sense(), rig.commands());
        spoil(&mut sensed);
        let outputs = rig.tick_with(&sensed, &commands);
        if outputs.mode == Mode::Fault {
            assert!(!outputs.amplifiers_enabled);
            assert_eq!((outputs.motor_torques.0, outputs.motor_currents_a), ([0.0; 5], [0.0; 5]));
            return rig.state.fault.unwrap().fault;
        }
    }
    panic!("no fault");
}

fn base_move(rig: &mut Rig, angle: f64) {
    let mut target = JointAngles(rig.plant.q);
    target.0[0] += angle;
    rig.request(Request::Push(Trajectory::JointMove { target }));
}

/// The fastest move of the settings is above what they allow in a tick.
#[test]
fn set_point_rate() {
    let mut rig = rig(|config| config.safety.setpoint_step_deg = 0.03);
    base_move(&mut rig, 0.6);
    assert_eq!(fault(&mut rig, 2000, |_| {}), Fault::SetpointRate);
}

#[test]
fn workspace_base() {
    let mut rig = rig(|config| config.safety.base_deg = [-10.0, 10.0]);
    base_move(&mut rig, 0.3);
    assert_eq!(fault(&mut rig, 2000, |_| {}), Fault::WorkspaceBase);
}

/// The motors are held while the shoulder's external encoder goes outwards, and with it the wanted position, by less than what
/// counts as a disagreement.
#[test]
fn stiffness_error() {
    let mut rig = rig(|config| {
        config.stroke.max_lead_m = 0.01;
        config.safety.stiffness_error_m = 0.015;
        config.safety.saturated_ticks = 100_000;
    });
    rig.request(Request::Push(Trajectory::Stroke { law: StrokeLaw::Force, delta_rad: 0.4 }));
    let held = rig.plant.q;
    for _ in 0..3000 {
        (rig.plant.q, rig.plant.v) = (held, [0.0; 5]);
        let (mut sensed, commands) = (rig.plant.sense(), rig.commands());
        sensed.external_counts[1] -= 40;
        rig.tick_with(&sensed, &commands);
        if rig.state.mode == Mode::Fault {
            break;
        }
    }
    assert_eq!(rig.state.fault.unwrap().fault, Fault::StiffnessError);
}

/// A hand that points sideways has no pitch, and so no Jacobian.
#[test]
fn kinematics() {
    let params = Params::thesis();
    let q = JointAngles::from_degrees([0.0, 60.0, 60.0, 90.0, 90.0]);
    let mut rig = Rig::new(params, q.0);
    let zero = Plant::new(&rig.params, rig.plant.arm.transmission().home().0).sense();
    (rig.state.homed, rig.state.filters.offset_known) = (true, true);
    rig.state.filters.motor_zero = zero.motor_counts;
    rig.state.filters.external_zero = zero.external_counts;
    // A first reading is taken to lie amid its counts, and half a count is enough of a pitch.
    let motors = rig.plant.arm.transmission().motor_angles(&q).unwrap();
    let filters = &mut rig.state.filters;
    (filters.motor_rad, filters.external_rad, filters.within_rad) = (motors.0, motors.0, motors.0);
    (filters.primed, filters.last_counts) = (true, rig.plant.sense().motor_counts);
    assert_eq!(fault(&mut rig, 1, |_| {}), Fault::Kinematics);
}

/// A key frame that was damaged: limits must not make a full torque of what is not a number.
#[test]
fn output_not_finite() {
    let mut rig = rig(|_| {});
    rig.state.integral_nm[1] = f64::NAN;
    assert_eq!(fault(&mut rig, 1, |_| {}), Fault::OutputNotFinite);
}
