//! Clouds of points that `rosbags` and numpy wrote, and such as contradict themselves.
#![allow(clippy::unwrap_used, clippy::expect_used)]

mod common;

use common::{START_NS, data, readings};
use soilctl_bag::{Channel, Kind, Reader, Reading};

/// In floats and doubles, of either byte order, in rows with padding and without rows.
#[test]
fn clouds_of_others() {
    for file in ["../clouds/clouds.mcap", "../clouds/clouds.bag"] {
        let (found, ending) = readings(&data(file));
        assert!(ending.is_whole() && found.len() == 3, "{file}");
        for (seconds, (topic, _, reading)) in (0_i32..).zip(found) {
            let Ok(Reading::Points { stamp_ns, frame, points, missing }) = reading else {
                panic!("{file}: {reading:?}");
            };
            assert_eq!((topic.as_str(), frame.as_str(), missing), ("/scan", "bin", 1));
            assert_eq!(stamp_ns, Some(START_NS + i64::from(seconds) * 1_000_000_000));
            let expected = [(0, 0), (1, 0), (2, 0), (0, 1), (1, 1)]
                .map(|(i, j)| [f64::from(i) / 8.0, f64::from(j) / 4.0, f64::from(i + j) / 16.0]);
            assert_eq!(points, expected, "{file} {seconds}");
        }
    }
}

/// One point of floats `x`, `y`, `z`, with some of what describes it replaced.
struct Cloud {
    names: [&'static str; 3],
    datatype: u8,
    height: u32,
    width: u32,
    point_step: u32,
    row_step: u32,
    bytes: u32,
}

impl Default for Cloud {
    fn default() -> Self {
        Self {
            names: ["x", "y", "z"],
            datatype: 7,
            height: 1,
            width: 1,
            point_step: 12,
            row_step: 12,
            bytes: 12,
        }
    }
}

impl Cloud {
    /// In the encoding of ROS 1, which aligns nothing.
    fn read(&self) -> Result<Reading, String> {
        let mut bytes = [0_u32; 4].map(u32::to_le_bytes).concat();
        for number in [self.height, self.width, 3] {
            bytes.extend(number.to_le_bytes());
        }
        for (offset, name) in (0_u32..).zip(self.names) {
            bytes.extend(u32::try_from(name.len()).unwrap().to_le_bytes());
            bytes.extend(name.bytes());
            bytes.extend((4 * offset).to_le_bytes());
            bytes.push(self.datatype);
            bytes.extend(1_u32.to_le_bytes());
        }
        bytes.push(0);
        for number in [self.point_step, self.row_step, self.bytes] {
            bytes.extend(number.to_le_bytes());
        }
        bytes.extend(vec![0; self.bytes as usize]);
        bytes.push(1);
        let channel = Channel {
            topic: "/scan".into(),
            message_type: "sensor_msgs/PointCloud2".into(),
            message_encoding: "ros1".into(),
            schema_encoding: String::new(),
            schema: Vec::new(),
            metadata: Default::default(),
        };
        let reader = Reader::of(&channel).unwrap();
        assert_eq!(reader.kind(), Some(Kind::Points));
        reader.read(&bytes).unwrap()
    }
}

#[test]
fn what_contradicts_itself_is_refused() {
    let whole = Cloud::default().read();
    assert!(matches!(whole, Ok(Reading::Points { points, .. }) if points == [[0.0; 3]]));
    let huge = u32::MAX;
    for (cloud, word) in [
        (Cloud { names: ["x", "y", "height"], ..Cloud::default() }, "no channel `z`"),
        (Cloud { datatype: 3, ..Cloud::default() }, "type 3"),
        (Cloud { datatype: 8, ..Cloud::default() }, "ends at byte 16"),
        (Cloud { height: 2, ..Cloud::default() }, "do not hold 2 rows"),
        (Cloud { height: 2, row_step: 0, ..Cloud::default() }, "do not hold 2 rows"),
        (Cloud { height: huge, row_step: huge, point_step: huge, ..Cloud::default() }, "do not hold"),
        (Cloud { point_step: 0, ..Cloud::default() }, "ends at byte 4"),
    ] {
        let problem = cloud.read().unwrap_err();
        assert!(problem.contains(word), "{problem}");
    }
    let wide = Cloud { height: huge, width: 0, row_step: 0, ..Cloud::default() }.read();
    assert!(matches!(wide, Ok(Reading::Points { points, .. }) if points.is_empty()));
    // No row has no points, whatever else it says.
    let none = Cloud { height: 0, row_step: huge, bytes: 0, ..Cloud::default() }.read();
    assert!(matches!(none, Ok(Reading::Points { points, .. }) if points.is_empty()));
}
