//! The backend-neutral description of a figure.

mod areas;
mod axis;
mod check;
mod curves;
mod figure;
mod layer;
mod marks;
mod motion;
mod outline;
mod paths;
mod shades;
mod size;

pub use areas::{Polygon, Polygons, Span};
pub(crate) use axis::narrowest;
pub use axis::{Axis, Scale};
pub use curves::{Band, Line};
pub use figure::{Figure, Legend};
pub use layer::{Layer, Orientation};
pub use marks::{Points, RefLine, Text, TextPlace};
pub use motion::{Motion, MovingPoint};
pub use paths::Paths;
pub(crate) use shades::STEPS;
pub use shades::{Shade, Shades};
pub use size::Size;

/// A point in data coordinates, `(x, y)`.
pub type DataPoint = (f64, f64);
