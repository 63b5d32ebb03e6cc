//! Programs with second-order and semidefinite cones, stated as lists of affine forms in cones, and the one place that names Clarabel.
//!
//! A crate of its own because what Clarabel and faer are made of is compiled where it is first used with numbers: here, beside
//! everything else that is compiled, and not once more for each change of what states programs.

mod error;
mod form;
mod program;
#[cfg(all(target_os = "linux", target_pointer_width = "64"))]
mod small_blas;
#[cfg_attr(
    not(all(target_os = "linux", target_pointer_width = "64")),
    allow(dead_code, reason = "most of it is for `small_blas`")
)]
mod small_dense;
mod solver;

pub use error::ConicError;
pub use form::Form;
pub use program::{Cone, Program};
pub use solver::{Accuracy, Answer, Factorisation, How, SOLVER, Status, solve};
