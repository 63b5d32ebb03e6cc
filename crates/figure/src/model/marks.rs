//! Layers at single places: points, reference lines and texts.

use serde::Serialize;

use super::{DataPoint, Orientation};
use crate::palette::{Dash, Marker};

/// Single points, with optional error bars and hover texts.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Points {
    /// Name in the legend and the hover text; an empty name has no legend entry.
    pub name: String,
    /// The points.
    pub points: Vec<DataPoint>,
    /// Lengths of the error bars `(below, above)` each point, both at least 0.
    pub y_error: Option<Vec<(f64, f64)>>,
    /// Shape; `None` takes the shape that goes with the colour.
    pub marker: Option<Marker>,
    /// A text per point, shown under the pointer.
    pub labels: Option<Vec<String>>,
    /// Palette index; `None` takes the next one when pushed to a figure.
    pub color: Option<usize>,
}

impl Points {
    /// Points with the next free colour and its marker.
    pub fn new(name: impl Into<String>, points: impl Into<Vec<DataPoint>>) -> Self {
        Self {
            name: name.into(),
            points: points.into(),
            y_error: None,
            marker: None,
            labels: None,
            color: None,
        }
    }

    /// Sets the lengths of the error bars `(below, above)` each point.
    #[must_use]
    pub fn y_error(mut self, lengths: impl Into<Vec<(f64, f64)>>) -> Self {
        self.y_error = Some(lengths.into());
        self
    }

    /// Sets the marker shape.
    #[must_use]
    pub fn marker(mut self, marker: Marker) -> Self {
        self.marker = Some(marker);
        self
    }

    /// Sets the hover texts, one per point.
    #[must_use]
    pub fn labels<S: Into<String>>(mut self, labels: impl IntoIterator<Item = S>) -> Self {
        self.labels = Some(labels.into_iter().map(Into::into).collect());
        self
    }

    /// The ends of the error bars in data coordinates, one pair per point.
    pub(crate) fn bars(&self) -> Option<Vec<(f64, f64)>> {
        let lengths = self.y_error.as_ref()?;
        Some(self.points.iter().zip(lengths).map(|(p, (down, up))| (p.1 - down, p.1 + up)).collect())
    }
}

/// A straight line over the whole figure.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RefLine {
    /// Name in the legend; an empty name has no legend entry.
    pub name: String,
    /// Direction of the line.
    pub orientation: Orientation,
    /// Where the line crosses the other axis.
    pub at: f64,
    /// Dash pattern.
    pub dash: Dash,
    /// Palette index; `None` is a neutral grey.
    pub color: Option<usize>,
}

impl RefLine {
    /// A horizontal line at a y value.
    pub fn horizontal(name: impl Into<String>, at: f64) -> Self {
        Self::new(name.into(), Orientation::Horizontal, at)
    }

    /// A vertical line at an x value.
    pub fn vertical(name: impl Into<String>, at: f64) -> Self {
        Self::new(name.into(), Orientation::Vertical, at)
    }

    fn new(name: String, orientation: Orientation, at: f64) -> Self {
        Self { name, orientation, at, dash: Dash::Dash, color: None }
    }

    /// Sets the dash pattern.
    #[must_use]
    pub fn dash(mut self, dash: Dash) -> Self {
        self.dash = dash;
        self
    }
}

/// Where a text sits relative to its data point.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum TextPlace {
    /// Centred above the point.
    Above,
    /// Centred below the point.
    Below,
    /// Ending left of the point.
    Left,
    /// Starting right of the point.
    Right,
    /// Centred on the point.
    Center,
}

/// A text at a data point.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Text {
    /// The data point.
    pub at: DataPoint,
    /// The text, on one line.
    pub text: String,
    /// Where the text sits relative to the point.
    pub place: TextPlace,
    /// Palette index; `None` is the ink colour of the axes.
    pub color: Option<usize>,
}

impl Text {
    /// A text above the data point `at`.
    pub fn new(text: impl Into<String>, at: DataPoint) -> Self {
        Self { at, text: text.into(), place: TextPlace::Above, color: None }
    }

    /// Sets the place relative to the point.
    #[must_use]
    pub fn place(mut self, place: TextPlace) -> Self {
        self.place = place;
        self
    }
}
