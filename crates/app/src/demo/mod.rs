//! A simulated campaign from the soil to the estimate, compared with the truth.

mod answer;
mod compare;
mod delta;
mod estimates;
mod folder;
mod found;
mod recovered;
mod region;
mod request;
mod steps;

pub use answer::{Answer, Delta, EachStroke, Files, Forces, Region, StrokeCount, TRUE_FORCES, Truth};
pub use estimates::Estimated;
pub use request::Request;
pub use steps::{Demonstration, Work, run};
