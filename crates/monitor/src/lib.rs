#![doc = include_str!("../README.md")]

mod error;
mod feed;
mod film;
mod live;
mod messages;
mod monitor;
mod scene;
mod soil;
mod web;

pub use error::MonitorError;
pub use film::BagSettings;
pub use monitor::{Counts, Monitor, Settings, Source};
