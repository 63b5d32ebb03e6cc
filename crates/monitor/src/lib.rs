#![doc = include_str!("../README.md")]

mod arm;
mod error;
mod feed;
mod film;
mod live;
mod meshes;
mod messages;
mod monitor;
mod scene;
mod soil;
mod web;

pub use error::MonitorError;
pub use monitor::{Counts, Monitor, Settings, Source};
pub use soilctl_motion::Settings as BagSettings;
