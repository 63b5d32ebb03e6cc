//! Whole, damaged and foreign logs; what cannot be shown is refused with a reason, and leaves no file behind.
#![allow(clippy::unwrap_used, reason = "tests")]

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use soilctl_controller::{Commands, Mode, Outputs, Params, Sensed, StrokeSpec};
use soilctl_recording::{Recording, RecordingError, Settings, record};
use soilctl_session::{LogWriter, SessionSetup, StepRecord, Truth};
use tempfile::TempDir;

const STEPS: u64 = 5000;

fn setup() -> SessionSetup {
    let params = Params::thesis();
    SessionSetup::new(params.arm().config(), params.config(), "", 1, "none").unwrap()
}

/// A log of an arm that stands still; its force sensor breaks in the middle.
fn write_log(path: &Path, steps: u64) {
    let mut log = LogWriter::new(std::fs::File::create(path).unwrap(), &setup()).unwrap();
    for step in 0..steps {
        let force = if step == STEPS / 2 { f64::NAN } else { 10.0 };
        let mode = if step < 3 { Mode::Off } else { Mode::Ready };
        let record = StepRecord {
            sensed: Sensed { wrench: [force, 0.0, 0.0, 0.0, 0.0, 0.0], ..Sensed::default() },
            commands: Commands::default(),
            outputs: Outputs { tick: step, mode, ..Outputs::default() },
            stroke: StrokeSpec::default(),
            stroke_index: 0,
            surface_z_m: -0.3,
            truth: Some(Truth::default()),
        };
        log.step(step, &record).unwrap();
        if step % 500 == 0 {
            log.flush().unwrap();
        }
    }
    log.finish(0).unwrap();
}

fn folder() -> (TempDir, PathBuf, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let (log, out) = (folder.path().join("log.mcap"), folder.path().join("out.rrd"));
    (folder, log, out)
}

fn rows(recording: &Recording, entity: &str) -> u64 {
    recording.entities.get(entity).copied().unwrap_or(0)
}

fn refused(log: &Path, out: &Path) -> RecordingError {
    let error = record(log, out, &Settings::default()).unwrap_err();
    let left = std::fs::read_dir(out.parent().unwrap()).unwrap();
    assert!(left.flatten().all(|file| file.path() == log), "a file is left after: {error}");
    error
}

#[test]
fn every_step_is_a_row_whatever_the_sensor_said() {
    let (_folder, log, out) = folder();
    write_log(&log, STEPS);
    let recording = record(&log, &out, &Settings::default()).unwrap();
    assert_eq!((recording.steps, recording.damage.len()), (STEPS, 0));
    for entity in ["/force/plate", "/world/force/sensor", "/world/force/truth", "/joints/position"] {
        assert_eq!(rows(&recording, entity), STEPS, "{entity}");
    }
    // Off, then ready; never a trajectory.
    assert_eq!((rows(&recording, "/state/mode"), rows(&recording, "/state/trajectory")), (2, 0));
    assert_eq!(recording.span_s, [0.0, 0.002 * 4999.0]);
    assert!(std::fs::read(&out).unwrap().starts_with(b"RRF2"));
}

#[test]
fn a_log_that_is_cut_is_shown_as_far_as_it_goes() {
    let (_folder, log, out) = folder();
    write_log(&log, STEPS);
    let whole = std::fs::read(&log).unwrap();
    std::fs::write(&log, &whole[..whole.len() / 2]).unwrap();
    let recording = record(&log, &out, &Settings::default()).unwrap();
    assert!(recording.steps > 0 && recording.steps < STEPS, "{}", recording.steps);
    assert_eq!(rows(&recording, "/force/plate"), recording.steps);
    assert!(recording.damage[0].contains("in the middle"), "{:?}", recording.damage);
}

/// Whatever byte is wrong, there is an answer or a reason, never a panic.
#[test]
fn a_wrong_byte_is_never_a_panic() {
    let (_folder, log, out) = folder();
    write_log(&log, 600);
    let whole = std::fs::read(&log).unwrap();
    for place in (0..whole.len()).step_by(whole.len() / 97) {
        let mut wrong = whole.clone();
        wrong[place] ^= 0x55;
        std::fs::write(&log, wrong).unwrap();
        match record(&log, &out, &Settings::default()) {
            Ok(recording) => assert!(recording.steps <= 600),
            Err(error) => assert!(!error.to_string().is_empty()),
        }
    }
}

#[test]
fn logs_without_settings_or_steps_are_refused() {
    let (_folder, log, out) = folder();
    let mut foreign = mcap::WriteOptions::new().create(std::fs::File::create(&log).unwrap()).unwrap();
    let channel = foreign.add_channel(0, "/controller/step", "json", &BTreeMap::new()).unwrap();
    let header =
        mcap::records::MessageHeader { channel_id: channel, sequence: 0, log_time: 0, publish_time: 0 };
    foreign.write_to_known_channel(&header, b"{}").unwrap();
    foreign.finish().unwrap();
    drop(foreign);
    // Of another program it would need the arm's URDF.
    let error = refused(&log, &out);
    assert!(matches!(error, RecordingError::Motion { .. }), "{error}");
    assert!(error.to_string().contains("--urdf"), "{error}");

    write_log(&log, 0);
    assert!(refused(&log, &out).to_string().contains("no step of the controller"));
}

#[test]
fn files_that_are_no_logs_are_refused() {
    let (_folder, log, out) = folder();
    let missing = refused(&log, &out);
    assert!(matches!(missing, RecordingError::Motion { .. }), "{missing}");
    std::fs::write(&log, "time,force\n0,1\n").unwrap();
    let error = refused(&log, &out);
    assert!(matches!(error, RecordingError::Motion { .. }), "{error}");
    write_log(&log, 10);
    let error =
        record(&log, &log.with_file_name("nowhere").join("out.rrd"), &Settings::default()).unwrap_err();
    assert!(matches!(error, RecordingError::Write { .. }), "{error}");
}
