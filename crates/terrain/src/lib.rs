#![doc = include_str!("../README.md")]

mod error;
mod field;
mod overlap;
mod push;
mod settle;

pub use error::TerrainError;
pub use field::{HeightField, MOST_CELLS};
pub use push::Sweep;
pub use settle::{Repose, Settled};
