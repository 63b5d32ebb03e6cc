//! Damaged files: a recovered prefix or a clear error, never a panic, and what is recovered reads again as a whole.
#![allow(clippy::unwrap_used, clippy::expect_used)]

mod common;

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;
use std::sync::atomic::AtomicBool;

use common::write_log;
use proptest::prelude::*;
use soilctl_session::read::{Item, scan, scan_from};
use soilctl_session::{
    Form, SessionError, export, export_until, info, info_until, recover, recover_until, replay, replay_until,
    topics,
};

const TICKS: u64 = 1600;

/// A whole log, written once.
static LOG: LazyLock<Vec<u8>> = LazyLock::new(|| {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("whole.mcap");
    write_log(&path, 1, TICKS);
    std::fs::read(&path).unwrap()
});

/// The encoded steps that a scan of these bytes shows, and whether it found the file whole.
fn steps(bytes: &[u8]) -> Result<(Vec<Vec<u8>>, bool), SessionError> {
    let mut found = Vec::new();
    let mut source = bytes;
    let ending = scan_from::<SessionError>(&mut source, Path::new("bytes"), &mut |item| {
        if let Item::Message(message) = item
            && message.channel.topic == topics::STEP
        {
            found.push(message.data.to_vec());
        }
        Ok(())
    })?;
    Ok((found, ending.is_whole()))
}

static STEPS: LazyLock<Vec<Vec<u8>>> = LazyLock::new(|| {
    let (found, whole) = steps(&LOG).unwrap();
    assert!(whole && found.len() as u64 == TICKS);
    found
});

fn save(dir: &Path, bytes: &[u8]) -> PathBuf {
    let path = dir.join("damaged.mcap");
    std::fs::write(&path, bytes).unwrap();
    path
}

#[test]
fn a_cut_at_any_place_loses_less_than_a_chunk() {
    let mut lengths = BTreeSet::new();
    let mut place = 0;
    // More than a thousand places.
    while place < LOG.len() {
        match steps(&LOG[..place]) {
            Ok((found, whole)) => {
                assert!(!whole, "{place}");
                assert_eq!(found, STEPS[..found.len()], "{place}");
                lengths.insert(found.len());
            }
            Err(SessionError::NotALog { .. }) => assert!(place < 100, "{place}"),
            Err(other) => panic!("{place}: {other}"),
        }
        place += LOG.len() / 1009;
    }
    // Flushed every 500 steps, nothing in between.
    assert_eq!(lengths, BTreeSet::from([0, 500, 1000, 1500, 1600]));
}

#[test]
fn recovered_files_are_whole_and_replay() {
    let dir = tempfile::tempdir().unwrap();
    let path = save(dir.path(), &LOG[..LOG.len() * 4 / 5]);
    let fixed = dir.path().join("fixed.mcap");
    let saved = recover(&path, &fixed).unwrap();
    assert!(!saved.ending.is_whole() && saved.steps >= 1000, "{saved:?}");
    let found = info(&fixed).unwrap();
    assert!(found.ending.is_whole(), "{:?}", found.ending);
    assert_eq!(found.steps, saved.steps);
    assert_eq!(found.problems, ["there is no metadata record soilctl.end: the run did not end well"]);
    let again = replay(&fixed, 0).unwrap();
    assert!(again.is_identical());
    assert_eq!(again.steps, saved.steps);
    // A file that needs nothing comes out with the same content.
    let saved = recover(&fixed, &path).unwrap();
    assert!(saved.ending.is_whole());
    assert_eq!(info(&path).unwrap(), found_with(&info(&fixed).unwrap(), &path));
    assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 2, "nothing else is left");
}

fn found_with(found: &soilctl_session::Info, path: &Path) -> soilctl_session::Info {
    let mut found = found.clone();
    found.ending.bytes = std::fs::metadata(path).unwrap().len();
    found
}

/// A damaged chunk is left out; what comes after it is there.
#[test]
fn a_flipped_byte_costs_one_chunk() {
    let dir = tempfile::tempdir().unwrap();
    let mut bytes = LOG.clone();
    let place = bytes.len() / 2;
    bytes[place] ^= 0x10;
    let path = save(dir.path(), &bytes);
    let found = info(&path).unwrap();
    assert!(found.ending.damage.iter().any(|text| text.contains("left out")), "{:?}", found.ending);
    assert_eq!(found.missing_steps % 500, 0);
    assert_eq!(found.steps + found.missing_steps, TICKS);
    let around = replay(&path, 0).unwrap();
    assert!(around.is_identical());
    assert_eq!(around.steps, found.steps, "the steps after the gap are replayed from their key frame");
}

