//! What a user would otherwise write in Rust: the `mcap` crate for the file, and `cdr-encoding` with serde for the messages.

use std::path::Path;

use serde::Deserialize;
use soilctl_bag::{BagError, Item, Readers, Reading, scan};

/// Four bytes say how the rest of a message is encoded; the numbers before the wrench of a step take 72 more.
const WRENCH_AT: usize = 76;

#[derive(Deserialize)]
struct Header {
    sec: i32,
    nanosec: u32,
    frame: String,
}

#[derive(Deserialize)]
struct JointState {
    header: Header,
    name: Vec<String>,
    position: Vec<f64>,
    #[allow(dead_code, reason = "decoded, not used")]
    velocity: Vec<f64>,
    #[allow(dead_code, reason = "decoded, not used")]
    effort: Vec<f64>,
}

#[derive(Deserialize)]
struct WrenchStamped {
    header: Header,
    wrench: [f64; 6],
}

fn cdr<T: serde::de::DeserializeOwned>(data: &[u8]) -> T {
    cdr_encoding::from_bytes::<T, byteorder::LittleEndian>(&data[4..]).unwrap().0
}

fn each(path: &Path, take: &mut dyn FnMut(&str, &[u8])) {
    let bytes = std::fs::read(path).unwrap();
    for message in mcap::MessageStream::new(&bytes).unwrap() {
        let message = message.unwrap();
        take(&message.channel.topic, &message.data);
    }
}

/// The least that one can do with a log of ours: the wrench of each step, at its fixed place in the bytes.
pub(crate) fn wrenches_of_steps(path: &Path) -> usize {
    let mut wrenches: Vec<[f64; 6]> = Vec::new();
    each(path, &mut |topic, data| {
        if topic == "/controller/step" {
            wrenches.push(std::array::from_fn(|i| {
                f64::from_le_bytes(data[WRENCH_AT + 8 * i..][..8].try_into().unwrap())
            }));
        }
    });
    wrenches.len()
}

/// Columns of time and number of a recording of another program.
pub(crate) fn columns(path: &Path) -> (usize, usize) {
    let (mut joints, mut wrenches) = (Columns::default(), Columns::default());
    each(path, &mut |topic, data| match topic {
        "/arm/joint_states" => {
            let JointState { header, name, position, .. } = cdr(data);
            assert_eq!(name.len(), position.len());
            joints.push(&header, position.into_iter());
        }
        "/ft/wrench_raw" => {
            let WrenchStamped { header, wrench } = cdr(data);
            wrenches.push(&header, wrench.into_iter());
        }
        _ => {}
    });
    (joints.rows(), wrenches.rows())
}

/// The same by the crate of this workspace, which looks up what a message means by its definition.
pub(crate) fn our_columns(path: &Path) -> (usize, usize) {
    let (mut joints, mut wrenches) = (Columns::default(), Columns::default());
    let mut readers = Readers::new();
    scan::<BagError>(path, &mut |item| {
        if let Item::Message(message) = item {
            match readers.read(&message) {
                Some(Ok(Reading::Joints { stamp_ns, names, positions })) => {
                    joints.times.push(stamp_ns.unwrap_or(0));
                    joints.numbers.extend(names.iter().zip(positions).map(|(_, value)| value));
                }
                Some(Ok(Reading::Wrench { stamp_ns, wrench, .. })) => {
                    wrenches.times.push(stamp_ns.unwrap_or(0));
                    wrenches.numbers.extend(wrench);
                }
                _ => {}
            }
        }
        Ok(())
    })
    .unwrap();
    (joints.rows(), wrenches.rows())
}

#[derive(Default)]
struct Columns {
    times: Vec<i64>,
    numbers: Vec<f64>,
}

impl Columns {
    fn push(&mut self, header: &Header, numbers: impl Iterator<Item = f64>) {
        assert!(!header.frame.contains('\0'));
        self.times.push(i64::from(header.sec) * 1_000_000_000 + i64::from(header.nanosec));
        self.numbers.extend(numbers);
    }

    fn rows(&self) -> usize {
        assert!(self.numbers.iter().all(|number| number.is_finite()));
        self.times.len()
    }
}
