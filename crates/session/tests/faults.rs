//! A log that cannot be written, or not fast enough.
#![allow(clippy::unwrap_used, clippy::expect_used)]

mod common;

use std::path::Path;
use std::time::Duration;

use common::{Digger, Shelf, setup, write_error};
use soilctl_session::read::scan_from;
use soilctl_session::{Logger, Pace, info, replay};

#[test]
fn a_full_disk_ends_a_simulated_run_with_a_reason() {
    for room in [0, 100, 300_000, 600_000] {
        let (setup, shelf) = (setup(1), Shelf::default());
        shelf.0.lock().unwrap().room = Some(room);
        let mut digger = Digger::new(&setup);
        let result = Logger::start(shelf.clone(), &setup, Pace::Simulated).map(|(logger, mut recorder)| {
            let ran = (0..20_000).take_while(|_| digger.tick(&mut recorder)).count();
            assert!(ran < 20_000, "it must stop");
            assert!(logger.has_failed());
            drop(recorder);
            logger.finish()
        });
        let (steps, reason) = write_error(result.and_then(|result| result));
        assert!(reason.contains("no space left"), "{reason}");
        // What came to the disk before can be read.
        let content = shelf.0.lock().unwrap();
        let mut source = &content.bytes[..];
        let mut messages = 0_u64;
        let scanned = scan_from::<soilctl_session::SessionError>(&mut source, Path::new("full"), &mut |_| {
            messages += 1;
            Ok(())
        });
        assert_eq!(scanned.is_ok(), room >= 100);
        assert!(steps < 500 || messages > 1000, "{room}: {steps} steps, {messages} messages");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_device_without_space_is_reported() {
    let setup = setup(1);
    let result = Logger::create(Path::new("/dev/full"), &setup, Pace::RealTime).map(|(logger, recorder)| {
        drop(recorder);
        logger.finish()
    });
    let (steps, reason) = write_error(result.and_then(|result| result));
    assert_eq!(steps, 0);
    assert!(reason.to_lowercase().contains("no space left"), "{reason}");
}

/// The disk stands still for the whole run. If the recorder waited for it, this test would not end.
#[test]
fn in_real_time_a_stuck_disk_costs_steps_of_the_log_and_nothing_else() {
    let dir = tempfile::tempdir().unwrap();
    let (setup, shelf) = (setup(1), Shelf::default());
    let (logger, mut recorder) = Logger::start(shelf.clone(), &setup, Pace::RealTime).unwrap();
    let mut digger = Digger::new(&setup);
    for _ in 0..1000 {
        assert!(digger.tick(&mut recorder));
    }
    shelf.0.lock().unwrap().stuck = true;
    // Until the logger is in the write that does not end: it writes when a flush is due.
    let mut steps = 1000;
    while !shelf.0.lock().unwrap().waited {
        assert!(digger.tick(&mut recorder));
        steps += 1;
        std::thread::sleep(Duration::from_millis(2));
    }
    for _ in 0..11_000 {
        assert!(digger.tick(&mut recorder), "control goes on");
    }
    steps += 11_000;
    shelf.0.lock().unwrap().stuck = false;
    // And catch up.
    std::thread::sleep(Duration::from_millis(1500));
    for _ in 0..1000 {
        assert!(digger.tick(&mut recorder));
    }
    steps += 1000;
    assert_eq!(recorder.steps(), steps);
    drop(recorder);
    let report = logger.finish().unwrap();
    assert_eq!(report.steps + report.dropped_steps, steps);
    assert!(report.dropped_steps > 0, "{report:?}");

    let path = dir.path().join("gap.mcap");
    std::fs::write(&path, &shelf.0.lock().unwrap().bytes).unwrap();
    let found = info(&path).unwrap();
    assert!(found.ending.is_whole(), "{:?}", found.ending);
    assert_eq!(found.steps, report.steps);
    assert!(
        found.problems.contains(&format!("{} steps are missing", found.missing_steps)),
        "{:?}",
        found.problems
    );
    let again = replay(&path, 0).unwrap();
    assert!(again.is_identical(), "{:?}", again.first_difference);
    assert_eq!(again.steps + again.skipped_steps, report.steps);
    assert!(again.steps > 4000, "{again:?}");
}

#[test]
fn in_real_time_a_full_disk_does_not_stop_control() {
    let (setup, shelf) = (setup(1), Shelf::default());
    let (logger, mut recorder) = Logger::start(shelf.clone(), &setup, Pace::RealTime).unwrap();
    let mut digger = Digger::new(&setup);
    let mut content = shelf.0.lock().unwrap();
    content.room = Some(content.bytes.len());
    drop(content);
    for _ in 0..12_000 {
        assert!(digger.tick(&mut recorder));
    }
    drop(recorder);
    let (_, reason) = write_error(logger.finish());
    assert!(reason.contains("no space left"), "{reason}");
}