#[test]
fn what_is_no_log_is_said_to_be_none() {
    let dir = tempfile::tempdir().unwrap();
    for bytes in [&b""[..], b"soil", b"\x89MCAP0\r\n", &[0; 4096], &LOG[..20]] {
        let path = save(dir.path(), bytes);
        for error in [
            info(&path).unwrap_err(),
            recover(&path, &dir.path().join("out.mcap")).unwrap_err(),
            replay(&path, 0).unwrap_err(),
            export(&path, topics::STEP, &dir.path().join("out.csv"), Form::Csv).unwrap_err(),
        ] {
            assert!(matches!(error, SessionError::NotALog { .. }), "{error}");
            assert!(error.to_string().contains("damaged.mcap is not an MCAP file"), "{error}");
        }
    }
    assert!(matches!(info(&dir.path().join("none.mcap")), Err(SessionError::File { .. })));
    assert!(matches!(info(dir.path()), Err(SessionError::File { .. })));
    assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 1, "no half of an answer is left");
}

/// Reads damaged bytes in all ways.
fn read_all(bytes: &[u8]) {
    let dir = tempfile::tempdir().unwrap();
    let path = save(dir.path(), bytes);
    if let Ok((found, whole)) = steps(bytes) {
        // No step is made up: each is one of those written, in order.
        let mut known = STEPS.iter();
        for step in &found {
            assert!(known.any(|other| other == step));
        }
        assert!(!whole || found.len() == STEPS.len());
    }
    let fixed = dir.path().join("fixed.mcap");
    if recover(&path, &fixed).is_ok() {
        assert!(scan::<SessionError>(&fixed, &mut |_| Ok(())).unwrap().is_whole());
    }
    let _ = replay(&path, 0);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn flipped_bytes_are_found(places in prop::collection::vec((any::<prop::sample::Index>(), 1_u8..), 1..8)) {
        let mut bytes = LOG.clone();
        for (place, flip) in places {
            let place = place.index(bytes.len());
            bytes[place] ^= flip;
        }
        read_all(&bytes);
    }

    /// The parts outside of chunks, which have lengths and no checksum of their own.
    #[test]
    fn flipped_bytes_near_the_ends_are_found(place in 0_usize..2000, flip in 1_u8.., from_end in any::<bool>()) {
        let mut bytes = LOG.clone();
        let place = if from_end { bytes.len() - 1 - place } else { place };
        bytes[place] ^= flip;
        read_all(&bytes);
    }

    #[test]
    fn pieces_that_are_missing_or_doubled_are_found(
        from in any::<prop::sample::Index>(), length in 1_usize..5000, twice in any::<bool>(),
    ) {
        let from = from.index(LOG.len());
        let to = (from + length).min(LOG.len());
        let mut bytes = LOG[..if twice { to } else { from }].to_vec();
        bytes.extend_from_slice(&LOG[if twice { from } else { to }..]);
        read_all(&bytes);
    }

    #[test]
    fn noise_after_the_beginning_is_found(noise in prop::collection::vec(any::<u8>(), 0..3000), keep in 8_usize..4000) {
        let mut bytes = LOG[..keep].to_vec();
        bytes.extend_from_slice(&noise);
        read_all(&bytes);
    }
}

#[test]
fn who_stops_has_no_answer_and_no_file() {
    let dir = tempfile::tempdir().unwrap();
    let path = save(dir.path(), &LOG);
    let (out, stop) = (dir.path().join("out.csv"), AtomicBool::new(true));
    let stopped = |error: SessionError| assert!(matches!(error, SessionError::Stopped), "{error}");
    stopped(info_until(&path, &stop).unwrap_err());
    stopped(replay_until(&path, 0, &stop).unwrap_err());
    stopped(recover_until(&path, &out, &stop).unwrap_err());
    stopped(export_until(&path, topics::STEP, &out, Form::Csv, &stop).unwrap_err());
    assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 1, "only the log");
}
