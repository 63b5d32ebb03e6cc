#![doc = include_str!("../README.md")]

mod csv;
mod draw;
mod error;
mod escape;
mod extent;
mod interactive;
mod model;
mod output;
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
