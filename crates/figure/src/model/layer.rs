//! The sum of all layer kinds and what they have in common.

use serde::Serialize;

use super::{Band, Line, Paths, Points, Polygons, RefLine, Shades, Span, Text};

/// Direction of a span or a reference line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Orientation {
    /// Runs from left to right, at y values.
    Horizontal,
    /// Runs from bottom to top, at x values.
    Vertical,
}

/// One layer of a figure.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Layer {
    /// A polyline.
    Line(Line),
    /// An area between two curves.
    Band(Band),
    /// A set of polygons.
    Polygons(Polygons),
    /// Single points.
    Points(Points),
    /// Many polylines of one style, or arrows.
    Paths(Paths),
    /// Polygons coloured by a value.
    Shades(Shades),
    /// A strip over the whole figure.
    Span(Span),
    /// A straight line over the whole figure.
    RefLine(RefLine),
    /// A text at a data point.
    Text(Text),
}

impl Layer {
    /// Name of the layer; a text is its own name.
    pub fn name(&self) -> &str {
        match self {
            Self::Line(l) => &l.name,
            Self::Band(l) => &l.name,
            Self::Polygons(l) => &l.name,
            Self::Points(l) => &l.name,
            Self::Paths(l) => &l.name,
            Self::Shades(l) => &l.name,
            Self::Span(l) => &l.name,
            Self::RefLine(l) => &l.name,
            Self::Text(l) => &l.text,
        }
    }

    /// Kind of the layer as written to CSV files.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Line(_) => "line",
            Self::Band(_) => "band",
            Self::Polygons(_) => "polygons",
            Self::Points(_) => "points",
            Self::Paths(_) => "paths",
            Self::Shades(_) => "shades",
            Self::Span(s) if s.orientation == Orientation::Horizontal => "hspan",
            Self::Span(_) => "vspan",
            Self::RefLine(r) if r.orientation == Orientation::Horizontal => "hline",
            Self::RefLine(_) => "vline",
            Self::Text(_) => "text",
        }
    }

    /// Whether the legend lists the layer.
    pub(crate) fn in_legend(&self) -> bool {
        !matches!(self, Self::Text(_) | Self::Shades(_)) && !self.name().is_empty()
    }

    /// The colour slot, for the kinds that take the next palette index by default.
    pub(crate) fn series_color(&mut self) -> Option<&mut Option<usize>> {
        match self {
            Self::Line(l) => Some(&mut l.color),
            Self::Band(l) => Some(&mut l.color),
            Self::Polygons(l) => Some(&mut l.color),
            Self::Points(l) => Some(&mut l.color),
            Self::Paths(_) | Self::Shades(_) | Self::Span(_) | Self::RefLine(_) | Self::Text(_) => None,
        }
    }
}

macro_rules! into_layer {
    ($($kind:ident),*) => {$(
        impl From<$kind> for Layer {
            fn from(layer: $kind) -> Self {
                Self::$kind(layer)
            }
        }
    )*};
}
into_layer!(Line, Band, Polygons, Points, Paths, Shades, Span, RefLine, Text);

macro_rules! with_color {
    ($($kind:ident),*) => {$(
        impl $kind {
            /// Sets the palette index; equal indices have equal colours, dashes, markers and hatches.
            #[must_use]
            pub fn color(mut self, index: usize) -> Self {
                self.color = Some(index);
                self
            }
        }
    )*};
}
with_color!(Line, Band, Polygons, Points, Paths, Span, RefLine, Text);
