#![doc = include_str!("../README.md")]

mod container;
mod contents;
mod damage;
mod db3;
pub mod definition;
mod error;
mod folder;
mod packed;
mod rate;
mod reader;
mod ros1;
mod scan;

pub use container::{Container, is_recording, kind};
pub use contents::{Contents, Topic, contents, contents_until};
pub use error::BagError;
pub use rate::{Clock, Gap, Rate, Rates, Stamps};
pub use reader::{Kind, Reader, Readers, Reading};
pub use scan::{Early, scan, scan_until};
pub use soilctl_session::read::{Channel, Ending, Item, RawMessage};
