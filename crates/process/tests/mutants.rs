//! Recordings and robots that were made to do harm: every byte may be wrong, and nothing panics or hangs. `SOILCTL_MUTANTS` says how many
//! of each kind, 40 without it; `cargo xtask verify` makes 2500 of each.
#![allow(clippy::unwrap_used, clippy::cast_precision_loss)]

mod common;

use std::path::Path;
use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};

use common::Random;
use soilctl_process::log::{LogSettings, read_log};

/// No mutant of these files, a few tens of kB each, may take longer.
const LONGEST: Duration = Duration::from_secs(10);
const URDF: &str = include_str!("../../../fuzz/corpus/urdf/arm.urdf");

fn below(random: &mut Random, end: usize) -> usize {
    ((random.uniform() * end as f64) as usize).min(end.saturating_sub(1))
}

/// Some bytes changed, cut out or doubled.
fn mutant(bytes: &[u8], random: &mut Random) -> Vec<u8> {
    let mut changed = bytes.to_vec();
    for _ in 0..=below(random, 8) {
        let at = below(random, changed.len());
        match below(random, 5) {
            0 => changed.truncate(at.max(1)),
            1 => {
                let end = (at + below(random, 200)).min(changed.len());
                let piece = changed[at..end].to_vec();
                changed.splice(at..at, piece);
            }
            2 => drop(changed.drain(at..(at + below(random, 64)).min(changed.len()))),
            _ => {
                if let Some(byte) = changed.get_mut(at) {
                    *byte = below(random, 256) as u8;
                }
            }
        }
        if changed.is_empty() {
            changed.push(0);
        }
    }
    changed
}

fn count() -> usize {
    std::env::var("SOILCTL_MUTANTS").ok().and_then(|text| text.parse().ok()).unwrap_or(40)
}

fn read(path: &Path, urdf: &str) {
    let settings = LogSettings {
        urdf: Some(urdf.to_owned()),
        plate_frame: Some("edge".into()),
        surface_z_m: Some(0.05),
        width_m: Some(0.1),
        sensor_frame: Some("ft".into()),
        ..LogSettings::default()
    };
    let begun = Instant::now();
    // Whatever it says, it says something.
    let _ = read_log(path, &settings, &AtomicBool::new(false), &mut |_| {});
    assert!(begun.elapsed() < LONGEST, "{} takes {:?}", path.display(), begun.elapsed());
}

#[test]
fn recordings_of_every_container() {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../bag/tests/data");
    let mut files: Vec<_> = std::fs::read_dir(&data).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.retain(|path| path.is_file() && soilctl_bag::is_recording(path));
    files.sort();
    assert!(files.len() >= 8, "{files:?}");
    let folder = tempfile::tempdir().unwrap();
    let mut random = Random(22);
    for file in files {
        let bytes = std::fs::read(&file).unwrap();
        let path = folder.path().join(file.file_name().unwrap());
        read(&file, URDF);
        for _ in 0..count() {
            std::fs::write(&path, mutant(&bytes, &mut random)).unwrap();
            read(&path, URDF);
        }
    }
}

#[test]
fn robots() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../bag/tests/data/none.mcap");
    let mut random = Random(23);
    for _ in 0..4 * count() {
        let urdf = mutant(URDF.as_bytes(), &mut random);
        read(&path, &String::from_utf8_lossy(&urdf));
    }
}
