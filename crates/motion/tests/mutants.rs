//! Recordings, robots and meshes that were made to do harm: whatever byte is wrong, nothing panics or hangs. `SOILCTL_MUTANTS` says how many
//! of each, 40 without it; `cargo xtask verify` makes 2500.
#![allow(clippy::unwrap_used, clippy::cast_precision_loss)]

use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};

use soilctl_motion::{Settings, Sought, inspect, motion, table};

/// No mutant of these files, a few tens of kB each, may take longer.
const LONGEST: Duration = Duration::from_secs(10);
/// An arm with the joints of `crates/bag/tests/data`, and a mesh on each link.
const URDF: &str = r#"<robot name="arm"><link name="world"/>
<link name="cart"><visual><geometry><mesh filename="package://arm/a.stl" scale="1 -1 2"/></geometry></visual></link>
<link name="lift"><visual><origin rpy="0 1 0"/><geometry><mesh filename="b.glb"/></geometry></visual>
<visual><geometry><capsule radius="0.1" length="0.3"/></geometry></visual></link>
<joint name="base" type="revolute"><parent link="world"/><child link="cart"/><axis xyz="0 1 0"/><limit lower="-2" upper="2" effort="1" velocity="1"/></joint>
<joint name="arm" type="continuous"><parent link="cart"/><child link="lift"/><origin xyz="0 0 0.1" rpy="0 0.1 0"/><axis xyz="0 0 1"/></joint></robot>"#;

/// A linear congruence.
struct Random(u64);

impl Random {
    fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        usize::try_from(self.0 >> 33).unwrap() % end.max(1)
    }

    /// Some bytes changed, cut out or doubled.
    fn mutant(&mut self, bytes: &[u8]) -> Vec<u8> {
        let mut changed = bytes.to_vec();
        for _ in 0..=self.below(8) {
            let at = self.below(changed.len());
            match self.below(5) {
                0 => changed.truncate(at.max(1)),
                1 => {
                    let end = (at + self.below(200)).min(changed.len());
                    let piece = changed[at..end].to_vec();
                    changed.splice(at..at, piece);
                }
                2 => drop(changed.drain(at..(at + self.below(64)).min(changed.len()))),
                _ => {
                    if let Some(byte) = changed.get_mut(at) {
                        *byte = u8::try_from(self.below(256)).unwrap();
                    }
                }
            }
            if changed.is_empty() {
                changed.push(0);
            }
        }
        changed
    }
}

fn count() -> usize {
    std::env::var("SOILCTL_MUTANTS").ok().and_then(|text| text.parse().ok()).unwrap_or(40)
}

fn corpus() -> Vec<PathBuf> {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../bag/tests/data");
    let mut files: Vec<_> = std::fs::read_dir(&data).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.retain(|path| path.is_file() && soilctl_bag::is_recording(path));
    files.sort();
    assert!(files.len() >= 8, "{files:?}");
    files
}

/// A text with three triangles, and a binary file of glTF with one.
fn meshes() -> [(&'static str, Vec<u8>); 2] {
    let facet =
        "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
    let json = r#"{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"children":[1],"rotation":[0,0,0,1]},
        {"mesh":0,"scale":[1,2,3]}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"material":0}]}],
        "materials":[{"pbrMetallicRoughness":{"baseColorFactor":[1,0,0,1]}}],
        "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},{"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"}],
        "bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":6}],"buffers":[{"byteLength":44}]}"#;
    let mut json = json.as_bytes().to_vec();
    json.resize(json.len().next_multiple_of(4), b' ');
    let mut binary: Vec<u8> = [0.0_f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0]
        .iter()
        .flat_map(|value| value.to_le_bytes())
        .collect();
    binary.extend([0, 0, 1, 0, 2, 0, 0, 0]);
    let word = |count: usize| u32::try_from(count).unwrap().to_le_bytes();
    let glb = [
        &b"glTF\x02\0\0\0"[..],
        &word(28 + json.len() + binary.len()),
        &word(json.len()),
        b"JSON",
        &json,
        &word(binary.len()),
        b"BIN\0",
        &binary,
    ];
    [("a.stl", format!("solid a\n{}endsolid a\n", facet.repeat(3)).into_bytes()), ("b.glb", glb.concat())]
}

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
    let begun = Instant::now();
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
            assert!(
                found
                    .link_poses(&state.positions)
                    .iter()
                    .flatten()
                    .all(|pose| pose.translation.x.is_finite())
            );
        });
    }
    assert!(begun.elapsed() < LONGEST, "{} takes {:?}", path.display(), begun.elapsed());
}

#[test]
fn recordings_of_every_container() {
    let folder = tempfile::tempdir().unwrap();
    let settings = settings(URDF, folder.path());
    let mut random = Random(31);
    for file in corpus() {
        let bytes = std::fs::read(&file).unwrap();
        let path = folder.path().join(file.file_name().unwrap());
        ask(&file, &settings);
        for _ in 0..count() {
            std::fs::write(&path, random.mutant(&bytes)).unwrap();
            ask(&path, &settings);
        }
    }
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
    for (name, bytes) in meshes() {
        std::fs::write(folder.path().join(name), bytes).unwrap();
    }
    let whole = motion(&path, &settings(URDF, folder.path()), &AtomicBool::new(false)).unwrap();
    assert_eq!((whole.meshes.len(), whole.notes.len()), (2, 0), "{:?}", whole.notes);
    assert_eq!(whole.meshes["package://arm/a.stl"].triangles(), 3);
    for _ in 0..4 * count() {
        let urdf = random.mutant(URDF.as_bytes());
        for (name, bytes) in meshes() {
            std::fs::write(folder.path().join(name), random.mutant(&bytes)).unwrap();
        }
        let urdf =
            if random.below(2) == 0 { URDF.to_owned() } else { String::from_utf8_lossy(&urdf).into_owned() };
        let _ = motion(&path, &settings(&urdf, folder.path()), &AtomicBool::new(false));
    }
}
