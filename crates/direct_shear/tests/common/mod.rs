//! What several tests need.
#![allow(dead_code, clippy::unwrap_used, clippy::missing_panics_doc)]

use std::path::PathBuf;

use soilctl_direct_shear::{ShearPoint, ShearSeries, low_load_weights, read_shear_points};
use soilctl_soil::{Angle, units};

/// A file of the project's data folder.
pub(crate) fn data(name: &str) -> PathBuf {
    [env!("CARGO_MANIFEST_DIR"), "../../data", name].iter().collect()
}

/// Table 6.13 of Hong (2001).
pub(crate) fn table_6_13() -> Vec<ShearSeries> {
    read_shear_points(data("direct_shear.csv")).unwrap()
}

/// One soil of table 6.13.
pub(crate) fn soil(name: &str) -> Vec<ShearPoint> {
    table_6_13().into_iter().find(|series| series.soil.as_deref() == Some(name)).unwrap().points
}

/// Rained Ticino with 40.0 instead of the printed 43.0 degrees at 1.16 psi.
pub(crate) fn rained_corrected() -> Vec<ShearPoint> {
    let mut points = soil("ticino_rained");
    assert!((points[2].friction().degrees() - 43.0).abs() < 1e-9);
    points[2] = point(1.16, 40.0);
    points
}

/// A point from psi and degrees.
pub(crate) fn point(stress_psi: f64, angle_deg: f64) -> ShearPoint {
    ShearPoint::new(units::psi_to_pa(stress_psi), Angle::from_degrees(angle_deg)).unwrap()
}

/// Rows of a test table, comments and header left out.
pub(crate) fn fixture(name: &str) -> Vec<Vec<String>> {
    let path: PathBuf = [env!("CARGO_MANIFEST_DIR"), "tests/data", name].iter().collect();
    let text = std::fs::read_to_string(path).unwrap();
    let lines = text.lines().filter(|line| !line.starts_with('#')).skip(1);
    lines.map(|line| line.split(',').map(str::to_owned).collect()).collect()
}

/// Weights of 3 for the averages at the low loads, 1 for the single tests.
pub(crate) fn three_to_one(points: &[ShearPoint]) -> Vec<f64> {
    low_load_weights(points, units::psi_to_pa(2.5), 3.0).unwrap()
}
