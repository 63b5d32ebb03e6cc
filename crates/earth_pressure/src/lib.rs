#![doc = include_str!("../README.md")]

mod case;
mod error;
mod minimise;
mod model;
mod models;
mod sensitivity;
mod slip_stress;
pub mod table;
mod turn;

pub use case::{Case, LoadFactors, Loads, Prediction};
pub use error::EarthPressureError;
pub use model::{
    FailureSurface, ForceModel, ModelSlice, NetFactors, ValidRange, check_loads, failure_force_n,
};
pub use models::{
    Blocks, Caquot, ChenLiu, Coulomb, EndLaw, GodwinSpoor, InPlaneStrain, LogSpiral, MODEL_IDS, McKyesAli,
    Ovesen, Perumpral, model, plane_model, plate_bounds, thesis,
};
pub use sensitivity::{Input, sensitivity_percent};
pub use slip_stress::{EQUIVALENT_OVER_MEAN, mean_slip_stress_over_pressure};

#[cfg(test)]
pub(crate) mod test_support {
    /// Relative difference.
    pub(crate) fn rel(a: f64, b: f64) -> f64 {
        (a - b).abs() / b.abs()
    }
}
