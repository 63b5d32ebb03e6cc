//! Recordings and robots that were made to do harm: every byte may be wrong, and nothing panics or hangs.
#![allow(clippy::unwrap_used)]

use std::path::Path;
use std::sync::atomic::AtomicBool;

use soilctl_mutants::{ARM, Random, count, each_mutant, in_time, recordings};
use soilctl_process::log::{LogSettings, read_log};

fn read(path: &Path, urdf: &str) {
    let settings = LogSettings {
        urdf: Some(urdf.to_owned()),
        plate_frame: Some("edge".into()),
        surface_z_m: Some(0.05),
        width_m: Some(0.1),
        sensor_frame: Some("ft".into()),
        ..LogSettings::default()
    };
    // Whatever it says, it says something.
    let _ = read_log(path, &settings, &AtomicBool::new(false), &mut |_| {});
}

#[test]
fn recordings_of_every_container() {
    recordings().0.iter().for_each(|file| read(file, ARM));
    each_mutant(22, |path| read(path, ARM)).unwrap();
}

#[test]
fn robots() {
    let files = recordings().0;
    let path = files.iter().find(|file| file.ends_with("none.mcap")).unwrap();
    let mut random = Random(23);
    for _ in 0..4 * count() {
        let urdf = random.mutant(ARM.as_bytes());
        in_time(path, || read(path, &String::from_utf8_lossy(&urdf)));
    }
}
