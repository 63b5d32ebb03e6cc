#![doc = include_str!("../README.md")]

mod bench;
mod checker;
mod error;
mod feed;
mod file;
mod messages;
mod page;
mod run;
mod shown;
mod templates;

pub use bench::{Settings, Workbench};
pub use error::WorkbenchError;
pub use soilctl_web::Counts;
