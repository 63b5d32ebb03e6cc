use serde::Serialize;

use super::DataPoint;

/// Many polylines that share a name, a colour and a width, such as the edges of a mesh or the arrows of a velocity field.
/// All are unbroken.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Paths {
    /// Name in the legend and the hover text; an empty name has no legend entry.
    pub name: String,
    /// The polylines, of at least two points each.
    pub parts: Vec<Vec<DataPoint>>,
    /// Whether each ends in an arrow head. Heads are as long as a part of the last step, in data units, so they look right
    /// with equal aspect only.
    pub arrows: bool,
    /// Width in px, 0.2 to 12.
    pub width: f64,
    /// Palette index; `None` is a neutral grey.
    pub color: Option<usize>,
}

impl Paths {
    /// Grey lines of 1 px.
    pub fn new(name: impl Into<String>, parts: impl Into<Vec<Vec<DataPoint>>>) -> Self {
        Self { name: name.into(), parts: parts.into(), arrows: false, width: 1.0, color: None }
    }

    /// Puts an arrow head at each end.
    #[must_use]
    pub fn arrows(mut self) -> Self {
        self.arrows = true;
        self
    }

    /// Sets the width in px.
    #[must_use]
    pub fn width(mut self, width: f64) -> Self {
        self.width = width;
        self
    }

    /// The corners of a part's arrow head: left, tip, right; none without arrows or without a last step.
    pub(crate) fn head(&self, part: &[DataPoint]) -> Option<[DataPoint; 3]> {
        /// Length and half width of a head over that of the last step.
        const LENGTH: f64 = 0.3;
        const HALF_WIDTH: f64 = 0.09;
        let [.., (x0, y0), (x1, y1)] = *part else { return None };
        let (dx, dy) = (x1 - x0, y1 - y0);
        (self.arrows && (dx != 0.0 || dy != 0.0)).then(|| {
            let (x, y) = (x1 - LENGTH * dx, y1 - LENGTH * dy);
            let (wx, wy) = (HALF_WIDTH * -dy, HALF_WIDTH * dx);
            [(x + wx, y + wy), (x1, y1), (x - wx, y - wy)]
        })
    }
}
