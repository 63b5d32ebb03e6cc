//! A figure with every kind of layer and hostile names.
#![allow(dead_code)]

use soilctl_figure::{
    Axis, Band, Figure, FigureError, Line, Paths, Points, Polygon, Polygons, RefLine, Shade, Shades, Span,
    Text,
};

/// Text that breaks out of careless documents.
pub(crate) const HOSTILE: &str = "<script>alert('1')</script> & \"q\" %{x} \u{0}";

/// One layer of each kind.
pub(crate) fn everything() -> Result<Figure, FigureError> {
    let mut figure = Figure::new(HOSTILE, Axis::linear("x (mm)"), Axis::linear(HOSTILE));
    let square = |low: f64, high: f64| vec![(low, low), (high, low), (high, high), (low, high)];
    figure
        .push(Span::horizontal("hspan", 1.0, 2.0))?
        .push(Span::vertical("vspan", 3.0, 4.0))?
        .push(Line::new(HOSTILE, [(0.0, 0.1), (1.0, 2.5), (2.0, 1.0 / 3.0)]))?
        .push(Band::new("band, \"quoted\"", [0.0, 5.0], [0.0, 1.0], [2.0, 3.0]))?
        .push(Polygons::new("area", [Polygon::new(square(0.0, 4.0)).hole(square(1.0, 2.0))]))?
        .push(
            Points::new("pts", [(1.0, 1.0), (2.0, 1e-7)])
                .y_error([(0.5, 0.25), (0.0, 1.0)])
                .labels(["a", HOSTILE]),
        )?
        .push(
            Paths::new(HOSTILE, [vec![(0.0, 0.0), (1.0, 2.0)], vec![(2.0, 2.0), (2.0, 3.0), (3.0, 3.0)]])
                .arrows(),
        )?
        .push(Shades::new(HOSTILE, [Shade { ring: square(0.5, 1.5), value: 0.7 }], 0.0, 1.0))?
        .push(RefLine::horizontal("hline", 2.0))?
        .push(RefLine::vertical("vline", 4.5))?
        .push(Text::new(HOSTILE, (2.0, 2.0)))?;
    Ok(figure)
}
