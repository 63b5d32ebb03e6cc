//! Direct-shear tests of dry soils.
//!
//! The friction angle of a sand is not a constant: under the small stresses of a plate's stroke it is 5 to 9
//! degrees above that of an ordinary shear box. This crate
//!
//! - reads tables of friction angle against normal stress ([`read_shear_points`]),
//! - fits them by a power law ([`LogLogFit`]), a slope that ends on a floor ([`SlopeFloorFit`]) or a constant
//!   ([`ConstantFit`]) and says which one the tests support ([`compare_curves`]),
//! - finds the normal stress that a stroke of a plate corresponds to ([`StrokeLoad`]) and the friction angle
//!   there ([`friction_at_stroke`], [`consistent_friction_at_stroke`]),
//! - warns when an angle is carried to another stress ([`stress_shift`]),
//! - evaluates raw shear-box records ([`raw`]).
//!
//! Source: W. Hong, *Modeling, Estimation, and Control of Robot-Soil Interactions*, PhD thesis, MIT 2001, section
//! 6.6 and appendix D, whose table 6.13 is in `data/direct_shear.csv` of the project. Stresses are in Pa inside, and
//! every answer outside the tested stresses is marked as extrapolated.
//!
//! ```
//! use soilctl_direct_shear::{FrictionCurve, LogLogFit, parse_shear_points};
//! use soilctl_soil::units::psi_to_pa;
//!
//! let table = b"soil,normal_stress_psi,friction_angle_deg\n\
//!     ticino_loose,0.18,41.3\n\
//!     ticino_loose,0.36,39.3\n\
//!     ticino_loose,1.16,38.5\n\
//!     ticino_loose,2.33,35.3\n";
//! let series = parse_shear_points(table, "table 6.13")?;
//! let fit = LogLogFit::fit(&series[0].points)?;
//! assert!((fit.friction_at_1_psi_deg - 37.647).abs() < 1e-3);
//!
//! let stroke = fit.friction_at(psi_to_pa(0.062))?;
//! assert!((stroke.friction.degrees() - 43.7).abs() < 0.1);
//! assert!(stroke.extrapolated);
//! # Ok::<(), soilctl_direct_shear::DirectShearError>(())
//! ```

mod carry;
mod compare;
mod constant;
mod curve;
mod degrees;
mod equivalent;
mod error;
mod loglog;
mod misfit;
mod point;
pub mod raw;
mod slope_floor;
mod stroke_friction;
mod table;

pub use carry::{StressShift, stress_shift};
pub use compare::{CurveComparison, CurveScore, compare_curves};
pub use constant::ConstantFit;
pub use curve::{FrictionAt, FrictionCurve};
pub use equivalent::{EquivalentStress, PointDepth, StrokeLoad};
pub use error::DirectShearError;
pub use loglog::LogLogFit;
pub use misfit::Misfit;
pub use point::{ShearPoint, ShearSeries, parse_shear_points, read_shear_points};
pub use slope_floor::{SlopeFloorFit, low_load_weights};
pub use stroke_friction::{StrokeFriction, consistent_friction_at_stroke, friction_at_stroke};
