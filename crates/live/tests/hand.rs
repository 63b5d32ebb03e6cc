//! The plate is led by hand: by operators, and by a device at the rate of the controller.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

mod common;

use std::io::{Read, Write};
use std::path::{Path, PathBuf};
use std::time::Instant;

use common::{LONG, Operator, Running, simulated};
use soilctl_controller::HandTarget;
use soilctl_live::hand::{HAND_BYTES, HandFrame, TOUCH_BYTES, TouchFrame};
use soilctl_live::protocol::{Command, Problem, parse_command};
use soilctl_live::{Host, LiveError, local};
use soilctl_session::replay;

fn command(line: &str) -> Command {
    parse_command(line).unwrap()
}

/// A session in real time with a socket for devices, switched on.
fn running() -> (Running, Operator, PathBuf) {
    let dir = tempfile::tempdir().unwrap();
    let device = dir.path().join("hand");
    let mut session = simulated();
    (session.real_time, session.device) = (true, Some(device.clone()));
    let log = common::Shelf::default();
    let host = Host::start(session, &dir.path().join("live"), Some(log.clone())).unwrap();
    let running = Running { host: Some(host), log, dir };
    let mut operator = running.operator();
    operator.ask(Command::Enable).unwrap();
    operator.wait_state(|state| state.mode == "ready" && state.plate.is_some());
    (running, operator, device)
}

struct Device(local::Stream);

impl Device {
    fn connect(path: &Path) -> Self {
        let stream = local::connect(path).unwrap();
        stream.set_read_timeout(Some(LONG)).unwrap();
        Self(stream)
    }

    fn touch(&mut self) -> TouchFrame {
        let mut bytes = [0; TOUCH_BYTES];
        self.0.read_exact(&mut bytes).unwrap();
        TouchFrame::decode(&bytes).unwrap()
    }

    fn lead(&mut self, number: u32, target: Option<HandTarget>) {
        self.0.write_all(&HandFrame { number, target }.encode()).unwrap();
    }
}

#[test]
fn a_device_leads_the_plate_tick_by_tick_and_the_log_replays() {
    let (mut running, mut operator, path) = running();
    let mut device = Device::connect(&path);
    let first = device.touch();
    assert!(first.flags.ready && !first.flags.leads, "{first:?}");
    let [x_m, y_m, z_m] = first.place_m;
    let target = HandTarget { x_m, y_m, z_m: z_m + 0.03, tool_angle_rad: first.tool_angle_rad };
    let (mut last, mut ticks, mut heard) = (first, Vec::new(), Vec::new());
    for number in 1..=600 {
        device.lead(number, Some(target));
        last = device.touch();
        ticks.push(last.tick);
        heard.push(last.number);
    }
    assert!(last.flags.leads && !last.flags.refused, "{last:?}");
    assert!((last.place_m[2] - target.z_m).abs() < 0.003, "{last:?} {target:?}");
    // A frame a tick: none comes twice, and those that are left out on a busy machine are few.
    assert!(ticks.windows(2).all(|pair| pair[1] > pair[0]));
    assert!(heard.windows(2).all(|pair| pair[1] >= pair[0]) && *heard.last().unwrap() > 500, "{heard:?}");
    let led = operator.wait_state(|state| state.led.is_some()).led.unwrap();
    assert_eq!((led.hand, led.limit.as_str()), (u32::MAX, "none"));

    // Another hand, another device, and what is no number.
    let (problem, message) = operator.ask(command("follow 0.4 0 0 90 3")).unwrap_err();
    assert!(problem == Problem::Refused && message.contains("another hand"), "{message}");
    let mut second = Device::connect(&path);
    assert_eq!(second.0.read(&mut [0; 8]).unwrap_or(0), 0, "a second device is hung up on");
    device.lead(700, Some(HandTarget { x_m: f64::NAN, ..target }));
    let refused = (0..500).map(|_| device.touch()).find(|touch| touch.number == 700).unwrap();
    assert!(refused.flags.refused, "{refused:?}");

    // A device that is gone: the arm stops.
    drop(device);
    operator.wait("trajectory_ended/follow/let_go");
    // Not a word that is no frame.
    let mut bad = Device::connect(&path);
    bad.0.write_all(&[b'x'; HAND_BYTES]).unwrap();
    let begin = Instant::now();
    while bad.0.read(&mut [0; 4096]).is_ok_and(|count| count > 0) {
        assert!(begin.elapsed() < LONG, "what sends no frames should be sent away");
    }
    let report = running.end();
    assert_eq!((report.devices, report.devices_refused, report.fault), (2, 2, None));
    assert!(!path.exists());
    assert!(replay(&running.log_file(), 0).unwrap().is_identical());
}

#[test]
fn hands_of_operators_take_turns_and_stop_when_they_are_gone() {
    let (mut running, mut operator, _) = running();
    let begin = operator.state.clone().unwrap().plate.unwrap();
    let line = |dz: f64, hand: u32| {
        format!("follow {} {} {} {} {hand}", begin.x_m, begin.y_m, begin.z_m + dz, begin.tool_angle_deg)
    };
    // Numbers may be any; the arm goes as far as it may.
    for text in ["follow 1e300 -1e300 1e300 -1e300 1", "follow 0 0 0 0 1"] {
        operator.ask(command(text)).unwrap();
    }
    let mut other = running.operator();
    let (problem, _) = other.ask(command(&line(0.02, 2))).unwrap_err();
    assert_eq!(problem, Problem::Refused);
    // It hangs up; within the lease and the braking, 0.3 s of the session, the other one may.
    let tick = operator.ask(command(&line(0.02, 1))).unwrap();
    drop(operator);
    let ended = other.wait("trajectory_ended/follow/let_go");
    assert!(ended.tick - tick <= 150, "{} ticks", ended.tick - tick);
    other.ask(command(&line(0.02, 2))).unwrap();
    let state = other.wait_state(|state| state.led.is_some());
    assert_eq!((state.led.unwrap().hand, state.mode.as_str()), (2, "ready"));
    assert_eq!(running.end().fault, None);
}

#[test]
fn a_device_needs_a_session_that_keeps_to_the_clock() {
    let dir = tempfile::tempdir().unwrap();
    let mut session = simulated();
    session.device = Some(dir.path().join("hand"));
    let refused = Host::start(session, &dir.path().join("live"), None::<common::Shelf>);
    assert!(matches!(refused.err(), Some(LiveError::DeviceNeedsRealTime)));
}
