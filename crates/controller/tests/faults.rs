//! Every fault leads to the safe state in the tick in which it is detected, says so with value and limit, and stays
//! until it is reset.
#![allow(clippy::unwrap_used, clippy::float_cmp)]

mod common;

use common::Rig;
use soilctl_controller::{
    Commands, EventKind, Fault, Mode, Outputs, Params, Refusal, Request, Sensed, SequenceId, Trajectory,
};
use soilctl_kinematics::{JointVelocities, TaskPose};

fn rig() -> Rig {
    let params = Params::thesis();
    let pose = TaskPose::digging(0.4318, 0.0, -0.25, 90f64.to_radians()).unwrap();
    let start = params.arm().inverse(&pose).unwrap();
    let mut rig = Rig::homed(params, start);
    rig.run(50);
    rig
}

fn is_safe(outputs: &Outputs) -> bool {
    outputs.mode == Mode::Fault
        && !outputs.amplifiers_enabled
        && outputs.motor_torques.0 == [0.0; 5]
        && outputs.motor_currents_a == [0.0; 5]
        && outputs.telemetry.trajectory.is_none()
        && outputs.telemetry.sequence.is_none()
}

/// Spoils every reading from now on; the fault must come after exactly `ticks` spoilt readings and be safe at once.
fn expect(fault: Fault, ticks: usize, spoil: impl Fn(&mut Sensed, &mut Commands, usize)) {
    let mut rig = rig();
    for n in 1..=ticks {
        let (mut sensed, mut commands) = (rig.plant.sense(), rig.commands());
        spoil(&mut sensed, &mut commands, n);
        let outputs = rig.tick_with(&sensed, &commands);
        if n < ticks {
            assert_eq!(outputs.mode, Mode::Ready, "{fault:?} after {n} of {ticks}: {:?}", rig.state.fault);
        } else {
            assert!(is_safe(&outputs), "{fault:?}: {outputs:?}");
            assert_eq!(rig.state.fault.unwrap().fault, fault);
            assert!(rig.has(|event| event.kind == EventKind::Fault(fault)));
        }
    }
    // It stays although the cause is gone, and nothing but a reset is obeyed.
    let outputs = rig.request(Request::Enable);
    assert!(is_safe(&outputs));
    assert_eq!(outputs.events.as_slice()[0].kind, EventKind::Refused(Refusal::Mode));
    rig.run(20);
    assert!(is_safe(&rig.outputs));
    assert_eq!(rig.request(Request::Reset).mode, Mode::Off);
    assert_eq!(rig.request(Request::Enable).mode, Mode::Ready, "{:?}", rig.state.fault);
    rig.run(100);
    assert_eq!(rig.outputs.mode, Mode::Ready, "{:?}", rig.state.fault);
}

#[test]
fn emergency_stop_and_watchdog() {
    expect(Fault::EmergencyStop, 1, |_, commands, _| commands.emergency_stop = true);
    expect(Fault::Watchdog, 251, |_, commands, _| commands.heartbeat = 50_000);
    let mut rig = rig();
    let (sensed, mut commands) = (rig.plant.sense(), rig.commands());
    commands.emergency_stop = true;
    rig.tick_with(&sensed, &commands);
    let (sensed, mut commands) = (rig.plant.sense(), rig.commands());
    (commands.emergency_stop, commands.request) = (true, Some(Request::Reset));
    let outputs = rig.tick_with(&sensed, &commands);
    assert_eq!(outputs.events.as_slice()[0].kind, EventKind::Refused(Refusal::EmergencyStop));
    assert!(is_safe(&outputs));
}

#[test]
fn bad_numbers_and_ranges() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for channel in 0..6 {
            expect(Fault::ForceNotFinite, 1, |sensed, _, _| sensed.wrench[channel] = bad);
        }
        expect(Fault::AmplifierNotFinite, 1, |sensed, _, _| sensed.amplifier_current_a[3] = bad);
        expect(Fault::AmplifierNotFinite, 1, |sensed, _, _| sensed.amplifier_voltage_v[0] = bad);
    }
    expect(Fault::ForceRange, 1, |sensed, _, _| sensed.wrench[0] = -100.1);
    expect(Fault::ForceRange, 1, |sensed, _, _| sensed.wrench[2] = 301.0);
    expect(Fault::ForceRange, 1, |sensed, _, _| sensed.wrench[5] = 5.1);
    expect(Fault::ForceOverload, 1, |sensed, _, _| sensed.wrench_overload = true);
    expect(Fault::EncoderJump, 1, |sensed, _, _| sensed.motor_counts[1] += 1000);
    expect(Fault::EncoderJump, 1, |sensed, _, _| sensed.motor_counts[4] = i32::MAX);
}

/// The first spoilt reading changes the sequence number; the count begins with the next.
#[test]
fn stale_and_frozen_sensors() {
    expect(Fault::MotorEncoderStale, 4, |sensed, _, _| sensed.motor_sequence = 7);
    expect(Fault::ExternalEncoderStale, 6, |sensed, _, _| sensed.external_sequence = 7);
    expect(Fault::ForceStale, 6, |sensed, _, _| sensed.wrench_sequence = 7);
    expect(Fault::AmplifierStale, 26, |sensed, _, _| sensed.amplifier_sequence = 7);
    expect(Fault::ForceFrozen, 501, |sensed, _, _| sensed.wrench = [0.1; 6]);
}

