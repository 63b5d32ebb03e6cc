//! The range of each axis: fixed by the user, or the data with 5 % padding.

use crate::model::{Axis, DataPoint, Figure, Layer, Orientation, Polygon, Scale, narrowest};

const PADDING: f64 = 0.05;

/// Ranges of both axes in data units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Extent {
    pub(crate) x: (f64, f64),
    pub(crate) y: (f64, f64),
}

/// The smallest and the largest value seen so far.
#[derive(Clone, Copy)]
struct Bounds(Option<(f64, f64)>);

impl Bounds {
    fn add(&mut self, value: f64) {
        let (low, high) = self.0.unwrap_or((value, value));
        self.0 = Some((low.min(value), high.max(value)));
    }
}

/// The ranges of a figure.
pub(crate) fn of(figure: &Figure) -> Extent {
    let (mut x, mut y) = (Bounds(None), Bounds(None));
    for layer in &figure.layers {
        add_layer(layer, &mut x, &mut y);
    }
    Extent { x: resolve(&figure.x, x), y: resolve(&figure.y, y) }
}

fn add_layer(layer: &Layer, x: &mut Bounds, y: &mut Bounds) {
    let mut add = |points: &[DataPoint]| {
        for point in points {
            x.add(point.0);
            y.add(point.1);
        }
    };
    match layer {
        Layer::Line(line) => add(&line.points),
        Layer::Band(band) => add(&band.outline()),
        Layer::Polygons(polygons) => {
            polygons.parts.iter().map(|Polygon { exterior, .. }| exterior).for_each(|ring| add(ring));
        }
        Layer::Points(points) => {
            add(&points.points);
            for (low, high) in points.bars().unwrap_or_default() {
                y.add(low);
                y.add(high);
            }
        }
        Layer::Paths(paths) => paths.parts.iter().for_each(|part| add(part)),
        Layer::Shades(shades) => shades.parts.iter().for_each(|part| add(&part.ring)),
        Layer::Text(text) => add(&[text.at]),
        Layer::Span(span) => {
            let across = if span.orientation == Orientation::Horizontal { y } else { x };
            across.add(span.low);
            across.add(span.high);
        }
        Layer::RefLine(line) => {
            let across = if line.orientation == Orientation::Horizontal { y } else { x };
            across.add(line.at);
        }
    }
}

fn resolve(axis: &Axis, bounds: Bounds) -> (f64, f64) {
    match (axis.range, bounds.0, axis.scale) {
        (Some(fixed), _, _) => fixed,
        (None, Some((low, high)), Scale::Linear) => padded(low, high, low.abs() * PADDING),
        (None, Some((low, high)), Scale::Log) => {
            let (low, high) = padded(low.log10(), high.log10(), 0.5);
            (10f64.powf(low), 10f64.powf(high))
        }
        (None, None, Scale::Linear) => (0.0, 1.0),
        (None, None, Scale::Log) => (1.0, 10.0),
    }
}

/// Widens a range by 5 % at both ends; a range of a single value by `alone`, or 1 if that is 0.
fn padded(low: f64, high: f64, alone: f64) -> (f64, f64) {
    let width = high - low;
    let margin = if width > narrowest(low, high) {
        width * PADDING
    } else if alone > 0.0 {
        alone
    } else {
        1.0
    };
    (low - margin, high + margin)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pads_by_five_percent_on_both_scales() {
        assert_eq!(padded(0.0, 100.0, 0.0), (-5.0, 105.0));
        let log = resolve(&Axis::log("t"), Bounds(Some((1.0, 100.0))));
        assert!((log.0 - 10f64.powf(-0.1)).abs() < 1e-12 && (log.1 - 10f64.powf(2.1)).abs() < 1e-9);
    }

    #[test]
    fn single_values_get_a_range_around_them() {
        for value in [0.0, 5.0, -3e20, 1e100, 1e-90, -1e100] {
            let (low, high) = resolve(&Axis::linear("v"), Bounds(Some((value, value))));
            assert!(low < value && value < high, "{value}: {low} {high}");
        }
        for value in [1e-100, 1.0, 1e100] {
            let (low, high) = resolve(&Axis::log("v"), Bounds(Some((value, value))));
            assert!(0.0 < low && low < value && value < high && high.is_finite(), "{value}");
        }
    }
}
