//! Recordings that are cut, flipped or made up: what can be read is read, the rest is told in words, and nothing panics or hangs.
#![allow(clippy::unwrap_used, clippy::expect_used)]

mod common;

use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use common::{data, expected, readings};
use soilctl_bag::definition::{Definition, Ros};
use soilctl_bag::{BagError, Channel, Contents, Ending, Item, Rates, Reader, Readers, scan};

/// Knuth's linear congruential numbers: the same in every run.
struct Random(u64);

impl Random {
    fn below(&mut self, most: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        usize::try_from(self.0 >> 33).unwrap() % most.max(1)
    }
}

/// [`read_all`] of these bytes. Each is a file of its own, since writing over one may wait for the disk.
fn read_bytes(dir: &Path, bytes: &[u8]) -> Result<(u64, Ending), BagError> {
    static COUNT: AtomicUsize = AtomicUsize::new(0);
    let path = dir.join(COUNT.fetch_add(1, Ordering::Relaxed).to_string());
    std::fs::write(&path, bytes).unwrap();
    let done = read_all(&path);
    std::fs::remove_file(&path).unwrap();
    done
}

/// Everything that this crate can do with a recording.
fn read_all(path: &Path) -> Result<(u64, Ending), BagError> {
    let started = Instant::now();
    let (mut messages, mut readers, mut rates, mut contents) =
        (0, Readers::new(), Rates::default(), Contents::default());
    let ending = scan::<BagError>(path, &mut |item| {
        contents.note(&item);
        if let Item::Message(message) = item {
            messages += 1;
            rates.note(&message);
            let _ = readers.read(&message);
            if let Ok(reader) = readers.reader(&message) {
                let _ = reader.cells(message.data);
            }
        }
        Ok(())
    });
    let _ = rates.finish();
    assert!(started.elapsed() < Duration::from_secs(10), "{:?}", started.elapsed());
    ending.map(|ending| (messages, ending))
}

/// Files with their names in the recording, of which one at a time is damaged.
const FILES: [&str; 16] = [
    "none.mcap",
    "zstd.mcap",
    "lz4.mcap",
    "unchunked.mcap",
    "bare.mcap",
    "ros1.mcap",
    "mcap_file/mcap_file.mcap.zstd",
    "sqlite/sqlite.db3",
    "sqlite_message/sqlite_message.db3",
    "sqlite_file/sqlite_file.db3.zstd",
    "old.db3",
    "none.bag",
    "bz2.bag",
    "lz4.bag",
    "../clouds/clouds.mcap",
    "../clouds/clouds.bag",
];

#[test]
fn cut_files_are_read_as_far_as_they_go() {
    let dir = tempfile::tempdir().unwrap();
    for name in FILES {
        let whole = std::fs::read(data(name)).unwrap();
        let count = read_all(&data(name)).unwrap().0;
        let mut most = 0;
        for i in 0..150 {
            // Also some bytes from the end.
            let length = if i < 30 { whole.len() - 1 - i } else { whole.len() * (i - 30) / 120 };
            match read_bytes(dir.path(), &whole[..length]) {
                Ok((messages, ending)) => {
                    assert!(!ending.is_whole(), "{name} cut at {length}");
                    assert!(messages <= count, "{name} cut at {length}: {messages} of {count}");
                    most = most.max(messages);
                }
                Err(BagError::NotARecording { .. }) => {}
                Err(other) => panic!("{name} cut at {length}: {other}"),
            }
        }
        // A database without its last page is not much, a log without its last byte is all.
        assert!(most > 0 || name.contains("zstd"), "{name}");
    }
}

#[test]
fn flipped_bytes_never_panic_or_hang() {
    let dir = tempfile::tempdir().unwrap();
    for (seed, name) in FILES.iter().enumerate() {
        let whole = std::fs::read(data(name)).unwrap();
        let mut random = Random(seed as u64);
        for _ in 0..FLIPS {
            let mut bytes = whole.clone();
            for _ in 0..=random.below(3) {
                let place = random.below(bytes.len());
                // Half of them where the file says what it is made of.
                let place = if random.below(2) == 0 { place % 600 } else { place };
                bytes[place] ^= 1 << random.below(8);
            }
            match read_bytes(dir.path(), &bytes) {
                Ok(_) | Err(BagError::NotARecording { .. } | BagError::TooLarge { .. }) => {}
                Err(other) => panic!("{name}: {other}"),
            }
        }
    }
}
const FLIPS: usize = 1000;

/// A chunk with a checksum that is damaged costs its messages and no others, and never changes one.
#[test]
fn a_damaged_chunk_changes_nothing_else() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("flipped.mcap");
    let whole = std::fs::read(data("lz4.mcap")).unwrap();
    let expected = expected();
    let mut random = Random(99);
    for _ in 0..300 {
        let mut bytes = whole.clone();
        // The data section; chunks have a checksum, their headers do not.
        let place = 200 + random.below(6000);
        bytes[place] ^= 1 << random.below(8);
        std::fs::write(&path, &bytes).unwrap();
        let (found, ending) = readings(&path);
        assert!(found.len() == expected.len() || !ending.is_whole(), "{place}");
        assert!(found.iter().all(|reading| expected.contains(reading)), "{place}");
    }
}

