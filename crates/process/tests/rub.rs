//! Wrenches of a rubbed plate, from every container and in either sense.
#![allow(clippy::unwrap_used)]

use std::path::Path;
use std::sync::atomic::AtomicBool;

use soilctl_mutants::recordings;
use soilctl_process::log::{LogSettings, RubSample, Sense, read_wrenches};

fn read(path: &Path, tare: [f64; 6], sense: Sense) -> Vec<RubSample> {
    let settings = LogSettings { tare: Some(tare), sense, ..LogSettings::default() };
    read_wrenches(path, &settings, &AtomicBool::new(false)).unwrap()
}

#[test]
fn every_container_tells_the_same() {
    let (files, folders) = recordings();
    let known = read(&files[0], [0.0; 6], Sense::SoilOnPlate);
    assert_eq!(known.len(), 16);
    for path in files.iter().chain(&folders) {
        assert_eq!(read(path, [0.0; 6], Sense::SoilOnPlate), known, "{}", path.display());
    }
}

/// A tare is what the sensor reads, in its own sense.
#[test]
fn the_force_of_the_plate_on_the_ground_has_the_other_sign() {
    let path = &recordings().0[0];
    let tare = [0.0, 0.0, 0.25, 0.0, 0.0, 0.0];
    let plain = read(path, tare, Sense::SoilOnPlate);
    let turned = read(path, tare, Sense::PlateOnSoil);
    assert!(plain.iter().zip(&turned).all(|(a, b)| a.normal_n == -b.normal_n && a.tangent_n == b.tangent_n));
}
