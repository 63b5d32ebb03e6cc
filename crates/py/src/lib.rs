//! The Python package `soilctl`: bindings, one file a crate. There is no physics here, and nothing to use from Rust.
//!
//! Doc comments of classes and functions are what `help()` shows in Python.

mod array;
mod earth_pressure;
mod error;
mod kinematics;
mod work;

/// Everything compiled of the package `soilctl`.
#[pyo3::pymodule]
mod _native {
    #[pymodule_export]
    const MODELS: [&str; 8] = crate::earth_pressure::MODELS;
    #[pymodule_export]
    use crate::earth_pressure::{Prediction, failure_surface, predict, valid_range};
    #[pymodule_export]
    use crate::kinematics::Arm;
}
