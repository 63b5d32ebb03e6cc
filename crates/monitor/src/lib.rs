#![doc = include_str!("../README.md")]

mod error;
mod feed;
mod live;
mod log;
mod messages;
mod monitor;
mod scene;
mod soil;
mod web;

pub use error::MonitorError;
pub use monitor::{Counts, Monitor, Settings, Source};
