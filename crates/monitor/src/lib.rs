#![doc = include_str!("../README.md")]

mod arm;
mod dig;
mod error;
mod feed;
mod film;
mod live;
mod meshes;
mod messages;
mod monitor;
mod page;
mod scene;
mod site;
mod soil;

pub use dig::{Dig, DigSettings, DugSession};
pub use error::MonitorError;
pub use monitor::{Monitor, Settings, Source};
pub use soilctl_motion::Settings as BagSettings;
pub use soilctl_web::Counts;
