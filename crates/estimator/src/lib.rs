//! From measured failure forces to every soil that could have produced them.
//!
//! Each measurement, with its uncertainty, allows a band of (friction angle, density) for every interface friction
//! (Hong 2001, chapter 7). The intersection of all bands holds the true soil as long as the uncertainties do.
//! Density enters the force linearly, so a force interval at given phi and delta is a density interval, and the
//! consistent set is everything between the greatest lower and the least upper density.
//!
//! ```
//! use soilctl_earth_pressure::model;
//! use soilctl_estimator::{Observation, Setup, estimate};
//! use soilctl_soil::{Angle, Plate};
//!
//! let chen = model("chen")?;
//! let mut observations = Vec::new();
//! for (alpha_deg, force_n) in [(70.0, 3.78), (80.0, 5.74), (90.0, 8.94), (100.0, 13.1)] {
//!     let alpha = Angle::from_degrees(alpha_deg);
//!     let plate = Plate::new(alpha, Angle::ZERO, 0.0254 * alpha.sin(), 0.127)?;
//!     observations.push(Observation::new(format!("{alpha_deg} deg"), plate, force_n, 0.08 * force_n)?);
//! }
//! let found = estimate(&Setup::new(&*chen, observations, (22.0, 24.0)).with_density(1536.0, 1664.0))?;
//! let [low, high] = found.phi_deg.ok_or("no soil is consistent")?;
//! assert!(low > 39.0 && high < 45.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod constraint;
mod convex;
mod cover;
mod ellipse;
mod error;
mod estimate;
mod exact;
mod misfit;
mod next_stroke;
mod observation;
mod optimise;
mod piece;
mod region;
mod setup;
mod verdict;

pub use ellipse::Ellipse;
pub use error::EstimatorError;
pub use estimate::{Estimate, Limits, Projections, bands, estimate, projections, section};
pub use exact::{ExactSection, exact_estimate, exact_section};
pub use misfit::{Fit, best_fit};
pub use next_stroke::{Candidate, StrokeMenu, next_strokes};
pub use observation::Observation;
pub use optimise::{LocalMinimum, Optimiser, local_minima, spread_starts};
pub use region::{Region, Ring};
pub use setup::{DENSITY_SEARCH_KG_M3, MAX_OBSERVATIONS, PHI_SEARCH_DEG, Setup};
pub use verdict::{Conflict, agreement_factor, conflict};
