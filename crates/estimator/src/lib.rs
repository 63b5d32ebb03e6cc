#![doc = include_str!("../README.md")]

mod constraint;
mod convex;
mod cover;
mod ellipse;
mod end_factor;
mod error;
mod estimate;
mod exact;
mod joint;
mod law;
mod misfit;
mod next_stroke;
mod observation;
mod optimise;
mod piece;
mod region;
mod setup;
mod sliced;
mod stress_level;
mod verdict;

pub use ellipse::Ellipse;
pub use error::EstimatorError;
pub use estimate::{Estimate, Limits, Projections, Slice, bands, estimate, projections, section};
pub use exact::{ExactSection, exact_estimate, exact_section};
pub use joint::{Adhesion, Joint, Quantity, Unknowns};
pub use law::{FrictionLaw, MAX_SLOPE_DEG, REFERENCE_STRESS_PA, ShearBand};
pub use misfit::{Fit, best_fit};
pub use next_stroke::{Candidate, StrokeMenu, next_strokes};
pub use observation::Observation;
pub use optimise::{LocalMinimum, Optimiser, local_minima, spread_starts};
pub use region::{Region, Ring};
pub use setup::{DENSITY_SEARCH_KG_M3, MAX_OBSERVATIONS, PHI_SEARCH_DEG, Setup};
pub use sliced::shear_alone;
pub use stress_level::slip_stress_pa;
pub use verdict::{Conflict, agreement_factor, conflict};
