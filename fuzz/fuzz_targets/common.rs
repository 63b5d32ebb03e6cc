//! What the targets share.

use std::path::Path;
use std::sync::atomic::AtomicBool;

use soilctl_process::log::{LogSettings, read_log};

/// An arm whose joints the recordings of the corpus name.
#[allow(dead_code, reason = "the target of robots brings its own")]
pub const ARM: &str = include_str!("../corpus/urdf/arm.urdf");

/// Reads a recording as `process` does. Whatever it says, it says something.
pub fn process(recording: &Path, urdf: &str) {
    let settings = LogSettings {
        urdf: Some(urdf.to_owned()),
        plate_frame: Some("edge".into()),
        surface_z_m: Some(0.05),
        width_m: Some(0.1),
        sensor_frame: Some("ft".into()),
        ..LogSettings::default()
    };
    let _ = read_log(recording, &settings, &AtomicBool::new(false), &mut |_| {});
}
