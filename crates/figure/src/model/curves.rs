//! Layers that run along the x axis: lines and bands.

use serde::Serialize;

use super::DataPoint;
use crate::palette::Dash;

/// A polyline through points, in the order given.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Line {
    /// Name in the legend and the hover text; an empty name has no legend entry.
    pub name: String,
    /// The points.
    pub points: Vec<DataPoint>,
    /// Dash pattern; `None` takes the pattern that goes with the colour.
    pub dash: Option<Dash>,
    /// Width in px, 0.5 to 12.
    pub width: f64,
    /// Palette index; `None` takes the next one when pushed to a figure.
    pub color: Option<usize>,
}

impl Line {
    /// A line of 2 px with the next free colour and its dash pattern.
    pub fn new(name: impl Into<String>, points: impl Into<Vec<DataPoint>>) -> Self {
        Self { name: name.into(), points: points.into(), dash: None, width: 2.0, color: None }
    }

    /// Sets the dash pattern.
    #[must_use]
    pub fn dash(mut self, dash: Dash) -> Self {
        self.dash = Some(dash);
        self
    }

    /// Sets the width in px.
    #[must_use]
    pub fn width(mut self, width: f64) -> Self {
        self.width = width;
        self
    }
}

/// The area between two curves over the same x values.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Band {
    /// Name in the legend and the hover text; an empty name has no legend entry.
    pub name: String,
    /// Common x values.
    pub x: Vec<f64>,
    /// Lower curve.
    pub low: Vec<f64>,
    /// Upper curve.
    pub high: Vec<f64>,
    /// Palette index; `None` takes the next one when pushed to a figure.
    pub color: Option<usize>,
}

impl Band {
    /// A band between `low` and `high` over `x`.
    pub fn new(
        name: impl Into<String>,
        x: impl Into<Vec<f64>>,
        low: impl Into<Vec<f64>>,
        high: impl Into<Vec<f64>>,
    ) -> Self {
        Self { name: name.into(), x: x.into(), low: low.into(), high: high.into(), color: None }
    }

    /// The closed outline: along the upper curve and back along the lower one.
    pub(crate) fn outline(&self) -> Vec<DataPoint> {
        let upper = self.x.iter().zip(&self.high);
        let lower = self.x.iter().zip(&self.low).rev();
        upper.chain(lower).map(|(&x, &y)| (x, y)).collect()
    }
}