#[test]
fn missed_ticks() {
    let mut rig = rig();
    rig.plant.sense();
    rig.tick();
    assert_eq!(rig.outputs.mode, Mode::Ready, "one missed tick is allowed");
    rig.plant.sense();
    rig.plant.sense();
    rig.tick();
    assert!(is_safe(&rig.outputs));
    assert_eq!(rig.state.fault.unwrap().fault, Fault::DroppedTicks);
    expect(Fault::DroppedTicks, 1, |sensed, _, _| sensed.tick = 3);
}

#[test]
fn amplifiers() {
    expect(Fault::OverCurrent, 10, |sensed, _, _| sensed.amplifier_current_a[1] = 15.5);
    expect(Fault::CurrentMismatch, 10, |sensed, _, _| sensed.amplifier_current_a[0] += 3.0);
    expect(Fault::SupplyVoltage, 10, |sensed, _, _| sensed.amplifier_voltage_v[2] = 30.0);
    expect(Fault::SupplyVoltage, 10, |sensed, _, _| sensed.amplifier_voltage_v[2] = 60.0);
}

/// Runs until the fault; the plant misbehaves as `disturb` says.
fn run_into(request: Request, most: usize, disturb: impl Fn(&mut Rig, &mut Sensed)) -> Fault {
    let mut rig = rig();
    rig.request(request);
    for _ in 0..most {
        let (mut sensed, commands) = (rig.plant.sense(), rig.commands());
        disturb(&mut rig, &mut sensed);
        let outputs = rig.tick_with(&sensed, &commands);
        if outputs.mode == Mode::Fault {
            assert!(is_safe(&outputs));
            let record = rig.state.fault.unwrap();
            assert!(
                record.value.abs() >= record.limit.abs() || record.limit < 0.0 || record.value < record.limit,
                "{record:?}"
            );
            return record.fault;
        }
    }
    panic!("no fault: {:?}", rig.outputs);
}

fn turn(joint: usize, rate: f64) -> Request {
    let mut rates = JointVelocities::default();
    rates.0[joint] = rate;
    Request::Push(Trajectory::JointVelocity { rates, ticks: None })
}

#[test]
fn joints_workspace_and_force() {
    let none = |_: &mut Rig, _: &mut Sensed| {};
    // Both encoders of the wrist creep away together.
    let creep = |rig: &mut Rig, sensed: &mut Sensed| {
        #[allow(clippy::cast_precision_loss, clippy::cast_possible_truncation)]
        let turns = (rig.state.tick as f64 - 51.0) * 0.001 / std::f64::consts::TAU;
        sensed.motor_counts[4] += (turns * 289_520.0) as i32;
        sensed.external_counts[4] += (turns * 3600.0) as i32;
    };
    assert_eq!(run_into(turn(4, 0.0), 5000, creep), Fault::JointLimit);
    assert_eq!(run_into(turn(1, -0.3), 5000, none), Fault::WorkspaceHeight);
    assert_eq!(run_into(turn(2, 0.3), 5000, none), Fault::WorkspaceRadius);
    let push = |_: &mut Rig, sensed: &mut Sensed| sensed.wrench[2] += 45.0;
    assert_eq!(run_into(Request::Store(true), 100, push), Fault::TipForce);
    let kick = |rig: &mut Rig, _: &mut Sensed| rig.plant.v[0] = 1.3;
    assert_eq!(run_into(Request::Store(true), 100, kick), Fault::JointSpeed);
}

/// Frozen counts with a live sequence number, while the arm moves.
#[test]
fn a_frozen_encoder_disagrees_with_the_other() {
    let mut target = soilctl_kinematics::JointAngles(rig().plant.q);
    target.0[0] += 0.6;
    let mut first = rig();
    let frozen = first.plant.sense();
    let freeze = |_: &mut Rig, sensed: &mut Sensed| sensed.external_counts = frozen.external_counts;
    let fault = run_into(Request::Push(Trajectory::JointMove { target }), 3000, freeze);
    assert_eq!(fault, Fault::EncoderDisagreement);
    let freeze = |_: &mut Rig, sensed: &mut Sensed| sensed.motor_counts = frozen.motor_counts;
    let fault = run_into(Request::Push(Trajectory::JointMove { target }), 3000, freeze);
    assert!(matches!(fault, Fault::EncoderDisagreement | Fault::TrackingError), "{fault:?}");
}

/// Something holds the base: it falls behind, or its torque stays at the limit.
#[test]
fn a_blocked_joint() {
    let mut target = soilctl_kinematics::JointAngles(rig().plant.q);
    target.0[0] += 0.6;
    let block = |rig: &mut Rig, _: &mut Sensed| (rig.plant.q[0], rig.plant.v[0]) = (0.0, 0.0);
    let fault = run_into(Request::Push(Trajectory::JointMove { target }), 3000, block);
    assert!(matches!(fault, Fault::TrackingError | Fault::TorqueSaturated), "{fault:?}");
    let fault = run_into(turn(0, 0.5), 3000, block);
    assert_eq!(fault, Fault::TorqueSaturated);
}

/// In the middle of a sequence, too.
#[test]
fn a_fault_ends_a_sequence() {
    let mut rig = rig();
    rig.request(Request::Start(SequenceId::WallSensing));
    rig.run(1000);
    assert!(rig.state.machine.is_running());
    let (mut sensed, commands) = (rig.plant.sense(), rig.commands());
    sensed.wrench[1] = f64::NAN;
    assert!(is_safe(&rig.tick_with(&sensed, &commands)));
    assert!(!rig.state.machine.is_running());
}
