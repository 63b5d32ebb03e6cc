//! What the targets share.

use std::path::Path;
use std::sync::atomic::AtomicBool;

use soilctl_motion::{inspect, table};
use soilctl_process::log::{LogSettings, read_log};
use soilctl_recording::{Settings, record};

/// An arm whose joints the recordings of the corpus name.
#[allow(dead_code, reason = "the target of robots brings its own")]
pub const ARM: &str = include_str!("../corpus/urdf/arm.urdf");

/// Does with a recording what `process`, `log` and `view` do, and `monitor`, which reads as `view` does. Whatever they say, they say
/// something.
pub fn read(recording: &Path, urdf: &str) {
    let never = AtomicBool::new(false);
    let settings = LogSettings {
        urdf: Some(urdf.to_owned()),
        plate_frame: Some("edge".into()),
        surface_z_m: Some(0.05),
        width_m: Some(0.1),
        sensor_frame: Some("ft".into()),
        ..LogSettings::default()
    };
    let _ = read_log(recording, &settings, &never, &mut |_| {});
    if let Ok(found) = inspect(recording, &never) {
        for topic in found.topics.keys() {
            let _ = table(recording, topic, &never, &mut |_| Ok(()), &mut |_| Ok(()));
        }
    }
    let out = std::env::temp_dir().join(format!("soilctl-fuzz-{}.rrd", std::process::id()));
    let settings = Settings { urdf: Some(urdf.to_owned()), ..Settings::default() };
    let _ = record(recording, &out, &settings);
}
