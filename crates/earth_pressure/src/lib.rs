//! Force models for a flat plate that fails soil, behind one trait.
//!
//! | id | model | kind |
//! |---|---|---|
//! | `coulomb` | Coulomb's plane wedge, [`Coulomb`] | limit equilibrium, closed form |
//! | `log-spiral` | Ohde's spiral, [`LogSpiral::CORRECT`] | limit equilibrium, one search |
//! | `log-spiral-thesis` | the same with two quirks of a printed table, [`LogSpiral::THESIS`] | for reproduction only |
//! | `caquot` | Caquot & Kerisel, [`Caquot`] | table |
//! | `chen` | Chen & Liu, [`ChenLiu`] | kinematic upper bound, one search |
//! | `thesis-ub`, `thesis-lb` | numerical limit analysis of Hong (2001), [`table::TableModel`] | tables of bounds |
//! | `table` | certified lower and upper bounds of our own, [`plate_bounds()`] | tables of bounds, as a bracket |
//!
//! Coefficients are slant-normalised (see [`soilctl_soil`]); forces are passive minus active.
//!
//! ```
//! use soilctl_earth_pressure::{Case, model};
//!
//! let chen = model("chen")?;
//! let prediction = chen.predict(&Case::level_deg(80.0, 40.0, 25.0))?;
//! assert!((prediction.k_net().0 - 8.055).abs() < 0.001);
//! # Ok::<(), soilctl_earth_pressure::EarthPressureError>(())
//! ```

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
