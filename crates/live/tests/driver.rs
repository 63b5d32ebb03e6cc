//! Drivers behind a socket: good ones, and all kinds of bad ones. Each fault leads to the safe state, and the log says so.
#![allow(clippy::unwrap_used, clippy::panic)]

mod common;
#[path = "../examples/driver.rs"]
#[allow(dead_code)]
mod example;

use std::io::{Read, Write};
use std::path::PathBuf;
use std::time::Duration;

use common::{Running, plant, session};
use soilctl_controller::Sensed;
use soilctl_live::driver::{DRIVE_BYTES, DriveFrame, DriverServer, ReadingsFrame, SocketDriver};
use soilctl_live::protocol::{Command, parse_command};
use soilctl_live::{Ending, LiveError, Report, Rig, local};
use soilctl_plant::{Drive, Hardware, Plant, PlantError};
use soilctl_session::messages::ControllerStep;
use soilctl_session::replay;

/// When readings are spoilt: ticks after the arm is on its way.
const SPOILT_FROM: u64 = 600;

/// The simulated plant with readings that somebody spoils.
struct Spoilt<F> {
    plant: Plant,
    spoil: F,
    tick: u64,
}

impl<F: FnMut(&mut Sensed, u64)> Hardware for Spoilt<F> {
    type Error = PlantError;

    fn exchange(&mut self, drive: &Drive) -> Result<Sensed, PlantError> {
        self.tick += 1;
        let mut sensed = self.plant.exchange(drive)?;
        if self.tick >= SPOILT_FROM {
            (self.spoil)(&mut sensed, self.tick);
        }
        Ok(sensed)
    }
}

/// Runs `serve` as a driver in a thread of its own and a session on it, in which the arm is enabled and on its way. Without
/// an operator's doing it must end up in the safe state.
fn run_on(
    timeout: Duration,
    serve: impl FnOnce(PathBuf, std::sync::mpsc::Sender<()>) + Send + 'static,
) -> (Running, Report) {
    let dir = tempfile::tempdir().unwrap();
    let socket = dir.path().join("driver");
    let theirs = socket.clone();
    let (ready, is_ready) = std::sync::mpsc::channel();
    let driver = std::thread::spawn(move || serve(theirs, ready));
    is_ready.recv().unwrap();
    let mut session = session(Rig::Driver(Box::new(SocketDriver::connect(&socket, timeout).unwrap())));
    session.most_ticks = Some(4000);
    let mut running = Running::new(session);
    let mut operator = running.operator();
    operator.ask(Command::Enable).unwrap();
    operator.ask(parse_command("velocity 5,0,0,0,0").unwrap()).unwrap();
    let report = running.host.take().unwrap().wait().unwrap();
    driver.join().unwrap();
    (running, report)
}

/// The step at which the fault came, and what the log says about it.
fn check_safe(running: &Running, kind: &str) -> u64 {
    let steps: Vec<ControllerStep> = running.steps();
    let is = |step: &&ControllerStep| step.events.iter().any(|event| event.kind == format!("fault/{kind}"));
    let found = steps.iter().find(is).unwrap_or_else(|| {
        let all: Vec<_> = steps.iter().flat_map(|step| &step.events).map(|event| &event.kind).collect();
        panic!("no {kind} but {all:?}")
    });
    let before = steps.iter().find(|step| step.step + 1 == found.step).unwrap();
    assert_eq!((before.mode.as_str(), before.amplifiers_enabled), ("ready", true));
    // In the very tick, which is within two.
    for step in steps.iter().filter(|step| step.step >= found.step) {
        assert!(step.mode == "fault" && !step.amplifiers_enabled && step.motor_torques_nm == [0.0; 5]);
    }
    let again = replay(&running.log_file(), 0).unwrap();
    assert!(again.is_identical(), "{:?}", again.first_difference);
    found.tick
}

fn spoilt(kind: &str, most_ticks: u64, spoil: impl FnMut(&mut Sensed, u64) + Send + 'static) {
    let (running, report) = run_on(Duration::from_secs(20), move |socket, ready| {
        let mut server = DriverServer::bind(&socket).unwrap();
        ready.send(()).unwrap();
        server.serve(&mut Spoilt { plant: plant(3), spoil, tick: 0 }).unwrap();
    });
    assert_eq!(report.ending, Ending::TimeIsUp);
    assert!(report.fault.is_some() && report.failed.is_none());
    let tick = check_safe(&running, kind);
    assert!((SPOILT_FROM..=SPOILT_FROM + most_ticks).contains(&tick), "{kind} at {tick}");
}

#[test]
fn readings_that_are_no_numbers_or_out_of_range() {
    spoilt("force_not_finite", 0, |sensed, _| sensed.wrench[2] = f64::NAN);
    spoilt("force_range", 0, |sensed, _| sensed.wrench[0] = 101.0);
    spoilt("amplifier_not_finite", 0, |sensed, _| sensed.amplifier_voltage_v[4] = f64::INFINITY);
}

#[test]
fn a_saturated_force_sensor_and_an_encoder_that_jumps() {
    spoilt("force_overload", 0, |sensed, _| sensed.wrench_overload = true);
    spoilt("encoder_jump", 0, |sensed, _| sensed.motor_counts[1] += 40_000);
}

#[test]
fn frozen_and_silent_sensors() {
    spoilt("force_frozen", 502, |sensed, _| sensed.wrench = [0.25; 6]);
    spoilt("force_stale", 6, |sensed, _| sensed.wrench_sequence = 1);
    let mut held = None;
    // Free play and speed decide when they disagree by 5 deg.
    spoilt("encoder_disagreement", 1500, move |sensed, _| {
        sensed.external_counts = *held.get_or_insert(sensed.external_counts);
    });
}

