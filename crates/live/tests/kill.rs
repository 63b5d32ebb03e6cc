//! A session in real time that is killed loses at most a second of its log.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod common;

use std::fs::File;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use common::{LONG, Operator, simulated};
use soilctl_live::Host;
use soilctl_session::{recover, replay};

const CHILD: &str = "SOILCTL_TEST_KILLED_SESSION";

/// Not a test but the process that is killed: this program, started again.
#[test]
fn child() {
    let Ok(dir) = std::env::var(CHILD) else { return };
    let dir = Path::new(&dir);
    let mut session = simulated();
    session.real_time = true;
    let log = File::create(dir.join("run.mcap")).unwrap();
    Host::start(session, &dir.join("live"), Some(log)).unwrap().wait().unwrap();
}

fn kill_after(ticks: u64) {
    let dir = tempfile::tempdir().unwrap();
    let mut child = Command::new(std::env::current_exe().unwrap())
        .args(["child", "--exact", "--test-threads=1"])
        .env(CHILD, dir.path())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let begin = Instant::now();
    let socket = dir.path().join("live");
    while soilctl_live::local::connect(&socket).is_err() {
        assert!(begin.elapsed() < LONG, "it does not start");
        std::thread::sleep(Duration::from_millis(10));
    }
    let mut operator = Operator::new(&socket);
    let seen = operator.wait_state(|state| state.tick >= ticks);
    child.kill().unwrap();
    child.wait().unwrap();

    let fixed = dir.path().join("fixed.mcap");
    let saved = recover(&dir.path().join("run.mcap"), &fixed).unwrap();
    assert!(!saved.ending.is_whole(), "it was killed");
    assert!(saved.steps + 500 >= seen.tick, "{} steps of {} are in the file", saved.steps, seen.tick);
    let again = replay(&fixed, 0).unwrap();
    assert!(again.is_identical() && again.steps == saved.steps, "{again:?}");
}

#[test]
fn a_killed_session_loses_at_most_a_second() {
    kill_after(700);
}

#[test]
#[ignore = "takes minutes"]
fn a_session_killed_fifty_times_loses_at_most_a_second() {
    // Times from a generator of this kind are as good as random, and the same in every run.
    (1..=50_u64).map(|n| n.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 54).for_each(kill_after);
}
