//! Figures and HTML pages of the answers of `soilctl-app`.
//!
//! A module a use case. Figures are descriptions ([`soilctl_figure::Figure`]) that can be written as SVG, PNG or CSV; pages hold
//! figures, tables and sentences and need no network.

#[cfg(not(target_family = "wasm"))]
pub mod ahead;
#[cfg(not(target_family = "wasm"))]
pub mod arm;
pub mod bound;
pub mod certify;
#[cfg(not(target_family = "wasm"))]
pub mod demo;
#[cfg(not(target_family = "wasm"))]
pub mod diagnose;
mod error;
pub mod estimate;
#[cfg(not(target_family = "wasm"))]
pub mod excavate;
#[cfg(not(target_family = "wasm"))]
pub mod heights;
pub mod limits;
pub mod obstacle;
#[cfg(not(target_family = "wasm"))]
pub mod places;
pub mod predict;
mod problem;
#[cfg(not(target_family = "wasm"))]
pub mod process;
#[cfg(not(target_family = "wasm"))]
pub mod profile;
#[cfg(not(target_family = "wasm"))]
pub mod report;
pub mod shear;
pub mod solve;
#[cfg(not(target_family = "wasm"))]
pub mod surface;
pub mod tool;
mod write;

pub use error::PageError;
pub use write::{save_figure, write};
