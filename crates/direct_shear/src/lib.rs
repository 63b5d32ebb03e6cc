#![doc = include_str!("../README.md")]

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
