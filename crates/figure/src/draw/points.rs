//! Single points: markers and their error bars.

use super::frame::Frame;
use super::px::Px;
use super::svg::{Pen, Svg};
use crate::model::Points;
use crate::palette::{Marker, Rgb, series};

/// Radius of a marker in px.
pub(crate) const MARKER: f64 = 4.2;
/// Width of the rim of paper that keeps overlapping markers apart.
pub(crate) const RIM: f64 = 0.8;
/// Width of an error bar.
pub(crate) const BAR_WIDTH: f64 = 1.3;

pub(crate) fn draw_points(points: &Points, frame: &Frame, svg: &mut Svg) {
    const CAP: f64 = 4.0;
    let index = points.color.unwrap_or_default();
    let color = series(index);
    let bars = points.bars().unwrap_or_default();
    let bars = points.points.iter().zip(bars).flat_map(|(point, (low, high))| {
        let (x, low, high) = (frame.x(point.0), frame.y(low), frame.y(high));
        let cap = |y: f64| vec![(x - CAP, y), (x + CAP, y)];
        [vec![(x, low), (x, high)], cap(low), cap(high)]
    });
    svg.stroke(&frame.cut_lines(bars), Pen::solid(BAR_WIDTH, color));
    let shape = points.marker.unwrap_or_else(|| Marker::of(index));
    for center in frame.all(&points.points) {
        if frame.plot.contains(center) {
            draw_marker(shape, center, color, svg);
        }
    }
}

/// One marker; all shapes have about the same area.
pub(crate) fn draw_marker(shape: Marker, (x, y): Px, color: Rgb, svg: &mut Svg) {
    let reach = |part: f64| MARKER * part + RIM / 2.0;
    match shape {
        Marker::Circle => svg.disc((x, y), reach(1.0), color, RIM),
        Marker::Square => {
            let r = reach(0.9);
            svg.patch(&[(x - r, y - r), (x + r, y - r), (x + r, y + r), (x - r, y + r)], color, RIM);
        }
        Marker::Diamond => {
            let r = reach(1.25);
            svg.patch(&[(x, y - r), (x + r, y), (x, y + r), (x - r, y)], color, RIM);
        }
        Marker::Triangle => {
            let r = reach(1.3);
            svg.patch(&[(x, y - r), (x + 0.95 * r, y + 0.65 * r), (x - 0.95 * r, y + 0.65 * r)], color, RIM);
        }
        Marker::Cross => {
            let r = MARKER * 0.95;
            let strokes = [vec![(x - r, y - r), (x + r, y + r)], vec![(x - r, y + r), (x + r, y - r)]];
            svg.stroke(&strokes, Pen::solid(2.0, color));
        }
    }
}
