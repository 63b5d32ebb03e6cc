//! Layers that cover areas: polygons and spans over a whole axis.

use serde::Serialize;

use super::{DataPoint, Orientation};

/// One polygon with holes. Rings may be open or closed and of either orientation.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Polygon {
    /// Outer ring.
    pub exterior: Vec<DataPoint>,
    /// Rings cut out of the outer one.
    pub holes: Vec<Vec<DataPoint>>,
}

impl Polygon {
    /// A polygon without holes.
    pub fn new(exterior: impl Into<Vec<DataPoint>>) -> Self {
        Self { exterior: exterior.into(), holes: Vec::new() }
    }

    /// Adds a hole.
    #[must_use]
    pub fn hole(mut self, ring: impl Into<Vec<DataPoint>>) -> Self {
        self.holes.push(ring.into());
        self
    }

    /// Open rings, the exterior counter-clockwise and the holes clockwise, so that the non-zero
    /// fill rule leaves the holes empty in every backend.
    pub(crate) fn oriented_rings(&self) -> Vec<Vec<DataPoint>> {
        let exterior = oriented(&self.exterior, true);
        std::iter::once(exterior).chain(self.holes.iter().map(|hole| oriented(hole, false))).collect()
    }
}

fn oriented(ring: &[DataPoint], counter_clockwise: bool) -> Vec<DataPoint> {
    let mut ring = open_ring(ring).to_vec();
    // Relative to the first vertex, so that rings far from the origin keep their sign.
    let (x0, y0) = ring.first().copied().unwrap_or_default();
    let doubled_area: f64 = ring
        .iter()
        .zip(ring.iter().cycle().skip(1))
        .map(|(a, b)| (a.0 - x0) * (b.1 - y0) - (b.0 - x0) * (a.1 - y0))
        .sum();
    if (doubled_area > 0.0) != counter_clockwise {
        ring.reverse();
    }
    ring
}

/// The ring without its closing repetition of the first vertex.
pub(crate) fn open_ring(ring: &[DataPoint]) -> &[DataPoint] {
    match ring {
        [first, body @ .., last] if first == last && !body.is_empty() => &ring[..ring.len() - 1],
        _ => ring,
    }
}

/// A set of polygons that share a name and a colour.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Polygons {
    /// Name in the legend and the hover text; an empty name has no legend entry.
    pub name: String,
    /// The polygons.
    pub parts: Vec<Polygon>,
    /// Palette index; `None` takes the next one when pushed to a figure.
    pub color: Option<usize>,
}

impl Polygons {
    /// A set of polygons.
    pub fn new(name: impl Into<String>, parts: impl Into<Vec<Polygon>>) -> Self {
        Self { name: name.into(), parts: parts.into(), color: None }
    }
}

/// A strip over the whole figure, such as a measured value with its tolerance.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Span {
    /// Name in the legend; an empty name has no legend entry.
    pub name: String,
    /// Direction the strip runs in.
    pub orientation: Orientation,
    /// Lower end across the strip.
    pub low: f64,
    /// Upper end across the strip.
    pub high: f64,
    /// Palette index; `None` is a neutral grey.
    pub color: Option<usize>,
}

impl Span {
    /// A horizontal strip between two y values.
    pub fn horizontal(name: impl Into<String>, low: f64, high: f64) -> Self {
        Self { name: name.into(), orientation: Orientation::Horizontal, low, high, color: None }
    }

    /// A vertical strip between two x values.
    pub fn vertical(name: impl Into<String>, low: f64, high: f64) -> Self {
        Self { name: name.into(), orientation: Orientation::Vertical, low, high, color: None }
    }
}
