//! The Python package `soilctl`: bindings, one file a crate. There is no physics here, and nothing to use from Rust.
//!
//! Doc comments of classes and functions are what `help()` shows in Python.

mod array;
mod bracket;
mod certificate;
mod cli;
mod copies;
mod earth_pressure;
mod error;
mod estimator;
mod interruptible;
mod jobs;
mod kinematics;
mod limit_analysis;
mod plant;
mod progress;
mod region;
mod session;
mod use_cases;
mod watched;
mod work;

/// Everything compiled of the package `soilctl`.
#[pyo3::pymodule]
mod _native {
    #[pymodule_export]
    const MODELS: [&str; crate::earth_pressure::MODELS.len()] = crate::earth_pressure::MODELS;
    #[pymodule_export]
    const VERSION: &str = env!("CARGO_PKG_VERSION");
    #[pymodule_export]
    use crate::bracket::{Bracket, Progress, restore_bracket};
    #[pymodule_export]
    use crate::certificate::{Certificate, Solution, restore_certificate, restore_solution};
    #[pymodule_export]
    use crate::cli::{answer_command, run_command};
    #[pymodule_export]
    use crate::earth_pressure::{Prediction, failure_surface, predict, restore_prediction, valid_range};
    #[pymodule_export]
    use crate::estimator::{Estimate, estimate};
    #[pymodule_export]
    use crate::jobs::{store_has, store_key, store_note_failure, store_paths, store_publish, store_read};
    #[pymodule_export]
    use crate::kinematics::{Arm, restore_arm};
    #[pymodule_export]
    use crate::limit_analysis::{bound, solve};
    #[pymodule_export]
    use crate::plant::{Plant, Sensed, restore_sensed, soil_names};
    #[pymodule_export]
    use crate::session::{log_info, log_recover, log_table};
    #[pymodule_export]
    use crate::use_cases::{run_use_case, use_case_schemas};
}
