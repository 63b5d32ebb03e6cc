//! A robot, whatever its URDF says, with a recording that is whole.
#![no_main]

mod common;

use std::path::Path;

use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    let recording = concat!(env!("CARGO_MANIFEST_DIR"), "/../crates/bag/tests/data/none.mcap");
    common::read(Path::new(recording), text);
});
