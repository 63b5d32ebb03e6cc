//! What is in a log, and that a replay gives the same bits.
#![allow(clippy::unwrap_used, clippy::expect_used)]

mod common;

use common::{Digger, STROKE_TICKS, Shelf, setup, write_log};
use soilctl_controller::{Params, State};
use soilctl_session::messages::{ControllerStep, Keyframe};
use soilctl_session::{KEYFRAME_STEPS, LogWriter, Logger, Pace, StepRecord, info, replay, topics};

#[test]
fn settings_keep_their_bits_on_their_way_through_the_log() {
    let params = setup(1).params().unwrap();
    assert_eq!(params.arm(), Params::thesis().arm());
    assert_eq!(params.config(), Params::thesis().config());
    assert_eq!(params.plan().strokes().len(), 48);
}

/// One log for all that only reads it.
#[test]
fn a_stroke_is_logged_and_replayed_bit_for_bit() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("stroke.mcap");
    write_log(&path, 1, STROKE_TICKS);
    let found = info(&path).unwrap();
    assert!(found.ending.is_whole(), "{:?}", found.ending);
    assert_eq!(found.problems, [""; 0]);
    assert_eq!((found.steps, found.missing_steps), (STROKE_TICKS, 0));
    assert_eq!(found.keyframes, STROKE_TICKS / KEYFRAME_STEPS);
    for topic in [topics::STEP, topics::JOINT_STATES, topics::MOTOR_STATES, topics::WRENCH, topics::TRUE_SOIL]
    {
        assert_eq!(found.topics[topic].messages, STROKE_TICKS, "{topic}");
    }
    assert_eq!(found.topics[topics::TF].messages, STROKE_TICKS / 10);
    assert_eq!(found.topics[topics::ROBOT_DESCRIPTION].messages, 1);
    // As configured, then as touched.
    assert_eq!(found.topics[topics::TF_STATIC].messages, 2);
    assert_eq!(found.session["seed"], "1");

    let [stroke] = &found.strokes[..] else { panic!("{:?}", found.strokes) };
    assert_eq!((stroke["radius_m"].as_str(), stroke["depth_m"].as_str()), ("0.4318", "0.02"));
    let tick = |key: &str| stroke[key].parse::<u64>().unwrap();
    assert!(tick("start_tick") > 1000 && tick("end_tick") > tick("start_tick") + 100, "{stroke:?}");

    let whole = replay(&path, 0).unwrap();
    assert!(whole.is_identical(), "{:?}", whole.first_difference);
    assert_eq!((whole.steps, whole.skipped_steps, whole.different_steps), (STROKE_TICKS, 0, 0));
    assert_eq!(whole.keyframes, found.keyframes - 1);
    let frames = u32::try_from(found.keyframes).unwrap();
    for from in 0..frames {
        let part = replay(&path, from).unwrap();
        assert!(part.is_identical(), "from key frame {from}: {:?}", part.first_difference);
        assert_eq!(part.steps, STROKE_TICKS - u64::from(from) * KEYFRAME_STEPS);
    }
    let message = replay(&path, frames).unwrap_err().to_string();
    assert!(message.contains(&format!("no key frame {frames}; the log has {frames}")), "{message}");
}

#[test]
fn the_same_run_gives_the_same_bytes_and_another_seed_others() {
    let bytes = |seed| {
        let (setup, shelf) = (setup(seed), Shelf::default());
        let (logger, mut recorder) = Logger::start(shelf.clone(), &setup, Pace::Simulated).unwrap();
        let mut digger = Digger::new(&setup);
        for _ in 0..2345 {
            digger.tick(&mut recorder);
        }
        drop(recorder);
        logger.finish().unwrap();
        let content = shelf.0.lock().unwrap();
        content.bytes.clone()
    };
    let first = bytes(1);
    assert!(first.len() > 100_000);
    assert_eq!(first, bytes(1));
    assert_ne!(first, bytes(2));
}

/// A log whose outputs are not those of its inputs.
#[test]
fn a_replay_finds_a_single_wrong_bit() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("forged.mcap");
    let setup = setup(1);
    let mut digger = Digger::new(&setup);
    let mut writer = LogWriter::new(std::fs::File::create(&path).unwrap(), &setup).unwrap();
    for number in 0..1200 {
        if number % KEYFRAME_STEPS == 0 {
            writer.keyframe(number, &digger.rig.state).unwrap();
        }
        let (sensed, commands) = (digger.rig.plant.sense(), digger.rig.commands());
        let mut outputs = digger.rig.tick_with(&sensed, &commands);
        if number == 777 {
            let torque = &mut outputs.motor_torques.0[3];
            *torque = f64::from_bits(torque.to_bits() ^ 1);
        }
        let record = StepRecord::new(&sensed, &commands, &outputs, &digger.rig.state, None);
        writer.step(number, &record).unwrap();
    }
    writer.finish(0).unwrap();
    let found = replay(&path, 0).unwrap();
    assert_eq!((found.steps, found.different_steps), (1200, 1));
    let difference = found.first_difference.unwrap();
    assert_eq!((difference.step, difference.field.as_str()), (777, "motor_torques_nm_3"));
    assert!(!difference.logged.is_same(&difference.replayed));
    assert!(replay(&path, 2).unwrap().is_identical());
}

#[test]
fn key_frames_keep_every_bit_of_the_state_and_refuse_others() {
    let setup = setup(1);
    let (logger, mut recorder) = Logger::start(std::io::sink(), &setup, Pace::Simulated).unwrap();
    let mut digger = Digger::new(&setup);
    for _ in 0..3000 {
        digger.tick(&mut recorder);
    }
    drop(recorder);
    logger.finish().unwrap();
    let state: State = digger.rig.state;
    let frame = Keyframe::new(3, 3000, &state).unwrap();
    let back = frame.state().unwrap();
    assert_eq!(back, state);
    assert_eq!(Keyframe::new(3, 3000, &back).unwrap(), frame);

    let newer = Keyframe { version: 2, ..frame.clone() };
    assert!(newer.state().unwrap_err().to_string().contains("version 2"));
    for length in 0..frame.state.len() {
        let cut = Keyframe { state: frame.state[..length].to_vec(), ..frame.clone() };
        assert!(cut.state().is_err(), "{length}");
    }
    let longer = Keyframe { state: [&frame.state[..], &[0]].concat(), ..frame };
    assert!(longer.state().is_err());
}

#[test]
fn a_step_message_gives_its_inputs_back() {
    let mut digger = Digger::new(&setup(1));
    let (sensed, commands) = (digger.rig.plant.sense(), digger.rig.commands());
    let outputs = digger.rig.tick_with(&sensed, &commands);
    let message = ControllerStep::new(5, &sensed, &commands, &outputs);
    assert_eq!(message.sensed(), sensed);
    assert_eq!(message.commands().unwrap(), commands);
    assert!(ControllerStep { request: "dig".to_owned(), ..message }.commands().is_err());
}

#[test]
#[ignore = "takes more than a minute"]
fn a_million_steps_replay_bit_for_bit() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("million.mcap");
    write_log(&path, 1, 1_000_000);
    let found = replay(&path, 0).unwrap();
    assert_eq!((found.steps, found.different_steps), (1_000_000, 0), "{:?}", found.first_difference);
    for from in [1, 500, 1000, 1999] {
        let part = replay(&path, from).unwrap();
        assert!(part.is_identical(), "from key frame {from}: {:?}", part.first_difference);
    }
}
