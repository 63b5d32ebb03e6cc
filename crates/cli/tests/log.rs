//! `soilctl log` and `soilctl replay`.
#![allow(clippy::unwrap_used, reason = "tests")]

mod common;

use std::path::{Path, PathBuf};

use common::{json, refused, soilctl};
use soilctl_controller::{Commands, Params, Sensed, State, step};
use soilctl_session::{LogWriter, SessionSetup, StepRecord};

/// A log of a switched-off arm whose force sensor fails at the end. With `forged`, one logged bit is not what came out.
fn log(dir: &Path, steps: u64, forged: bool) -> PathBuf {
    let path = dir.join(if forged { "forged.mcap" } else { "run.mcap" });
    let thesis = Params::thesis();
    let setup = SessionSetup::new(thesis.arm().config(), thesis.config(), "", 7, "none").unwrap();
    let params = setup.params().unwrap();
    let mut state = State::new(&params);
    let mut writer = LogWriter::new(std::fs::File::create(&path).unwrap(), &setup).unwrap();
    for number in 0..steps {
        if number % 500 == 0 {
            writer.keyframe(number, &state).unwrap();
            writer.flush().unwrap();
        }
        let force = if number + 1 == steps { f64::NAN } else { 0.5 + 1e-3 * number as f64 };
        let sensed = Sensed {
            tick: number + 1,
            wrench: [force; 6],
            amplifier_voltage_v: [48.0; 5],
            motor_sequence: number as u32,
            external_sequence: number as u32,
            wrench_sequence: number as u32,
            amplifier_sequence: number as u32,
            ..Sensed::default()
        };
        let commands = Commands { heartbeat: number as u32, ..Commands::default() };
        let mut outputs = step(&params, &mut state, &sensed, &commands);
        if forged && number == 600 {
            outputs.telemetry.lead_m = 1e-300;
        }
        writer.step(number, &StepRecord::new(&sensed, &commands, &outputs, &state, None)).unwrap();
    }
    writer.finish(0).unwrap();
    path
}

fn text(path: &Path) -> &str {
    path.to_str().unwrap()
}

#[test]
fn a_whole_log_is_well_and_replays() {
    let dir = tempfile::tempdir().unwrap();
    let path = log(dir.path(), 1200, false);
    let (code, info) = json(&["log", "info", text(&path)]);
    assert_eq!(code, 0);
    assert_eq!((&info["schema"], &info["whole"]), (&"soilctl.log/1".into(), &true.into()));
    let content = &info["content"];
    assert_eq!((&content["steps"], &content["keyframes"]), (&1200.into(), &3.into()));
    assert_eq!((&content["start_s"], &content["end_s"]), (&0.0.into(), &2.4.into()));
    assert_eq!(content["session"]["seed"], "7");
    let (code, doctor) = json(&["log", "doctor", text(&path)]);
    assert_eq!((code, &doctor["problems"]), (0, &serde_json::json!([])));
    for (options, steps) in [(&[][..], 1200), (&["--from-keyframe", "2"], 200)] {
        let (code, replay) = json(&[&["replay", text(&path)], options].concat());
        assert_eq!(code, 0);
        assert_eq!((&replay["identical"], &replay["steps"]), (&true.into(), &steps.into()));
        assert!(replay["first_difference"].is_null());
    }
    assert!(
        String::from_utf8(soilctl(&["log", "doctor", text(&path)]).stdout)
            .unwrap()
            .ends_with("the log is well\n")
    );
}

#[test]
fn another_bit_is_exit_code_1_and_named() {
    let dir = tempfile::tempdir().unwrap();
    let path = log(dir.path(), 1200, true);
    let (code, replay) = json(&["replay", text(&path)]);
    assert_eq!(code, 1);
    assert_eq!((&replay["identical"], &replay["different_steps"]), (&false.into(), &1.into()));
    let first = &replay["first_difference"];
    assert_eq!(
        (&first["step"], &first["tick"], &first["field"]),
        (&600.into(), &601.into(), &"lead_m".into())
    );
    let words = String::from_utf8(soilctl(&["replay", text(&path)]).stdout).unwrap();
    assert!(words.contains("first step 600 (tick 601): lead_m"), "{words}");
}

#[test]
fn a_cut_log_is_exit_code_3_and_recovered() {
    let dir = tempfile::tempdir().unwrap();
    let path = log(dir.path(), 1200, false);
    let bytes = std::fs::read(&path).unwrap();
    let cut = dir.path().join("cut.mcap");
    std::fs::write(&cut, &bytes[..bytes.len() * 3 / 4]).unwrap();
    let fixed = dir.path().join("fixed.mcap");
    for args in [
        &["log", "info", text(&cut)][..],
        &["log", "doctor", text(&cut)],
        &["log", "recover", text(&cut), "--out", text(&fixed)],
        &["log", "export", text(&cut), "--out", text(&dir.path().join("cut.csv"))],
        &["replay", text(&cut)],
    ] {
        let (code, answer) = json(args);
        assert_eq!(code, 3, "{args:?}");
        assert_eq!(answer["damage"].as_array().unwrap().len(), 1, "{args:?}");
    }
    assert_eq!(json(&["log", "info", text(&fixed)]).0, 0);
    let (code, doctor) = json(&["log", "doctor", text(&fixed)]);
    assert_eq!(code, 1, "the end is missing");
    assert!(doctor["problems"][0].as_str().unwrap().contains("soilctl.end"));
    assert_eq!(json(&["replay", text(&fixed)]).0, 0);
}

#[test]
fn tables_have_a_row_for_each_step_and_keep_nan() {
    let dir = tempfile::tempdir().unwrap();
    let path = log(dir.path(), 600, false);
    let out = dir.path().join("steps.csv");
    let (code, answer) = json(&["log", "export", text(&path), "--out", text(&out)]);
    assert_eq!((code, &answer["written"]["rows"]), (0, &600.into()));
    let table = std::fs::read_to_string(&out).unwrap();
    let mut lines = table.lines();
    let header: Vec<_> = lines.next().unwrap().split(',').collect();
    let column = header.iter().position(|&name| name == "wrench_0").unwrap();
    let cells: Vec<_> = lines.map(|line| line.split(',').nth(column).unwrap()).collect();
    assert_eq!(cells.len(), 600);
    assert_eq!((cells[3], cells[599]), ("0.503", "NaN"));
}

#[test]
fn wrong_use_is_refused() {
    let dir = tempfile::tempdir().unwrap();
    let path = log(dir.path(), 10, false);
    let none = dir.path().join("none.mcap");
    assert!(refused(&["log", "info", text(&none)]).contains("none.mcap"));
    assert!(refused(&["log", "recover", text(&path), "--out", text(&path)]).contains("the log itself"));
    assert!(refused(&["log", "export", text(&path), "--out", "a.xls"]).contains(".csv or .parquet"));
    let message = refused(&["log", "export", text(&path), "--out", "a.csv", "--topic", "/tf"]);
    assert!(message.contains("/tf cannot be exported") && message.contains("/controller/step"), "{message}");
    assert!(refused(&["replay", text(&path), "--from-keyframe", "1"]).contains("the log has 1"));
    let message = refused(&["replay", concat!(env!("CARGO_MANIFEST_DIR"), "/Cargo.toml")]);
    assert!(message.contains("not an MCAP file"), "{message}");
}
