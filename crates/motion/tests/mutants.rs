//! Recordings, robots and meshes that were made to do harm: whatever byte is wrong, nothing panics or hangs.
#![allow(clippy::unwrap_used)]

use std::path::Path;
use std::sync::atomic::AtomicBool;

use soilctl_motion::{Settings, Sought, inspect, motion, table};
use soilctl_mutants::{Random, count, each_mutant, in_time, recordings};

/// An arm with the joints of `crates/bag/tests/data`, and a mesh on each link.
const URDF: &str = r#"<robot name="arm"><link name="world"/>
<link name="cart"><visual><geometry><mesh filename="package://arm/a.stl" scale="1 -1 2"/></geometry></visual></link>
<link name="lift"><visual><origin rpy="0 1 0"/><geometry><mesh filename="b.glb"/></geometry></visual>
<visual><geometry><capsule radius="0.1" length="0.3"/></geometry></visual></link>
<joint name="base" type="revolute"><parent link="world"/><child link="cart"/><axis xyz="0 1 0"/><limit lower="-2" upper="2" effort="1" velocity="1"/></joint>
<joint name="arm" type="continuous"><parent link="cart"/><child link="lift"/><origin xyz="0 0 0.1" rpy="0 0.1 0"/><axis xyz="0 0 1"/></joint></robot>"#;

/// A text with three triangles, and a binary file of glTF with one.
const MESHES: [(&str, &[u8]); 2] = [
    ("a.stl", include_bytes!("../../../fuzz/corpus/mesh/ascii.stl")),
    ("b.glb", include_bytes!("../../../fuzz/corpus/mesh/scene.glb")),
];

fn settings(urdf: &str, folder: &Path) -> Settings {
    Settings {
        urdf: Some(urdf.to_owned()),
        sensor_link: Some("lift".into()),
        meshes: Sought { roots: vec![folder.to_owned()], urdf_folder: None },
        ..Settings::default()
    }
}

/// All that is asked of a recording. Whatever it says, it says something.
fn ask(path: &Path, settings: &Settings) {
    let never = AtomicBool::new(false);
    in_time(path, || {
        if let Ok(found) = inspect(path, &never) {
            assert!(found.span_s.iter().all(|time| time.is_finite()));
            let _ = found.problems();
            for topic in found.topics.keys() {
                let _ = table(path, topic, &never, &mut |_| Ok(()), &mut |_| Ok(()));
            }
        }
        if let Ok(found) = motion(path, settings, &never) {
            found.states(found.times_s(0.0), &mut |state| {
                assert!(state.tip_m.iter().flatten().all(|part| part.is_finite()));
                let poses = found.link_poses(&state.positions);
                assert!(poses.iter().flatten().all(|pose| pose.translation.x.is_finite()));
            });
        }
    });
}

#[test]
fn recordings_of_every_container() {
    let folder = tempfile::tempdir().unwrap();
    let settings = settings(URDF, folder.path());
    recordings().0.iter().for_each(|file| ask(file, &settings));
    each_mutant(31, |path| ask(path, &settings)).unwrap();
}

#[test]
fn folders_of_split_bags() {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../bag/tests/data/split");
    let folder = tempfile::tempdir().unwrap();
    let settings = settings(URDF, folder.path());
    let parts: Vec<_> = std::fs::read_dir(&data).unwrap().map(|entry| entry.unwrap().path()).collect();
    let mut random = Random(32);
    for _ in 0..count() {
        let bag = folder.path().join("bag");
        std::fs::create_dir_all(&bag).unwrap();
        for part in &parts {
            let bytes = std::fs::read(part).unwrap();
            let changed = if random.below(2) == 0 { random.mutant(&bytes) } else { bytes };
            std::fs::write(bag.join(part.file_name().unwrap()), changed).unwrap();
        }
        ask(&bag, &settings);
    }
}

#[test]
fn robots_and_meshes() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../bag/tests/data/none.mcap");
    let folder = tempfile::tempdir().unwrap();
    let mut random = Random(33);
    for (name, bytes) in MESHES {
        std::fs::write(folder.path().join(name), bytes).unwrap();
    }
    let whole = motion(&path, &settings(URDF, folder.path()), &AtomicBool::new(false)).unwrap();
    assert_eq!((whole.meshes.len(), whole.notes.len()), (2, 0), "{:?}", whole.notes);
    assert_eq!(whole.meshes["package://arm/a.stl"].triangles(), 3);
    for _ in 0..4 * count() {
        let urdf = random.mutant(URDF.as_bytes());
        for (name, bytes) in MESHES {
            std::fs::write(folder.path().join(name), random.mutant(bytes)).unwrap();
        }
        let urdf =
            if random.below(2) == 0 { URDF.to_owned() } else { String::from_utf8_lossy(&urdf).into_owned() };
        let _ = motion(&path, &settings(&urdf, folder.path()), &AtomicBool::new(false));
    }
}
