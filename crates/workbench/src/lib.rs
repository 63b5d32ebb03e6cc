#![doc = include_str!("../README.md")]

mod answers;
mod desk;
mod messages;
mod plate;
mod probe;
mod shown;
mod strokes;
mod templates;
mod watched;

// What serves: connections, threads and a file.
#[cfg(not(target_family = "wasm"))]
mod bench;
#[cfg(not(target_family = "wasm"))]
mod error;
#[cfg(not(target_family = "wasm"))]
mod feed;
#[cfg(not(target_family = "wasm"))]
mod file;
#[cfg(not(target_family = "wasm"))]
mod latest;
#[cfg(not(target_family = "wasm"))]
mod page;
#[cfg(not(target_family = "wasm"))]
mod run;

#[cfg(not(target_family = "wasm"))]
pub use bench::{Settings, Workbench};
pub use desk::Desk;
#[cfg(not(target_family = "wasm"))]
pub use error::WorkbenchError;
#[cfg(not(target_family = "wasm"))]
pub use soilctl_web::Counts;
