//! Bags of any program, for the monitor.

mod contents;
mod reader;

pub use self::contents::BagContents;

pub use self::reader::{BagMessage, BagReader, JOINT_STATE, WRENCH};

fn listed<T: AsRef<str>>(names: impl Iterator<Item = T>) -> String {
    let names: Vec<String> = names.map(|name| name.as_ref().to_owned()).collect();
    if names.is_empty() { "none".into() } else { names.join(", ") }
}
