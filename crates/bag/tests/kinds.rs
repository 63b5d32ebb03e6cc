//! What messages tell is known by their fields, whatever the types are called.
#![allow(clippy::unwrap_used, clippy::expect_used)]

use proptest::prelude::*;
use soilctl_bag::{Channel, Kind, Reader, Reading};
use soilctl_session::messages::{JointState, WrenchStamped, decode};

fn channel(message_type: &str, text: &str) -> Channel {
    Channel {
        topic: "/a".into(),
        message_type: message_type.into(),
        message_encoding: "cdr".into(),
        schema_encoding: if text.is_empty() { "" } else { "ros2msg" }.into(),
        schema: text.as_bytes().to_vec(),
        metadata: Default::default(),
    }
}

fn reader(text: &str) -> Reader {
    Reader::of(&channel("vendor_msgs/msg/Thing", text)).unwrap()
}

const LINE: &str = "\n================================================================================\n";

#[test]
fn kinds_by_structure() {
    let wrench =
        format!("{LINE}MSG: v/W\nv/V torque\nv/V force{LINE}MSG: v/V\nfloat32 z\nfloat32 y\nfloat32 x");
    let six = "float64 fx\nfloat64 fy\nfloat64 fz\nfloat64 tx\nfloat64 ty\nfloat64 tz";
    for (text, kind) in [
        ("string data", Some(Kind::Text)),
        ("string text", None),
        ("string[] name\nfloat64[] position", Some(Kind::Joints)),
        (
            "std_msgs/Header header\nstring[6] name\nfloat32[<=6] position\nuint8[] modes\nint32 x",
            Some(Kind::Joints),
        ),
        ("string name\nfloat64 position", None),
        ("string[] name\nint32[] position", None),
        (six, None),
        ("geometry_msgs/Wrench a", Some(Kind::Wrench)),
        ("geometry_msgs/Wrench a\ngeometry_msgs/Wrench b", None),
        ("geometry_msgs/Wrench[] a", None),
        ("geometry_msgs/Wrench a\nfloat64[36] covariance", None),
        (
            "geometry_msgs/WrenchStamped a\nbool ok\nstring unit\nbuiltin_interfaces/Time stamp",
            Some(Kind::Wrench),
        ),
        ("geometry_msgs/Wrench a\nstd_msgs/String b", None),
        ("geometry_msgs/Transform a", None),
        ("sensor_msgs/JointState state\nstd_msgs/Header h", Some(Kind::Joints)),
        ("std_msgs/Header header", None),
        ("", None),
        (&format!("v/W w\nint8 x{wrench}"), Some(Kind::Wrench)),
        (&format!("v/V force\nv/V torque\nv/V moment{wrench}"), None),
        (&format!("v/V force\nv/V torque{wrench}"), Some(Kind::Wrench)),
    ] {
        let found =
            if text.is_empty() { Reader::of(&channel("std_msgs/Empty", "")).unwrap() } else { reader(text) };
        assert_eq!(found.kind(), kind, "{text}");
    }
}

/// Axes in another order, numbers of four bytes, and stamps inside and outside.
#[test]
fn a_wrench_wrapped_twice() {
    let text = format!(
        "builtin_interfaces/Time stamp\nint8 x\nv/S inner{LINE}MSG: v/S\nstd_msgs/Header header\nv/W w{LINE}MSG: v/W\nv/V torque\n\
         v/V force{LINE}MSG: v/V\nfloat32 z\nfloat32 y\nfloat32 x"
    );
    let reader = reader(&text);
    let message = |outer: u32, inner: u32| {
        let mut bytes = vec![0, 1, 0, 0];
        bytes.extend([outer.to_le_bytes(), 5_u32.to_le_bytes()].concat());
        bytes.extend([7, 0, 0, 0]);
        bytes.extend([inner.to_le_bytes(), 0_u32.to_le_bytes(), 2_u32.to_le_bytes()].concat());
        bytes.extend(b"f\0\0\0");
        (1..=6_u8).for_each(|i| bytes.extend(f32::from(i).to_le_bytes()));
        bytes
    };
    let read = |outer, inner| reader.read(&message(outer, inner)).unwrap().unwrap();
    let expected = |ns| Reading::Wrench {
        stamp_ns: Some(ns),
        frame: "f".into(),
        wrench: [6.0, 5.0, 4.0, 3.0, 2.0, 1.0],
    };
    // The inner one is of the measurement.
    assert_eq!(read(8, 3), expected(3_000_000_000));
    assert_eq!(read(8, 0), expected(8_000_000_005));
    assert_eq!(reader.stamp_ns(&message(8, 3)), Ok(Some(8_000_000_005)));
}