/// Half the readings of a driver's own: answers after `after` ticks as `how` says.
fn raw_driver(
    after: u64,
    mut how: impl FnMut(&mut local::Stream, Sensed) -> bool,
) -> impl FnOnce(PathBuf, std::sync::mpsc::Sender<()>) {
    move |socket, ready| {
        let mut listener = local::bind(&socket).unwrap();
        ready.send(()).unwrap();
        let mut stream = listener.accept().unwrap();
        let mut plant = plant(3);
        let mut bytes = [0; DRIVE_BYTES];
        while stream.read_exact(&mut bytes).is_ok() {
            let frame = DriveFrame::decode(&bytes).unwrap();
            let mut sensed = plant.exchange(&frame.drive).unwrap();
            sensed.tick = frame.tick;
            if frame.tick < after {
                if stream.write_all(&ReadingsFrame { sensed }.encode()).is_err() {
                    break;
                }
            } else if !how(&mut stream, sensed) {
                break;
            }
        }
    }
}

#[test]
fn a_driver_that_falls_silent_is_a_stale_sensor() {
    let (running, report) = run_on(Duration::from_millis(300), raw_driver(SPOILT_FROM, |_, _| true));
    // First the fault, and when nothing more comes, the end.
    assert_eq!(report.ending, Ending::DriverGone);
    assert!(report.fault.is_some());
    assert!(report.failed.unwrap().to_string().contains("has not answered"));
    let tick = check_safe(&running, "motor_encoder_stale");
    // The third tick without readings.
    assert_eq!(tick, SPOILT_FROM + 2);
}

#[test]
fn a_driver_that_goes_away_ends_the_session_in_the_safe_state() {
    let (running, report) = run_on(Duration::from_secs(20), raw_driver(SPOILT_FROM, |_, _| false));
    assert_eq!(report.ending, Ending::DriverGone);
    let problem = report.failed.unwrap();
    assert!(matches!(problem, LiveError::Driver { .. }), "{problem}");
    assert!(problem.to_string().contains("closed the connection"), "{problem}");
    assert_eq!(check_safe(&running, "motor_encoder_stale"), SPOILT_FROM + 2);
}

#[test]
fn frames_of_another_kind_end_the_session() {
    for (bytes, reason) in [(b"XXXX\x01\0", "begins with"), (b"SCRE\x09\0", "version 9")] {
        let (running, report) = run_on(
            Duration::from_secs(20),
            raw_driver(SPOILT_FROM, move |stream, sensed| {
                let mut frame = ReadingsFrame { sensed }.encode();
                frame[..6].copy_from_slice(bytes);
                stream.write_all(&frame).is_ok()
            }),
        );
        assert_eq!(report.ending, Ending::DriverGone);
        let problem = report.failed.unwrap().to_string();
        assert!(problem.contains(reason), "{problem}");
        check_safe(&running, "motor_encoder_stale");
    }
}

/// A reading that comes late is not taken for the one that was asked for, and one that is missing is no fault.
#[test]
fn a_late_reading_is_thrown_away() {
    let mut kept = None;
    let (running, report) = run_on(
        Duration::from_millis(400),
        raw_driver(SPOILT_FROM, move |stream, sensed| {
            if sensed.tick == SPOILT_FROM {
                kept = Some(sensed);
                return true;
            }
            let late = kept
                .take()
                .is_none_or(|late| stream.write_all(&ReadingsFrame { sensed: late }.encode()).is_ok());
            late && stream.write_all(&ReadingsFrame { sensed }.encode()).is_ok()
        }),
    );
    assert_eq!((report.ending, report.fault), (Ending::TimeIsUp, None));
    let steps = running.steps();
    let at = |tick: u64| steps.iter().find(|step| step.tick == tick).unwrap();
    assert_eq!(at(SPOILT_FROM).motor_sequence, at(SPOILT_FROM - 1).motor_sequence);
    assert_eq!(at(SPOILT_FROM + 1).motor_sequence, at(SPOILT_FROM - 1).motor_sequence + 2);
}

#[test]
fn nobody_behind_the_socket_is_an_error() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("none");
    assert!(matches!(SocketDriver::connect(&path, Duration::from_secs(1)), Err(LiveError::Socket { .. })));
}

#[test]
fn the_example_drives_the_simulated_arm() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("driver");
    let theirs = path.clone();
    let driver = std::thread::spawn(move || example::drive(&theirs).map_err(|error| error.to_string()));
    while !path.exists() {
        std::thread::sleep(Duration::from_millis(5));
    }
    let mut session = session(Rig::Driver(Box::new(SocketDriver::connect(&path, common::LONG).unwrap())));
    session.most_ticks = Some(100_000);
    let mut running = Running::new(session);
    let mut operator = running.operator();
    assert!(!operator.client.hello().simulated);
    operator.ask(Command::Enable).unwrap();
    operator.ask(parse_command("move_joints 5,40,90,0,30").unwrap()).unwrap();
    operator.wait("trajectory_ended/joint_move/completed");
    let state = operator.wait_state(|state| state.trajectory.as_deref() == Some("hold"));
    assert!((state.joints_deg[0] - 5.0).abs() < 2.0, "{:?}", state.joints_deg);
    let report = running.end();
    assert_eq!((report.ending, report.fault), (Ending::Asked, None));
    assert_eq!(driver.join().unwrap().unwrap(), report.ticks);
    assert!(!path.exists());
}
