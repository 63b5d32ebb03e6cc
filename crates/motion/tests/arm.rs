//! Where an arm is, against formulas by hand, and its meshes.
#![allow(clippy::unwrap_used)]

mod common;

use std::sync::atomic::AtomicBool;

use common::{Bag, URDF, crane, folder, positions};
use soilctl_motion::{MotionError, Settings, Sought, motion};

#[test]
fn the_end_point_and_the_force_are_where_formulas_say() {
    let (_folder, path) = folder();
    crane(&path, &|t_s| t_s > 5.0);
    let settings = Settings { end_link: Some("boom".into()), ..Settings::default() };
    let found = motion(&path, &settings, &AtomicBool::new(false)).unwrap();
    // The gripper tells of itself on a topic of its own.
    assert_eq!(found.joints, ["turn", "reach", "grip"]);
    assert_eq!(found.notes, [""; 0]);
    let mut count = 0;
    found.states(found.times_s(0.03), &mut |state| {
        let [(_, turn), (_, reach)] = positions(state.t_s);
        let out = 0.2 + reach;
        let tip = [out * turn.cos(), out * turn.sin(), 0.5];
        for (found, expected) in state.tip_m.unwrap().iter().zip(tip) {
            assert!((found - expected).abs() < 1e-9, "{}: {found} {expected}", state.t_s);
        }
        assert_eq!(state.wrench.is_some(), state.t_s < 5.25, "{}", state.t_s);
        if state.t_s < 5.0 {
            // A quarter about y turns x down, and z ahead.
            let (ahead, side, down) = (3.0, 2.0, 1.0 + state.t_s.sin());
            let force =
                [ahead * turn.cos() - side * turn.sin(), ahead * turn.sin() + side * turn.cos(), -down];
            for (found, expected) in state.force_n.unwrap().iter().zip(force) {
                assert!((found - expected).abs() < 1e-9);
            }
        }
        let poses = found.link_poses(&state.positions);
        let y = |link: &str| {
            let pose = poses[found.urdf.link_index(link).unwrap()].unwrap();
            pose.translation.vector.y
        };
        assert!((y("finger") + y("thumb")).abs() < 1e-12 && (y("finger") - 0.01 * turn.cos()).abs() < 1e-12);
        count += 1;
    });
    // 10 s in steps of 0.03 s.
    assert_eq!(count, 334);
}

#[test]
fn what_is_missing_is_said() {
    let (folder, path) = folder();
    crane(&path, &|_| false);
    let never = AtomicBool::new(false);
    let refused = |settings: Settings| motion(&path, &settings, &never).unwrap_err();
    let topic = |topic: &str| Settings { joint_topic: Some(topic.into()), ..Settings::default() };
    assert!(matches!(refused(topic("/none")), MotionError::Bag(_)));
    let error = refused(topic("/gripper"));
    assert!(matches!(&error, MotionError::Joints { missing, .. } if missing == "reach, turn"), "{error}");
    let link = Settings { end_link: Some("spoon".into()), ..Settings::default() };
    assert!(refused(link).to_string().contains("spoon"));
    let urdf = Settings { urdf: Some("<robot".into()), ..Settings::default() };
    assert!(matches!(refused(urdf), MotionError::Urdf(_)));
    let mut bag = Bag::new(&path);
    bag.joints("/joint_states", 0.5, &positions(0.5));
    bag.finish();
    assert!(motion(&path, &Settings::default(), &never).unwrap_err().to_string().contains("--urdf"));

    // A frame that is none, and meshes that are not there, are no reason to refuse a recording.
    crane(&path, &|_| false);
    let urdf = URDF.replace("\"ft\"", "\"cell\"").replace(
        "<link name=\"boom\"/>",
        "<link name=\"boom\"><visual><geometry><mesh filename=\"package://crane/meshes/boom.stl\"/></geometry></visual></link>",
    );
    let settings = Settings { urdf: Some(urdf), ..Settings::default() };
    let found = motion(&path, &settings, &never).unwrap();
    assert!(found.meshes.is_empty() && found.notes.len() == 2, "{:?}", found.notes);
    assert!(found.notes[0].contains("--sensor-frame") && found.notes[1].contains("--mesh-root"));
    std::fs::create_dir_all(folder.path().join("crane/meshes")).unwrap();
    let stl = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n";
    std::fs::write(folder.path().join("crane/meshes/boom.stl"), stl).unwrap();
    let meshes = Sought { roots: vec![folder.path().to_owned()], urdf_folder: None };
    let found = motion(&path, &Settings { meshes, ..settings }, &never).unwrap();
    assert_eq!((found.meshes.len(), found.notes.len()), (1, 1), "{:?}", found.notes);
}
