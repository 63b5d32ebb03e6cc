//! A session and its operators.
#![allow(clippy::unwrap_used, clippy::panic)]

mod common;

use std::io::{Read, Write};
use std::time::Duration;

use common::{LONG, Operator, Running, START_DEG, Shelf, simulated};
use soilctl_live::protocol::{Command, PROTOCOL_VERSION, Problem, ServerMessage, Value, parse_command};
use soilctl_live::{Ending, LiveError, local};
use soilctl_session::{info, replay};

fn command(line: &str) -> Command {
    parse_command(line).unwrap()
}

/// Enables, moves the base by 10 deg and back, ends. Says at which ticks commands came.
fn back_and_forth(operator: &mut Operator) -> Vec<u64> {
    let mut ticks = vec![operator.ask(Command::Enable).unwrap()];
    for base in ["10", "0"] {
        ticks.push(operator.ask(command(&format!("move_joints {base},40,90,0,30"))).unwrap());
        operator.wait("trajectory_ended/joint_move/completed");
    }
    ticks.push(operator.ask(command("advance 0.5")).unwrap());
    operator.wait_state(|state| state.paused);
    ticks
}

#[test]
fn an_operator_moves_the_arm_and_the_log_replays() {
    let mut running = Running::new(simulated());
    let mut operator = running.operator();
    let hello = operator.client.hello().clone();
    assert_eq!((hello.protocol, hello.real_time, hello.simulated), (PROTOCOL_VERSION, false, true));
    // Before it is enabled, the arm refuses to move.
    let (problem, message) = operator.ask(command("move_joints 10,40,90,0,30")).unwrap_err();
    assert_eq!(problem, Problem::Refused);
    assert!(message.contains("enable"), "{message}");
    back_and_forth(&mut operator);
    let state = operator.state.clone().unwrap();
    assert_eq!((state.mode.as_str(), state.homed), ("ready", true));
    for (joint, start) in state.joints_deg.iter().zip(START_DEG) {
        assert!((joint - start).abs() < 2.0, "{:?}", state.joints_deg);
    }
    assert!(state.plate.is_some());
    let report = running.end();
    assert_eq!((report.ending, report.fault, report.clients), (Ending::Asked, None, 1));
    loop {
        if let ServerMessage::End { reason } = operator.next() {
            assert_eq!(reason, "asked to end");
            break;
        }
    }
    assert!(!running.socket().exists());
    let steps = running.steps();
    let [.., before, last] = steps.as_slice() else { panic!("{} steps", steps.len()) };
    for step in [before, last] {
        assert!(step.mode == "off" && !step.amplifiers_enabled && step.motor_torques_nm == [0.0; 5]);
    }
    let log = running.log_file();
    assert_eq!(info(&log).unwrap().problems, Vec::<String>::new());
    let again = replay(&log, 0).unwrap();
    assert!(again.is_identical() && again.steps == report.ticks);
}

#[test]
fn the_same_script_gives_the_same_log() {
    let run = |pause| {
        let mut running = Running::new(simulated());
        let mut operator = running.operator();
        std::thread::sleep(Duration::from_millis(pause));
        let ticks = back_and_forth(&mut operator);
        std::thread::sleep(Duration::from_millis(pause));
        running.end();
        let bytes = running.log.0.lock().unwrap().bytes.clone();
        (ticks, bytes)
    };
    let (ticks, bytes) = run(0);
    let (same_ticks, same_bytes) = run(150);
    assert_eq!(ticks, same_ticks);
    assert!(bytes == same_bytes, "the bytes of the logs differ");
}

