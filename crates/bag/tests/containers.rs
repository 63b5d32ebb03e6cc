//! Recordings that other programs wrote: all containers tell the same.
#![allow(clippy::unwrap_used, clippy::expect_used)]

mod common;

use common::{data, expected, expected_of_known_types, readings};

#[test]
fn mcap_of_every_form() {
    for (name, compressions) in [
        ("none.mcap", &[][..]),
        ("zstd.mcap", &["zstd"]),
        ("lz4.mcap", &["lz4"]),
        ("unchunked.mcap", &[]),
        ("bare.mcap", &["lz4"]),
        ("big_endian.mcap", &["zstd"]),
        ("ros1.mcap", &["lz4"]),
        ("mcap/mcap.mcap", &[]),
    ] {
        let (found, ending) = readings(&data(name));
        assert_eq!(ending.damage, [""; 0], "{name}");
        assert_eq!(found, expected(), "{name}");
        assert!(ending.compressions.iter().map(String::as_str).eq(compressions.iter().copied()), "{name}");
    }
}

/// Definitions in IDL are not read, but the common types are known.
#[test]
fn definitions_in_idl() {
    let (found, ending) = readings(&data("idl.mcap"));
    assert!(ending.is_whole(), "{ending:?}");
    assert_eq!(found, expected_of_known_types());
}
