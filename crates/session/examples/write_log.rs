//! Writes a log of some strokes of a simple simulated arm: `cargo run -p soilctl-session --example write_log -- PATH
//! [TICKS]`. It shows how a program of one's own hands its steps to the logger, and makes files to try other tools on.
#![allow(clippy::unwrap_used, clippy::expect_used, reason = "an example")]

#[path = "../tests/common/mod.rs"]
mod common;

fn main() {
    let mut args = std::env::args().skip(1);
    let path = args.next().expect("the path of the log to write");
    let ticks = args.next().map_or(common::STROKE_TICKS, |text| text.parse().expect("a number of ticks"));
    common::write_log(path.as_ref(), 1, ticks);
}
