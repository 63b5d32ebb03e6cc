//! Recordings as other programs write them, by the writer of the crate `mcap`.
#![allow(
    dead_code,
    clippy::unwrap_used,
    clippy::missing_panics_doc,
    unreachable_pub,
    reason = "each test file uses some of it"
)]

use std::collections::BTreeMap;
use std::fs::File;
use std::path::{Path, PathBuf};

use soilctl_session::messages::{Header, JointState, StringMessage, Time, Wrench, WrenchStamped, encode};

pub const START_S: i64 = 1_700_000_000;
pub const JOINTS: &str = "sensor_msgs/msg/JointState";
pub const WRENCH: &str = "geometry_msgs/msg/WrenchStamped";

/// A turning column that carries a sliding boom, with a sensor turned by a quarter about y; the gripper has a mimic.
pub const URDF: &str = r#"<robot name="crane"><link name="base"/><link name="column"/><link name="boom"/><link name="ft"/>
<link name="finger"/><link name="thumb"/>
<joint name="turn" type="revolute"><parent link="base"/><child link="column"/><origin xyz="0 0 0.5"/><axis xyz="0 0 1"/>
<limit lower="-3" upper="3" effort="1" velocity="1"/></joint>
<joint name="reach" type="prismatic"><parent link="column"/><child link="boom"/><origin xyz="0.2 0 0"/><axis xyz="1 0 0"/>
<limit lower="0" upper="1" effort="1" velocity="1"/></joint>
<joint name="cell" type="fixed"><parent link="boom"/><child link="ft"/><origin rpy="0 1.5707963267948966 0"/></joint>
<joint name="grip" type="prismatic"><parent link="column"/><child link="finger"/><axis xyz="0 1 0"/>
<limit lower="0" upper="1" effort="1" velocity="1"/></joint>
<joint name="other" type="prismatic"><parent link="column"/><child link="thumb"/><axis xyz="0 -1 0"/><mimic joint="grip"/>
<limit lower="0" upper="1" effort="1" velocity="1"/></joint></robot>"#;

pub struct Bag {
    writer: mcap::Writer<std::io::BufWriter<File>>,
    channels: BTreeMap<String, u16>,
}

impl Bag {
    pub fn new(path: &Path) -> Self {
        let file = std::io::BufWriter::new(File::create(path).unwrap());
        Self { writer: mcap::Writer::new(file).unwrap(), channels: BTreeMap::new() }
    }

    /// `t_s` and `logged_s` count from [`START_S`].
    pub fn put(&mut self, topic: &str, message_type: &str, logged_s: f64, data: &[u8]) {
        if !self.channels.contains_key(topic) {
            let schema = self.writer.add_schema(message_type, "ros2msg", b"").unwrap();
            let channel = self.writer.add_channel(schema, topic, "cdr", &BTreeMap::new()).unwrap();
            self.channels.insert(topic.to_owned(), channel);
        }
        let time = START_S as u64 * 1_000_000_000 + (logged_s * 1e9).round() as u64;
        let header = mcap::records::MessageHeader {
            channel_id: self.channels[topic],
            sequence: 0,
            log_time: time,
            publish_time: time,
        };
        self.writer.write_to_known_channel(&header, data).unwrap();
    }

    pub fn joints(&mut self, topic: &str, t_s: f64, joints: &[(&str, f64)]) {
        let message = JointState {
            header: header(t_s, ""),
            name: joints.iter().map(|(name, _)| (*name).to_owned()).collect(),
            position: joints.iter().map(|(_, position)| *position).collect(),
            ..JointState::default()
        };
        self.put(topic, JOINTS, t_s + 0.002, &encode(&message).unwrap());
    }

    pub fn wrench(&mut self, topic: &str, t_s: f64, wrench: [f64; 6]) {
        let [x, y, z, a, b, c] = wrench;
        let wrench = Wrench { force: [x, y, z].into(), torque: [a, b, c].into() };
        let message = WrenchStamped { header: header(t_s, "ft"), wrench };
        self.put(topic, WRENCH, t_s + 0.002, &encode(&message).unwrap());
    }

    pub fn text(&mut self, topic: &str, t_s: f64, text: &str) {
        let message = StringMessage { data: text.to_owned() };
        self.put(topic, "std_msgs/msg/String", t_s, &encode(&message).unwrap());
    }

    pub fn finish(mut self) {
        self.writer.finish().unwrap();
    }
}

fn header(t_s: f64, frame: &str) -> Header {
    let ns = (t_s * 1e9).round() as i64;
    let stamp = Time {
        sec: i32::try_from(START_S + ns.div_euclid(1_000_000_000)).unwrap(),
        nanosec: u32::try_from(ns.rem_euclid(1_000_000_000)).unwrap(),
    };
    Header { stamp, frame_id: frame.to_owned() }
}

/// Where the crane is at a time.
pub fn positions(t_s: f64) -> [(&'static str, f64); 2] {
    [("turn", 0.5 * t_s.sin()), ("reach", 0.1 + 0.05 * t_s)]
}

/// Ten seconds of the crane at 100 Hz, but for times that `leave_out` says.
pub fn crane(path: &Path, leave_out: &dyn Fn(f64) -> bool) {
    let mut bag = Bag::new(path);
    bag.text("/robot_description", 0.5, URDF);
    for k in 0..1000 {
        let t_s = 0.5 + 0.01 * f64::from(k);
        bag.joints("/joint_states", t_s, &positions(t_s));
        if k % 5 == 0 {
            bag.joints("/gripper", t_s, &[("grip", 0.01)]);
        }
        if !leave_out(t_s) {
            bag.wrench("/wrench", t_s, [1.0 + t_s.sin(), 2.0, 3.0, 0.1, 0.2, 0.3]);
        }
    }
    bag.finish();
}

pub fn folder() -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("log.mcap");
    (folder, path)
}