#[test]
fn bombs_are_refused() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("a.db3.zstd");
    let mut bomb = b"SQLite format 3\0".to_vec();
    bomb.resize(80 << 20, 0);
    std::fs::write(&path, zstd::encode_all(&bomb[..], 1).unwrap()).unwrap();
    let said = read_all(&path).unwrap_err().to_string();
    assert!(said.contains("has more than 67108864 bytes once it is decompressed"), "{said}");
}

/// Channels of a recording with one of their messages.
fn samples() -> Vec<(Channel, Vec<u8>)> {
    let mut all: Vec<(Channel, Vec<u8>)> = Vec::new();
    for name in ["none.mcap", "none.bag", "big_endian.mcap"] {
        let mut seen = std::collections::BTreeSet::new();
        scan::<BagError>(&data(name), &mut |item| {
            if let Item::Message(message) = item
                && seen.insert(message.channel.topic.clone())
            {
                all.push((message.channel.clone(), message.data.to_vec()));
            }
            Ok(())
        })
        .unwrap();
    }
    all
}

#[test]
fn messages_that_do_not_fit_their_definition() {
    let mut random = Random(5);
    for (channel, whole) in samples() {
        let reader = Reader::of(&channel).unwrap();
        assert!(reader.cells(&whole).is_ok());
        for length in 0..whole.len() {
            let cut = &whole[..length];
            assert!(
                reader.cells(cut).is_err() && reader.read(cut).is_none_or(|read| read.is_err()),
                "{length}"
            );
            let _ = reader.stamp_ns(cut);
        }
        let mut long = whole.clone();
        long.extend([0; 4]);
        assert!(reader.cells(&long).unwrap_err().contains("left over"), "{}", channel.topic);
        for _ in 0..5000 {
            let mut bytes = whole.clone();
            for _ in 0..=random.below(4) {
                let place = random.below(bytes.len());
                bytes[place] =
                    if random.below(2) == 0 { 0xff } else { u8::try_from(random.below(256)).unwrap() };
            }
            let (cells, read) = (reader.cells(&bytes), reader.read(&bytes));
            // Text that is not UTF-8 is shown in a table, but names nothing.
            assert!(cells.is_ok() || read.is_none_or(|read| read.is_err()), "{}", channel.topic);
            let _ = reader.stamp_ns(&bytes);
        }
    }
}

#[test]
fn definitions_that_are_none() {
    let mut random = Random(6);
    for (channel, message) in samples() {
        for _ in 0..400 {
            let mut channel = channel.clone();
            for _ in 0..=random.below(3) {
                let place = random.below(channel.schema.len());
                if let Some(byte) = channel.schema.get_mut(place) {
                    *byte = b" \n=#[]</09azMS:_"[random.below(16)];
                }
            }
            if let Ok(reader) = Reader::of(&channel) {
                let _ = (reader.cells(&message), reader.read(&message), reader.stamp_ns(&message));
            }
        }
    }
}

#[test]
fn definitions_made_to_do_harm() {
    let line = "=".repeat(80);
    let refused = |text: &str| Definition::parse(Ros::Two, "a/A", text).unwrap_err();
    assert!(refused("A a").contains("contains itself"));
    assert!(refused(&format!("B[] b\n{line}\nMSG: a/B\nA[] a")).contains("contains itself"));
    assert!(refused("B b").contains("no definition of the type a/B"));
    assert!(refused("wstring w").contains("not read"));
    assert!(refused(&format!("B b\n{line}\nIDL: a/B\n")).contains("instead of `MSG: package/Type`"));
    assert!(refused(&"int32 x\n".repeat(30_000)).contains("more than any message"));
    assert!(refused(&"# comment\n".repeat(200_000)).contains("bytes"));
    let deep =
        (0..40).fold("T0 t".to_owned(), |text, i| text + &format!("\n{line}\nMSG: a/T{i}\nT{} t", i + 1));
    assert!(refused(&format!("{deep}\n{line}\nMSG: a/T40\nint32 x")).contains("nested more than 32 deep"));
    // Twenty levels of a hundred fields each that take no bytes: they are left out, or there would be 10^40 of them.
    for ros in [Ros::One, Ros::Two] {
        let mut text = "T0[1000000] t\nint32 x".to_owned();
        for i in 0..20 {
            text += &format!("\n{line}\nMSG: a/T{i}\n{}", format!("T{} t\n", i + 1).repeat(100));
        }
        text += &format!("{line}\nMSG: a/T20\n# nothing\n");
        let channel = Channel {
            topic: "/a".into(),
            message_type: "a/A".into(),
            message_encoding: if ros == Ros::One { "ros1" } else { "cdr" }.into(),
            schema_encoding: "ros2msg".into(),
            schema: text.into_bytes(),
            metadata: Default::default(),
        };
        let started = Instant::now();
        let reader = Reader::of(&channel).unwrap();
        let read = reader.cells(&[0, 1, 0, 0, 5, 0, 0, 0][if ros == Ros::One { 4.. } else { 0.. }]);
        assert_eq!(read.is_ok(), ros == Ros::One, "{read:?}");
        assert!(started.elapsed() < Duration::from_secs(2));
    }
}