#[test]
fn bad_lines_are_refused_and_the_service_goes_on() {
    let mut running = Running::new(simulated());
    let mut raw = local::connect(&running.socket()).unwrap();
    let mut lines = Vec::new();
    let long = vec![b'x'; 100_000];
    for line in [
        b"nonsense".as_slice(),
        b"{\"type\":\"command\",\"id\":5,\"command\":{\"name\":\"fly\"}}",
        b"{\"type\":\"command\",\"id\":6,\"command\":{\"name\":\"start\",\"sequence\":\"lunch\"}}",
        b"{\"type\":\"command\",\"id\":7,\"command\":{\"name\":\"hold\",\"seconds\":-1}}",
        b"{\"type\":\"command\",\"id\":8,\"command\":{\"name\":\"hold\",\"seconds\":1e999}}",
        b"\xff\xfe",
        &long,
    ] {
        lines.extend_from_slice(line);
        lines.push(b'\n');
    }
    raw.write_all(&lines).unwrap();
    let problems = errors(&mut raw, 7);
    let wanted = [
        (None, Problem::Malformed),
        (Some(5), Problem::Malformed),
        (Some(6), Problem::Value),
        (Some(7), Problem::Value),
        (None, Problem::Malformed),
        (None, Problem::Malformed),
        (None, Problem::TooLong),
    ];
    assert_eq!(problems, wanted);
    // Another protocol is told so and hung up on.
    let mut other = local::connect(&running.socket()).unwrap();
    other.write_all(b"{\"type\":\"hello\",\"protocol\":99}\n").unwrap();
    let mut text = String::new();
    other.set_read_timeout(Some(LONG)).unwrap();
    other.read_to_string(&mut text).unwrap();
    assert!(text.contains("\"problem\":\"protocol\""), "{text}");

    assert!(running.operator().ask(Command::Enable).is_ok());
    assert_eq!(running.end().lines_refused, 7);
}

/// Reads error messages.
fn errors(stream: &mut local::Stream, count: usize) -> Vec<(Option<u64>, Problem)> {
    use std::io::{BufRead, BufReader};
    stream.set_read_timeout(Some(LONG)).unwrap();
    let mut found = Vec::new();
    for line in BufReader::new(stream).lines() {
        if let ServerMessage::Error { id, problem, .. } = serde_json::from_str(&line.unwrap()).unwrap() {
            found.push((id, problem));
            if found.len() == count {
                break;
            }
        }
    }
    found
}

#[test]
fn a_flood_is_cut_off_and_others_are_served() {
    let mut running = Running::new(simulated());
    let mut flood = local::connect(&running.socket()).unwrap();
    flood.set_write_timeout(Some(Duration::from_millis(100))).unwrap();
    let lines = b"{\"type\":\"command\",\"id\":1,\"command\":{\"name\":\"enable\"}}\n".repeat(100);
    let flooding = std::thread::spawn(move || {
        (0..50).take_while(|_| flood.write_all(&lines).is_ok()).count();
        let found = errors(&mut flood, 1);
        drop(flood);
        found
    });
    let mut operator = running.operator();
    assert!(operator.ask(command("set speed_scale 0.5")).is_ok());
    assert!(!flooding.join().unwrap().is_empty());
    assert!(operator.ask(Command::Set { parameter: "law".to_owned(), value: Value::Number(1.0) }).is_err());
    assert!(running.end().lines_refused > 0);
}

#[test]
fn the_emergency_stop_is_a_fault_until_it_is_reset() {
    let mut running = Running::new(simulated());
    let mut operator = running.operator();
    operator.ask(Command::Enable).unwrap();
    operator.ask(command("velocity 5,0,0,0,0")).unwrap();
    operator.ask(Command::EmergencyStop).unwrap();
    let state = operator.wait_state(|state| state.mode == "fault");
    assert_eq!(state.fault.unwrap().kind, "emergency_stop");
    let (problem, message) = operator.ask(Command::Reset).unwrap_err();
    assert!(problem == Problem::Refused && message.contains("release_stop"), "{message}");
    operator.ask(Command::ReleaseStop).unwrap();
    operator.ask(Command::Reset).unwrap();
    operator.ask(Command::Enable).unwrap();
    operator.wait_state(|state| state.mode == "ready" && state.fault.is_none());
    assert_eq!(running.end().fault, None);
    let steps = running.steps();
    let stopped = steps.iter().position(|step| step.emergency_stop).unwrap();
    assert!(steps[stopped].mode == "fault" && !steps[stopped].amplifiers_enabled);
}

