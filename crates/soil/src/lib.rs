//! The vocabulary that every soilctl crate speaks.
//!
//! Numbers are SI `f64` with the unit in the name (`depth_m`); angles are [`Angle`], radians inside and degrees
//! at the edge. Two quantities that are easily mixed up have types of their own: the earth-pressure
//! coefficient normalised by the plate's slant length ([`SlantCoefficient`]) and by its vertical depth
//! ([`DepthCoefficient`]).
//!
//! Notation, the same everywhere:
//!
//! | symbol | name | meaning |
//! |---|---|---|
//! | alpha | tool angle | plate from the horizontal; below 90 degrees the lower edge is ahead of the upper one |
//! | beta | surface slope | ground surface from the horizontal, positive when it rises ahead of the plate |
//! | phi | friction angle | internal friction of the soil |
//! | delta | interface friction | friction between soil and plate |
//! | H | depth | vertical depth of the lower edge below the surface |
//! | L | slant length | wetted length of the plate, `H / sin(alpha)` |
//! | F | force | in-plane resultant on the plate, inclined at delta to its normal, passive minus active |
//!
//! ```
//! use soilctl_soil::{Angle, DepthCoefficient, Plate};
//!
//! let plate = Plate::new(Angle::from_degrees(80.0), Angle::ZERO, 0.0254, 0.127)?;
//! let k = DepthCoefficient(4.0).to_slant(plate.tool_angle());
//! assert!((k.0 - 4.0 * 80f64.to_radians().sin().powi(2)).abs() < 1e-12);
//! # Ok::<(), soilctl_soil::SoilError>(())
//! ```

mod angle;
mod bracket;
mod coefficient;
mod error;
mod interface;
mod plate;
mod rounded;
mod soil;
pub mod units;
mod width_ratio;

pub use angle::Angle;
pub use bracket::{Bracket, Provenance};
pub use coefficient::{DepthCoefficient, SlantCoefficient};
pub use error::SoilError;
pub use interface::Interface;
pub use plate::{MAX_ANGLE_SUM_DEG, Plate, Stroke};
pub use rounded::Rounded;
pub use soil::{STANDARD_GRAVITY_M_S2, Soil};
pub use width_ratio::WidthRatio;
