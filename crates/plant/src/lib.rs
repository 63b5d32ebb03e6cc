#![doc = include_str!("../README.md")]

mod bodies;
pub mod config;
mod drives;
mod effects;
mod error;
mod force_sensor;
mod ground;
mod hardware;
mod noise;
mod params;
mod plant;
mod rules;
mod sensors;
mod simulation;
mod truth;
mod validate;

pub use effects::{Contact, Effects, SoilChange};
pub use error::PlantError;
pub use ground::{BuriedBlock, FrictionLaw, Ground, SoilPreset, block_gap_m, presets};
pub use hardware::{Drive, Hardware};
pub use params::PlantParams;
pub use plant::Plant;
pub use simulation::{Simulation, Tick};
pub use truth::{SoilTruth, Truth};
