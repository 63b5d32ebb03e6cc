//! What is told of whole recordings, and what is wrong with them.
#![allow(clippy::unwrap_used)]

mod common;

use std::path::Path;
use std::sync::atomic::AtomicBool;

use common::{Bag, START_S, URDF, crane, folder, positions};
use soilctl_bag::Kind;
use soilctl_motion::{Inspection, MotionError, inspect};

fn look(path: &Path) -> Inspection {
    inspect(path, &AtomicBool::new(false)).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The same recording in every container: `crates/bag/tests/data/make.py` says what it holds.
#[test]
fn every_container_tells_the_same() {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../bag/tests/data");
    let names = [
        "none.mcap",
        "zstd.mcap",
        "lz4.mcap",
        "unchunked.mcap",
        "none.bag",
        "bz2.bag",
        "lz4.bag",
        "sqlite",
        "split",
        "mcap",
    ];
    for name in names {
        let found = look(&data.join(name));
        assert!(found.ending.is_whole() && found.problems().is_empty(), "{name}: {:?}", found.problems());
        assert_eq!((found.clock.origin_s, found.has_urdf), (START_S, true), "{name}");
        let wrench = &found.topics["/wrench"];
        assert_eq!((wrench.messages, wrench.kind, wrench.gaps), (16, Some(Kind::Wrench), 0), "{name}");
        assert!((wrench.rate_hz.unwrap() - 100.0).abs() < 1e-6, "{name}: {:?}", wrench.rate_hz);
        // Stamps are half a microsecond behind the grid.
        assert!((wrench.span_s[0] - 5e-7).abs() < 1e-9 && (wrench.span_s[1] - 0.150_000_5).abs() < 1e-9);
        assert_eq!(found.topics["/joint_states"].kind, Some(Kind::Joints), "{name}");
        assert!(!found.topics.contains_key("/truth/soil"), "{name}");
    }
}

#[test]
fn a_healthy_recording_is_no_problem_and_a_gap_is_one() {
    let (_folder, path) = folder();
    crane(&path, &|_| false);
    let healthy = look(&path);
    assert_eq!(healthy.problems(), [""; 0]);
    assert!((healthy.span_s[0] - 0.5).abs() < 0.003 && (healthy.span_s[1] - 10.49).abs() < 0.003);
    assert!((healthy.topics["/gripper"].rate_hz.unwrap() - 20.0).abs() < 1e-6);

    crane(&path, &|t_s| (4.0..5.0).contains(&t_s));
    let found = look(&path);
    let wrench = &found.topics["/wrench"];
    assert_eq!(wrench.gaps, 1);
    let [from_s, to_s] = wrench.longest_gaps[0];
    assert!((from_s - 3.99).abs() < 1e-6 && (to_s - 5.0).abs() < 1e-6, "{from_s} {to_s}");
    let [problem] = &found.problems()[..] else { panic!("{:?}", found.problems()) };
    assert!(problem.starts_with("/wrench: a gap of 1.010 s, from 3.990 to 5.000 s"), "{problem}");
}

/// A sender's clock that is set shows as that, and not as a gap.
#[test]
fn a_clock_that_is_set_is_told_on_the_repaired_clock() {
    let (_folder, path) = folder();
    let mut bag = Bag::new(&path);
    for k in 0..600 {
        let t_s = 0.5 + 0.01 * f64::from(k);
        let set_s = if k < 300 { 0.0 } else { 3600.0 };
        let message = soilctl_session::messages::JointState {
            header: soilctl_session::messages::Header {
                stamp: soilctl_session::messages::Time {
                    sec: i32::try_from(START_S).unwrap() + (t_s + set_s) as i32,
                    nanosec: ((t_s + set_s).fract() * 1e9) as u32,
                },
                frame_id: String::new(),
            },
            name: vec!["turn".into()],
            position: vec![t_s],
            ..Default::default()
        };
        bag.put(
            "/joint_states",
            common::JOINTS,
            t_s + 0.002,
            &soilctl_session::messages::encode(&message).unwrap(),
        );
    }
    bag.finish();
    let found = look(&path);
    assert_eq!(found.topics["/joint_states"].gaps, 0);
    assert!((found.span_s[1] - 6.49).abs() < 0.01, "{:?}", found.span_s);
    let [problem] = &found.problems()[..] else { panic!("{:?}", found.problems()) };
    assert!(problem.contains("clock was set ahead by 3600.000 s"), "{problem}");
}

#[test]
fn numbers_in_other_units_are_named() {
    let (_folder, path) = folder();
    let mut bag = Bag::new(&path);
    bag.text("/robot_description", 0.5, URDF);
    for k in 0..200 {
        let t_s = 0.5 + 0.01 * f64::from(k);
        let [turn, reach] = positions(t_s);
        bag.joints("/joint_states", t_s, &[(turn.0, turn.1.to_degrees() + 40.0), (reach.0, 1e3 * reach.1)]);
        bag.wrench("/wrench", t_s, [t_s, 0.0, 1.0, 300.0, 0.0, 0.0]);
    }
    bag.finish();
    let problems = look(&path).problems();
    for (problem, word) in problems.iter().zip(["reach", "turn", "N mm"]) {
        assert!(problem.contains(word), "{problem}");
    }
    assert_eq!(problems.len(), 3, "{problems:?}");
}

#[test]
fn what_is_no_recording_is_refused() {
    let (folder, path) = folder();
    let never = AtomicBool::new(false);
    std::fs::write(&path, "time,force\n").unwrap();
    assert!(matches!(inspect(&path, &never), Err(MotionError::Bag(_))));
    assert!(matches!(inspect(&folder.path().join("none"), &never), Err(MotionError::Bag(_))));
    Bag::new(&path).finish();
    assert_eq!(look(&path).problems(), ["there are no messages"]);
    crane(&path, &|_| false);
    assert!(inspect(&path, &AtomicBool::new(true)).unwrap_err().is_stop());
}
