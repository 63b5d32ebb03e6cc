//! Ground that changes with depth: what strokes at several depths leave of its friction angle and density, for each way in which it may change.

mod coefficients;
mod densities;
mod forward;
mod search;

pub use coefficients::Coefficients;
pub use forward::{Ground, Layering, STEEPEST_DEG, Shape, Stroke, TOWARDS_TOP, WHERE_IT_CHANGES};
pub use search::{Asked, Explains, Found, LOG_FORCE, Search};