#[test]
fn a_client_that_does_not_read_costs_itself_messages_and_nothing_else() {
    let mut session = simulated();
    session.real_time = true;
    let mut running = Running::new(session);
    let lazy = local::connect(&running.socket()).unwrap();
    let mut others: Vec<_> = (0..4).map(|_| running.operator()).collect();
    others[0].ask(Command::Enable).unwrap();
    // Events by the hundred: far more than the sockets hold.
    for n in 0..1500 {
        let operator = &mut others[n % 4];
        if operator.ask(Command::Store { on: n % 2 == 0 }).is_err() {
            std::thread::sleep(Duration::from_millis(50));
        }
    }
    for operator in &mut others {
        let state = operator.wait_state(|state| state.tick > 100);
        assert_eq!((state.dropped.states, state.dropped.events), (0, 0));
    }
    let report = running.end();
    drop(lazy);
    assert_eq!((report.clients, report.states_dropped, report.events_dropped), (5, 0, 0));
    assert_eq!(report.log.unwrap().unwrap().dropped_steps, 0);
}

#[test]
fn a_full_disk_ends_a_simulated_run_in_the_safe_state() {
    let shelf = Shelf::default();
    let running = Running::with_log(simulated(), shelf.clone());
    let mut operator = running.operator();
    operator.ask(Command::Enable).unwrap();
    let room = shelf.0.lock().unwrap().bytes.len() + 20_000;
    shelf.0.lock().unwrap().room = Some(room);
    operator.ask(command("velocity 1,0,0,0,0 30")).unwrap();
    let mut running = running;
    let report = running.host.take().unwrap().wait().unwrap();
    assert_eq!(report.ending, Ending::LogFailed);
    let error = report.log.unwrap().unwrap_err().to_string();
    assert!(error.contains("no space left"), "{error}");
    loop {
        if let ServerMessage::End { reason } = operator.next() {
            assert!(reason.contains("log"), "{reason}");
            break;
        }
    }
    assert_eq!(operator.state.unwrap().mode, "off");
}

#[test]
fn in_real_time_a_full_or_slow_disk_does_not_touch_control() {
    for (room, delay) in [(Some(50_000), Duration::ZERO), (None, Duration::from_millis(300))] {
        let shelf = Shelf::default();
        shelf.0.lock().unwrap().room = room;
        shelf.0.lock().unwrap().delay = delay;
        let mut session = simulated();
        session.real_time = true;
        let mut running = Running::with_log(session, shelf);
        let mut operator = running.operator();
        operator.ask(Command::Enable).unwrap();
        operator.ask(command("move_joints 10,40,90,0,30")).unwrap();
        operator.wait("trajectory_ended/joint_move/completed");
        let report = running.end();
        assert_eq!((report.ending, report.fault), (Ending::Asked, None));
        assert_eq!(report.log.unwrap().is_err(), room.is_some());
        let timing = report.timing.unwrap();
        assert_eq!(timing.lateness.total(), report.ticks);
    }
}

#[test]
fn in_real_time_the_end_record_tells_about_time() {
    let mut session = simulated();
    (session.real_time, session.most_ticks) = (true, Some(200));
    let mut running = Running::new(session);
    let report = running.host.take().unwrap().wait().unwrap();
    assert_eq!(report.ending, Ending::TimeIsUp);
    let mut end = None;
    soilctl_session::read::scan::<soilctl_session::SessionError>(&running.log_file(), &mut |item| {
        if let soilctl_session::read::Item::Metadata { name: "soilctl.end", content } = item {
            end = Some(content.clone());
        }
        Ok(())
    })
    .unwrap();
    let end = end.unwrap();
    assert_eq!(end["steps"], "202");
    assert_eq!(end["overruns"], report.timing.unwrap().overruns.to_string());
    assert!(end["lateness"].contains("worst"), "{end:?}");
}

#[test]
fn a_socket_in_use_is_refused() {
    let mut running = Running::new(simulated());
    let second = soilctl_live::Host::start(simulated(), &running.socket(), None::<Shelf>);
    assert!(matches!(second.err(), Some(LiveError::Taken { .. })));
    assert!(running.operator().ask(Command::Enable).is_ok());
    running.end();
}
