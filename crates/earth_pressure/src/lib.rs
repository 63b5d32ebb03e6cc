#![doc = include_str!("../README.md")]

mod caquot;
mod case;
mod chen_liu;
mod coulomb;
mod error;
mod log_spiral;
mod minimise;
mod model;
mod plate_bounds;
mod sensitivity;
pub mod table;
pub mod thesis;
mod turn;

pub use caquot::Caquot;
pub use case::{Case, LoadFactors, Loads, Prediction};
pub use chen_liu::ChenLiu;
pub use coulomb::Coulomb;
pub use error::EarthPressureError;
pub use log_spiral::LogSpiral;
pub use model::{
    FailureSurface, ForceModel, MODEL_IDS, ModelSlice, NetFactors, ValidRange, check_loads, failure_force_n,
    model,
};
pub use plate_bounds::plate_bounds;
pub use sensitivity::{Input, sensitivity_percent};

#[cfg(test)]
pub(crate) mod test_support {
    /// Relative difference.
    pub(crate) fn rel(a: f64, b: f64) -> f64 {
        (a - b).abs() / b.abs()
    }
}
