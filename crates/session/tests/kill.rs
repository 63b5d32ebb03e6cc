//! A process that is killed while it writes loses at most a second.
#![allow(clippy::unwrap_used, clippy::expect_used)]

mod common;

use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Duration;

use common::{Digger, setup};
use soilctl_session::{Logger, Pace, info, recover, replay};

const CHILD: &str = "SOILCTL_TEST_KILLED_LOG";

/// Not a test but the process that is killed: this program, started again.
#[test]
fn child() {
    let Ok(path) = std::env::var(CHILD) else { return };
    let setup = setup(1);
    let (_logger, mut recorder) = Logger::create(Path::new(&path), &setup, Pace::Simulated).unwrap();
    let mut digger = Digger::new(&setup);
    loop {
        assert!(digger.tick(&mut recorder));
        // Steps that were made, for the parent to compare with.
        if recorder.steps().is_multiple_of(50) {
            println!("{}", recorder.steps());
        }
    }
}

fn kill_after(delay: Duration) {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("killed.mcap");
    let mut child = Command::new(std::env::current_exe().unwrap())
        .args(["child", "--exact", "--nocapture", "--test-threads=1"])
        .env(CHILD, &path)
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let out = BufReader::new(child.stdout.take().unwrap());
    let (sender, receiver) = std::sync::mpsc::channel();
    let reader = std::thread::spawn(move || {
        let mut made = 0_u64;
        for line in out.lines().map_while(Result::ok) {
            if let Ok(steps) = line.trim().parse() {
                made = steps;
                let _ = sender.send(());
            }
        }
        made
    });
    // Begin to count when it runs, else a slow start decides.
    receiver.recv_timeout(Duration::from_secs(60)).unwrap();
    std::thread::sleep(delay);
    child.kill().unwrap();
    child.wait().unwrap();
    let made = reader.join().unwrap();

    let fixed = dir.path().join("fixed.mcap");
    let saved = recover(&path, &fixed).unwrap();
    assert!(!saved.ending.is_whole(), "it was killed");
    assert!(saved.steps + 500 >= made, "{made} steps were made, {} are in the file", saved.steps);
    let found = info(&fixed).unwrap();
    assert!(found.ending.is_whole(), "{:?}", found.ending);
    assert_eq!((found.steps, found.missing_steps), (saved.steps, 0));
    let again = replay(&fixed, 0).unwrap_or_else(|error| panic!("{error} after {made} steps"));
    assert!(again.is_identical());
    assert_eq!(again.steps, saved.steps);
}

/// Times from a generator of this kind are as good as random, and the same in every run.
fn delays(count: u64) -> impl Iterator<Item = Duration> {
    (1..=count).map(|n| Duration::from_micros(n.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 44))
}

#[test]
fn a_killed_process_loses_at_most_a_second() {
    delays(5).for_each(kill_after);
}

#[test]
#[ignore = "takes more than a minute"]
fn a_process_killed_fifty_times_loses_at_most_a_second() {
    delays(50).for_each(kill_after);
}
