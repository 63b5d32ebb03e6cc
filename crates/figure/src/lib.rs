//! Scientific figures that are defined once and rendered everywhere.
//!
//! A [`Figure`] holds two axes and layers of data: lines, bands, polygons, points with error bars, many lines or arrows at
//! once, maps of a value, spans, reference lines and texts. It renders to SVG and PNG (with an embedded font, so results
//! do not depend on the machine), to interactive HTML inside of an [`HtmlReport`], and to CSV.
//! Layers are checked when they are added: values that cannot be drawn are refused with a
//! [`FigureError`] that says what to do, and rendering a figure that was accepted does not panic.
//!
//! Colours are distinct under the common colour vision deficiencies, and dashes, markers and
//! outlines keep layers apart without colour. Equal input gives equal output, byte by byte.
//!
//! ```
//! use soilctl_figure::{Axis, Figure, Line, Points, Size, Span};
//!
//! # fn main() -> Result<(), soilctl_figure::FigureError> {
//! let mut figure = Figure::new(
//!     "Mobilised strength",
//!     Axis::linear("Shear displacement (mm)"),
//!     Axis::linear("Shear stress (kPa)"),
//! );
//! figure
//!     .push(Span::horizontal("peak ± 4 %", 58.8, 63.6))?
//!     .push(Line::new("simulated", [(0.0, 0.0), (1.0, 48.0), (2.5, 61.0), (6.0, 52.0)]))?
//!     .push(Points::new("measured", [(1.0, 45.0), (2.5, 61.2), (6.0, 50.5)]))?;
//!
//! let svg = figure.to_svg(Size::default())?;
//! assert!(svg.starts_with("<svg"));
//! assert!(figure.to_csv().contains("2,line,simulated,,,1.0,48.0"));
//! assert!(figure.push(Line::new("broken", [(0.0, f64::NAN)])).is_err());
//! # Ok(()) }
//! ```

mod csv;
mod draw;
mod error;
mod escape;
mod extent;
mod interactive;
mod model;
mod palette;
mod report;

pub use draw::FigureGrid;
pub use error::FigureError;
pub use model::{
    Axis, Band, DataPoint, Figure, Layer, Legend, Line, Motion, MovingPoint, Orientation, Paths, Points,
    Polygon, Polygons, RefLine, Scale, Shade, Shades, Size, Span, Text, TextPlace,
};
pub use palette::{Dash, Marker};
pub use report::{Align, CalloutKind, HtmlReport, RichText, Shown, Table};
