#![doc = include_str!("../README.md")]

pub mod definition;
mod error;
mod reader;
mod scan;

pub use error::BagError;
pub use reader::{Kind, Reader, Readers, Reading};
pub use scan::{Early, scan, scan_until};
pub use soilctl_session::read::{Channel, Ending, Item, RawMessage};
