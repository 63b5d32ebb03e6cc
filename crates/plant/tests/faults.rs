//! Spoilt readings lead to the safe state within two ticks of detection, and the arm then comes to rest.
#![allow(clippy::unwrap_used)]

mod rig;

use rig::{above, ground, homed};
use soilctl_controller::{Commands, EventKind, Fault, Mode, Params, Request, Sensed, Trajectory};
use soilctl_kinematics::TaskPose;
use soilctl_plant::{PlantParams, Simulation};

/// An arm on its way over the sand.
fn moving() -> Simulation {
    let plant = PlantParams::thesis();
    let sand = ground(&plant, "ticino_loose", "chen");
    let start = above(0.4318, 0.0, 90.0, -0.25);
    let mut simulation = homed(Params::thesis(), plant, Some(sand), &start);
    let target = TaskPose::digging(0.36, 0.4, -0.25, 1.5).unwrap();
    simulation.tick(Some(Request::Push(Trajectory::CartesianMove { target })), &mut |_| {}).unwrap();
    simulation.run(400, &mut |_| {}).unwrap();
    simulation
}

/// Spoils readings until the fault comes; it must come within `most` spoilt ticks, and be safe two ticks later.
fn spoilt(fault: Fault, most: u32, spoil: impl Fn(&mut Sensed, u32)) {
    let mut simulation = moving();
    let mut detected = None;
    for n in 0..most + 2 {
        let commands = Commands { heartbeat: 10_000 + n, ..Commands::default() };
        let outputs = simulation.tick_with(&commands, |sensed| spoil(sensed, n), &mut |_| {}).unwrap();
        let seen = outputs.events.as_slice().iter().any(|event| event.kind == EventKind::Fault(fault));
        if seen && detected.is_none() {
            detected = Some(n);
        }
        if detected.is_some_and(|at| n >= at + 2) {
            assert_eq!(outputs.mode, Mode::Fault);
            assert!(!outputs.amplifiers_enabled && outputs.motor_torques.0 == [0.0; 5]);
            break;
        }
    }
    assert!(detected.is_some_and(|at| at < most), "{fault:?}: {:?}", simulation.state().fault);
    // The arm is balanced and its drives have friction: it stops and stays, but for what a link may swing in its free play.
    simulation.run(1000, &mut |_| {}).unwrap();
    let before = simulation.plant().truth().joints.0;
    simulation.run(250, &mut |_| {}).unwrap();
    let after = simulation.plant().truth().joints.0;
    for (a, b) in before.iter().zip(after) {
        assert!((a - b).abs() < 0.02, "{fault:?}: a joint drifts by {} rad in 0.5 s", a - b);
    }
}

#[test]
fn numbers_and_ranges() {
    spoilt(Fault::ForceNotFinite, 1, |sensed, _| sensed.wrench[1] = f64::NAN);
    spoilt(Fault::ForceRange, 1, |sensed, _| sensed.wrench[2] = 301.0);
    spoilt(Fault::AmplifierNotFinite, 1, |sensed, _| sensed.amplifier_current_a[0] = f64::INFINITY);
    spoilt(Fault::EncoderJump, 1, |sensed, _| sensed.motor_counts[0] += 30_000);
    spoilt(Fault::ForceOverload, 1, |sensed, _| sensed.wrench_overload = true);
}

#[test]
fn silence_and_missed_ticks() {
    spoilt(Fault::ForceStale, 6, |sensed, _| sensed.wrench_sequence = 7);
    spoilt(Fault::MotorEncoderStale, 4, |sensed, _| sensed.motor_sequence = 7);
    spoilt(Fault::DroppedTicks, 1, |sensed, _| sensed.tick += 5);
}

/// A sensor that repeats itself: the wrench is told from its lack of noise, an encoder from the other encoder.
#[test]
fn frozen() {
    spoilt(Fault::ForceFrozen, 502, |sensed, _| sensed.wrench = [1.0; 6]);
    spoilt(Fault::EncoderDisagreement, 3000, |sensed, n| {
        if n > 0 {
            // As it stood; the arm moves on.
            sensed.external_counts = [0; 5];
        }
    });
}
