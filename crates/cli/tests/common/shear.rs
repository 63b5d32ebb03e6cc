//! Running `soilctl shear` on the data of the project.

use std::path::Path;

use serde_json::Value;

use super::json;

pub(crate) const PA_PER_PSI: f64 = 6_894.757;
/// The stroke of the loose soil at 90 deg in Hong (2001), chapter 6: 1.595 lbf on 1 in by 5 in.
pub(crate) const STROKE: [&str; 12] = [
    "--alpha",
    "90",
    "--depth",
    "0.0254",
    "--width",
    "0.127",
    "--density",
    "1430",
    "--delta",
    "23",
    "--force",
    "7.094914",
];

pub(crate) fn data(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data").join(name);
    path.to_string_lossy().into_owned()
}

/// The table of the four soils with more options.
pub(crate) fn shear(more: &[&str]) -> (i32, Value) {
    json(&[&["shear", &data("direct_shear.csv")], more].concat())
}

/// The synthetic records with more options.
pub(crate) fn raw(more: &[&str]) -> (i32, Value) {
    let (runs, empty_box) = (data("direct_shear_raw/runs.csv"), data("direct_shear_raw/loop.csv"));
    json(&[&["shear", "--raw", &runs, "--loop", &empty_box, "--bias", "0.85"], more].concat())
}

pub(crate) fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

pub(crate) fn list(value: &Value) -> &[Value] {
    value.as_array().unwrap_or_else(|| panic!("{value} is no list"))
}

/// Every part must be in the message.
pub(crate) fn says(message: &str, parts: &[&str]) {
    for part in parts {
        assert!(message.contains(part), "{part:?} is not in: {message}");
    }
}