#[test]
fn what_cannot_be_read_is_told_in_words() {
    let of = |change: &dyn Fn(&mut Channel)| {
        let mut channel = channel("std_msgs/msg/String", "string data");
        change(&mut channel);
        Reader::of(&channel).err().unwrap_or_default()
    };
    assert_eq!(of(&|_| {}), "");
    assert_eq!(
        of(&|channel| channel.message_encoding = "json".into()),
        "messages encoded as `json` are not read, only `cdr` and `ros1`"
    );
    let idl = of(&|channel| {
        channel.schema_encoding = "ros2idl".into();
        channel.message_type = "a/msg/B".into();
    });
    assert_eq!(idl, "a/msg/B is defined in `ros2idl`, which is not read, only `ros2msg` and `ros1msg`");
    assert!(of(&|channel| channel.schema = vec![0xff]).contains("UTF-8"));
    let text = reader("string data");
    for (bytes, words) in [
        (&[0, 1, 0][..], "it has 3 bytes"),
        (&[0, 3, 0, 0], "parameter list"),
        (&[0, 7, 0, 0], "version 2 of XCDR (0007)"),
        (&[9, 9, 0, 0], "begins with 0909"),
        (&[0, 1, 0, 0, 4, 0, 0, 0, 65], "4 more are needed"),
        (&[0, 1, 0, 0, 1, 0, 0, 0, 65], "does not end with a zero"),
        (&[0, 1, 0, 0, 2, 0, 0, 0, 0xff, 0], "not UTF-8"),
    ] {
        let said = text.read(bytes).unwrap().unwrap_err();
        assert!(said.contains(words), "{said}");
    }
    assert_eq!(text.read(&[0, 1, 0, 0, 0, 0, 0, 0]), Some(Ok(Reading::Text(String::new()))));
    let joints = reader("string[] name\nfloat64[] position");
    let said = |bytes: &[u8]| joints.read(bytes).unwrap().unwrap_err();
    assert_eq!(said(&[0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]), "it has no positions");
    let one = [&[0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0][..], &[0; 8]].concat();
    assert_eq!(said(&one), "it has 0 names of joints, but 1 positions");
    let long = [0, 1, 0, 0, 0xff, 0xff, 0xff, 0xff, 0, 0, 0, 0];
    assert_eq!(said(&long), "a list of 4294967295 values does not fit into the 4 bytes left");
}

/// CDR with its alignment, written here once more.
struct Writer(Vec<u8>);

impl Writer {
    fn put(&mut self, bytes: &[u8]) {
        while !(self.0.len() - 4).is_multiple_of(bytes.len()) {
            self.0.push(0);
        }
        self.0.extend(bytes);
    }

    fn text(&mut self, text: &str) {
        self.put(&u32::try_from(text.len() + 1).unwrap().to_le_bytes());
        self.0.extend(text.as_bytes());
        self.0.push(0);
    }

    fn header(sec: i32, nanosec: u32, frame: &str) -> Self {
        let mut writer = Self(vec![0, 1, 0, 0]);
        writer.put(&sec.to_le_bytes());
        writer.put(&nanosec.to_le_bytes());
        writer.text(frame);
        writer
    }

    fn floats(&mut self, values: &[f64]) {
        self.put(&u32::try_from(values.len()).unwrap().to_le_bytes());
        values.iter().for_each(|value| self.put(&value.to_le_bytes()));
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 500, failure_persistence: None, ..ProptestConfig::default() })]

    /// As `cdr-encoding` reads it, which knows the type by heart.
    #[test]
    fn wrenches_as_another_reader_has_them(
        sec in any::<i32>(), nanosec in 0..1_000_000_000_u32, frame in "[a-zé/]{0,9}", wrench in any::<[f64; 6]>(),
    ) {
        let mut writer = Writer::header(sec, nanosec, &frame);
        wrench.iter().for_each(|value| writer.put(&value.to_le_bytes()));
        let theirs: WrenchStamped = decode(&writer.0).unwrap();
        let reader = Reader::of(&channel("geometry_msgs/msg/WrenchStamped", "")).unwrap();
        let Some(Ok(Reading::Wrench { stamp_ns, frame: named, wrench: read })) = reader.read(&writer.0) else { panic!() };
        prop_assert_eq!(stamp_ns, theirs.header.stamp.ns());
        prop_assert_eq!(named, theirs.header.frame_id);
        let [f, t] = [theirs.wrench.force, theirs.wrench.torque];
        prop_assert_eq!(read.map(f64::to_bits), [f.x, f.y, f.z, t.x, t.y, t.z].map(f64::to_bits));
    }

    #[test]
    fn joint_states_as_another_reader_has_them(
        sec in any::<i32>(), frame in "[a-z]{0,9}", joints in prop::collection::vec(("[a-z_é]{0,9}", any::<f64>()), 1..9),
        velocity in prop::collection::vec(any::<f64>(), 0..9),
    ) {
        let mut writer = Writer::header(sec, 0, &frame);
        writer.put(&u32::try_from(joints.len()).unwrap().to_le_bytes());
        joints.iter().for_each(|(name, _)| writer.text(name));
        writer.floats(&joints.iter().map(|(_, value)| *value).collect::<Vec<_>>());
        writer.floats(&velocity);
        writer.floats(&[]);
        let theirs: JointState = decode(&writer.0).unwrap();
        let reader = Reader::of(&channel("sensor_msgs/msg/JointState", "")).unwrap();
        let Some(Ok(Reading::Joints { stamp_ns, names, positions })) = reader.read(&writer.0) else { panic!() };
        prop_assert_eq!(stamp_ns, theirs.header.stamp.ns());
        prop_assert_eq!(names, theirs.name);
        let bits = |values: &[f64]| values.iter().map(|value| value.to_bits()).collect::<Vec<_>>();
        prop_assert_eq!(bits(&positions), bits(&theirs.position));
        prop_assert!(reader.cells(&writer.0).is_ok());
    }
}
