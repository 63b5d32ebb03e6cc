//! What the recordings in `data` hold, as `data/make.py` says.
#![allow(dead_code, reason = "each test file uses some of it")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::missing_panics_doc, unreachable_pub)]

use std::path::{Path, PathBuf};

use soilctl_bag::{BagError, Ending, Item, Readers, Reading, scan};

pub const START_NS: i64 = 1_700_000_000_000_000_000;
pub const STEP_NS: i64 = 10_000_000;

pub fn data(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(name)
}

/// Topic, log time and reading of every message of a kind, as a program would get them.
pub type Readings = Vec<(String, u64, Result<Reading, String>)>;

pub fn readings(path: &Path) -> (Readings, Ending) {
    let (mut found, mut readers) = (Vec::new(), Readers::new());
    let ending = scan::<BagError>(path, &mut |item| {
        if let Item::Message(message) = item
            && let Some(reading) = readers.read(&message)
        {
            found.push((message.channel.topic.clone(), message.log_time_ns, reading));
        }
        Ok(())
    });
    (found, ending.unwrap_or_else(|error| panic!("{}: {error}", path.display())))
}

/// The same for what the script wrote.
pub fn expected() -> Readings {
    let mut all: Vec<(String, i64, Reading)> = Vec::new();
    let text = "<?xml version=\"1.0\"?>\n<robot name=\"r\"><link name=\"plate_tip\"/></robot>";
    all.push(("/robot_description".into(), START_NS, Reading::Text(text.into())));
    for i in 0..16_i32 {
        let (t, x) = (START_NS + i64::from(i) * STEP_NS, f64::from(i));
        let wrench = [x / 8.0, -x / 8.0, 1.0, 0.5, 0.25, x * 2.0];
        let stamped =
            |ns: i64, frame: &str| Reading::Wrench { stamp_ns: Some(t + ns), frame: frame.into(), wrench };
        let joints = Reading::Joints {
            stamp_ns: Some(t),
            names: ["base", "arm", "bucket_é"].map(String::from).to_vec(),
            positions: vec![x / 8.0, -x / 8.0, 2.0],
        };
        all.push(("/joint_states".into(), t + 1, joints));
        all.push(("/wrench".into(), t + 2, stamped(500, "ft_sensor")));
        if i % 4 == 0 {
            let bare = Reading::Wrench { stamp_ns: None, frame: String::new(), wrench };
            all.push(("/bare_wrench".into(), t + 3, bare));
            all.push(("/vendor/force".into(), t + 4, stamped(700, "flange")));
        }
    }
    all.push(("/truth/soil".into(), START_NS + 300_000_000, Reading::Text("sand".into())));
    all.into_iter().map(|(topic, t, reading)| (topic, t.unsigned_abs(), Ok(reading))).collect()
}

/// Without the topics of the vendor's own types, which a recording without definitions cannot tell.
pub fn expected_of_known_types() -> Readings {
    expected().into_iter().filter(|(topic, ..)| topic != "/vendor/force").collect()
}
