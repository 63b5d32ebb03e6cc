//! Recordings that other programs wrote: all containers tell the same.
#![allow(clippy::unwrap_used, clippy::expect_used)]

mod common;

use std::path::Path;

use common::{data, expected, expected_of_known_types, readings};
use soilctl_bag::{BagError, Container, Early, Item, is_recording, kind, scan};

#[test]
fn every_container_tells_the_same() {
    for (name, container, compressions) in [
        ("none.mcap", Container::Mcap, &[][..]),
        ("zstd.mcap", Container::Mcap, &["zstd"]),
        ("lz4.mcap", Container::Mcap, &["lz4"]),
        ("unchunked.mcap", Container::Mcap, &[]),
        ("bare.mcap", Container::Mcap, &["lz4"]),
        ("big_endian.mcap", Container::Mcap, &["zstd"]),
        ("ros1.mcap", Container::Mcap, &["lz4"]),
        ("mcap/mcap.mcap", Container::Mcap, &[]),
        ("mcap_file/mcap_file.mcap.zstd", Container::Mcap, &["zstd"]),
        ("mcap", Container::Folder, &[]),
        ("mcap_file", Container::Folder, &["zstd"]),
        ("split", Container::Folder, &["zstd"]),
        ("sqlite/sqlite.db3", Container::Db3, &[]),
        ("sqlite", Container::Folder, &[]),
        ("sqlite_message", Container::Folder, &["zstd"]),
        ("sqlite_file", Container::Folder, &["zstd"]),
        ("sqlite_file/sqlite_file.db3.zstd", Container::Db3, &["zstd"]),
        ("none.bag", Container::Ros1, &[]),
        ("bz2.bag", Container::Ros1, &["bz2"]),
        ("lz4.bag", Container::Ros1, &["lz4"]),
    ] {
        let path = data(name);
        assert_eq!(kind(&path).unwrap(), container, "{name}");
        assert!(is_recording(&path), "{name}");
        let (found, ending) = readings(&path);
        assert_eq!(ending.damage, [""; 0], "{name}");
        assert_eq!(found, expected(), "{name}");
        assert!(ending.compressions.iter().map(String::as_str).eq(compressions.iter().copied()), "{name}");
        assert!(ending.bytes > 2000, "{name}: {}", ending.bytes);
    }
    for name in ["make.py", "sqlite/metadata.yaml", ""] {
        assert!(!is_recording(&data(name)), "{name}");
        assert!(matches!(kind(&data(name)), Err(BagError::NotARecording { .. })), "{name}");
    }
}

/// Definitions in IDL are not read, and before Iron ROS 2 recorded none, but the common types are known.
#[test]
fn recordings_without_definitions() {
    for name in ["idl.mcap", "old.db3"] {
        let (found, ending) = readings(&data(name));
        assert!(ending.is_whole(), "{ending:?}");
        assert_eq!(found, expected_of_known_types());
    }
}

#[test]
fn a_visitor_ends_a_scan_early() {
    for name in ["lz4.mcap", "split", "sqlite", "bz2.bag"] {
        let mut seen = 0;
        let ended = scan(&data(name), &mut |item| {
            seen += u32::from(matches!(item, Item::Message(_)));
            if seen == 3 { Err(Early::Enough) } else { Ok(()) }
        });
        assert!(matches!(ended, Err(Early::Enough)), "{name}");
        assert_eq!(seen, 3, "{name}");
    }
}

fn copy(from: &Path, to: &Path) {
    std::fs::create_dir(to).unwrap();
    for entry in std::fs::read_dir(from).unwrap() {
        let entry = entry.unwrap();
        std::fs::copy(entry.path(), to.join(entry.file_name())).unwrap();
    }
}

fn message_of(path: &Path) -> String {
    kind(path).unwrap_err().to_string()
}

#[test]
fn folders_in_any_state() {
    let dir = tempfile::tempdir().unwrap();
    let bag = dir.path().join("split");
    copy(&data("split"), &bag);
    // A recorder that was killed leaves no list.
    std::fs::remove_file(bag.join("metadata.yaml")).unwrap();
    assert!(!is_recording(&bag));
    let (found, ending) = readings(&bag);
    assert!(ending.is_whole(), "{ending:?}");
    assert_eq!(found, expected());
    // Numbers count as numbers.
    std::fs::rename(bag.join("split_2.mcap"), bag.join("split_10.mcap")).unwrap();
    assert_eq!(readings(&bag).0, expected());
    std::fs::rename(bag.join("split_10.mcap"), bag.join("split_2.mcap")).unwrap();
    // A missing part, and one that the list does not name.
    let list = "rosbag2_bagfile_information:\n  relative_file_paths:\n  - split/split_0.mcap\n  - split_1.mcap\n  - ../split_9.mcap\n";
    std::fs::write(bag.join("metadata.yaml"), list).unwrap();
    std::fs::write(dir.path().join("split_9.mcap"), "").unwrap();
    std::fs::remove_file(bag.join("split_1.mcap")).unwrap();
    let (found, ending) = readings(&bag);
    assert_eq!(found, expected()[..found.len()]);
    assert_eq!(
        ending.damage,
        [
            "metadata.yaml lists `split_1.mcap`, which is not in the folder",
            "metadata.yaml lists `../split_9.mcap`, which is not in the folder",
            "split_2.mcap is left out, since metadata.yaml does not list it",
        ]
    );
    // A part that is none.
    std::fs::write(bag.join("split_1.mcap"), "no recording").unwrap();
    let (_, ending) = readings(&bag);
    assert!(ending.damage.iter().any(|text| text.contains("a part is left out")), "{ending:?}");
    // A list that is none: then the names tell.
    std::fs::write(bag.join("metadata.yaml"), "rosbag2_bagfile_information: [").unwrap();
    std::fs::remove_file(bag.join("split_1.mcap")).unwrap();
    let (_, ending) = readings(&bag);
    assert!(ending.damage.iter().any(|text| text.contains("malformed")), "{ending:?}");
    // Several recordings are not one.
    std::fs::remove_file(bag.join("metadata.yaml")).unwrap();
    std::fs::copy(data("none.bag"), bag.join("other.bag")).unwrap();
    assert!(message_of(&bag).contains("2 recordings; give one of them"), "{}", message_of(&bag));
    std::fs::write(bag.join("metadata.yaml"), "rosbag2_bagfile_information:\n  relative_file_paths: [a, b]")
        .unwrap();
    assert!(message_of(&bag).contains("none of the files"), "{}", message_of(&bag));
}

#[test]
fn what_is_no_recording_is_refused_in_words() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("a.mcap");
    for (content, words) in [
        (&b""[..], "it is empty"),
        (b"#ROSBAG V1.2\n", "before 2.0"),
        (b"PK\x03\x04", "50 4b 03 04"),
        (b"\x28\xb5\x2f\xfd\x00", "damaged at its beginning"),
    ] {
        std::fs::write(&path, content).unwrap();
        assert!(message_of(&path).contains(words), "{}", message_of(&path));
    }
    assert!(matches!(kind(&dir.path().join("nothing")), Err(BagError::File { .. })));
    std::fs::remove_file(&path).unwrap();
    assert!(message_of(dir.path()).contains("a folder without a recording"));
}
