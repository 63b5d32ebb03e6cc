use serde::Serialize;

use super::DataPoint;
use super::outline::{bits, outline};
use crate::palette::{Rgb, shade};

/// A polygon and its value.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Shade {
    /// Corners, counter-clockwise.
    pub ring: Vec<DataPoint>,
    /// Value.
    pub value: f64,
}

/// Polygons coloured by a value, with a colour bar beside the plot: a map of something over a mesh.
///
/// Values are put into steps of equal width, and neighbours in a step or above are drawn as one, so files stay small
/// however many polygons there are. Polygons are neighbours where they share corners, to the last digit. What lies below
/// the second step is left as it is.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Shades {
    /// Label of the colour bar, with the unit.
    pub name: String,
    /// The polygons.
    pub parts: Vec<Shade>,
    /// Values at the ends of the colour bar; what is beyond has the colour of the end.
    pub range: (f64, f64),
    /// Whether there is a colour bar beside the plot.
    pub bar: bool,
}

/// Steps of the colour bar.
pub(crate) const STEPS: usize = 10;

impl Shades {
    /// Polygons coloured by their values between `low` and `high`.
    pub fn new(name: impl Into<String>, parts: impl Into<Vec<Shade>>, low: f64, high: f64) -> Self {
        Self { name: name.into(), parts: parts.into(), range: (low, high), bar: true }
    }

    /// Leaves the colour bar out, for colours that only keep things apart.
    #[must_use]
    pub fn without_bar(mut self) -> Self {
        self.bar = false;
        self
    }

    /// Lowest value of a step.
    pub(crate) fn threshold(&self, step: usize) -> f64 {
        let (low, high) = self.range;
        low + (high - low) * step as f64 / STEPS as f64
    }

    /// For each step from the second on, its colour and the outline of all polygons in it or above, to be painted over each
    /// other in this order.
    pub(crate) fn level_sets(&self) -> Vec<(Rgb, Vec<Vec<DataPoint>>)> {
        (1..STEPS)
            .map(|step| {
                let least = self.threshold(step);
                let rings = self.parts.iter().filter(|p| p.value >= least).map(|p| p.ring.as_slice());
                (shade(step as f64 / (STEPS - 1) as f64), outline(rings, |p| [p.0, p.1].map(bits)))
            })
            .filter(|(_, rings)| !rings.is_empty())
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbours_are_outlined_as_one() {
        let square = |x: f64, value: f64| Shade {
            ring: vec![(x, 0.0), (x + 1.0, 0.0), (x + 1.0, 1.0), (x, 1.0)],
            value,
        };
        let sets =
            Shades::new("v", [square(0.0, 0.55), square(1.0, 1.2), square(5.0, 0.05)], 0.0, 1.0).level_sets();
        assert_eq!(sets.len(), STEPS - 1);
        for (i, (_, rings)) in sets.iter().enumerate() {
            // Both up to 0.5, the second alone beyond; the third is below the second step.
            let corners = if i < 5 { 6 } else { 4 };
            assert_eq!(rings.iter().map(Vec::len).collect::<Vec<_>>(), [corners], "{i}");
        }
    }
}
