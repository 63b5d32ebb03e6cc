//! The layers of a figure in draw order, and lines and texts among them.

use super::areas::{draw_band, draw_polygons, draw_shades, draw_span};
use super::axes::DROP;
use super::clip::Rect;
use super::fonts;
use super::frame::{Frame, TICK_EM};
use super::paths::draw_paths;
use super::points::{RIM, draw_points};
use super::svg::{Pen, Svg};
use super::words::{Anchor, Label};
use crate::model::{Figure, Layer, Line, RefLine, Text, TextPlace};
use crate::palette::{Dash, INK, NEUTRAL, PAPER, series};

/// Width of reference lines in px.
pub(crate) const REF_WIDTH: f64 = 1.5;

/// Draws spans, then data, then reference lines, then texts.
pub(crate) fn draw(figure: &Figure, frame: &Frame, svg: &mut Svg) {
    // The sort is stable: layers of one height stay in the order they were pushed.
    let mut layers: Vec<&Layer> = figure.layers.iter().collect();
    layers.sort_by_key(|layer| match layer {
        Layer::Span(_) => 0,
        Layer::Line(_)
        | Layer::Band(_)
        | Layer::Polygons(_)
        | Layer::Points(_)
        | Layer::Paths(_)
        | Layer::Shades(_) => 1,
        Layer::RefLine(_) => 2,
        Layer::Text(_) => 3,
    });
    for layer in layers {
        match layer {
            Layer::Span(span) => draw_span(span, frame, svg),
            Layer::Line(line) => draw_line(line, frame, svg),
            Layer::Band(band) => draw_band(band, frame, svg),
            Layer::Polygons(polygons) => draw_polygons(polygons, frame, svg),
            Layer::Points(points) => draw_points(points, frame, svg),
            Layer::Paths(paths) => draw_paths(paths, frame, svg),
            Layer::Shades(shades) => draw_shades(shades, frame, svg),
            Layer::RefLine(line) => {
                svg.stroke(&frame.cut_lines([frame.across(line.orientation, line.at)]), ref_pen(line));
            }
            Layer::Text(text) => draw_text(text, frame, svg),
        }
    }
}

/// What a line is drawn with.
pub(crate) fn line_pen(line: &Line) -> Pen {
    let index = line.color.unwrap_or_default();
    let dash = line.dash.unwrap_or_else(|| Dash::of(index));
    Pen { width: line.width, color: series(index), dash }
}

/// What a reference line is drawn with.
pub(crate) fn ref_pen(line: &RefLine) -> Pen {
    Pen { width: REF_WIDTH, color: line.color.map_or(NEUTRAL, series), dash: line.dash }
}

fn draw_line(line: &Line, frame: &Frame, svg: &mut Svg) {
    let (points, pen) = (frame.all(&line.points), line_pen(line));
    if let [alone] = points[..] {
        // A line of one point has no length; a dot of its width shows where it is.
        if frame.plot.contains(alone) {
            svg.disc(alone, pen.width, pen.color, RIM);
        }
        return;
    }
    svg.stroke(&frame.cut_lines([points]), pen);
}

fn draw_text(text: &Text, frame: &Frame, svg: &mut Svg) {
    const GAP: f64 = 8.0;
    let (x, y) = frame.at(text.at);
    if !frame.plot.contains((x, y)) {
        return;
    }
    let label = fonts::fit(&text.text, TICK_EM, false, frame.plot.width() - 8.0);
    let width = fonts::width(&label, TICK_EM, false);
    let (left, middle) = match text.place {
        TextPlace::Above => (x - width / 2.0, y - GAP - TICK_EM / 2.0),
        TextPlace::Below => (x - width / 2.0, y + GAP + TICK_EM / 2.0),
        TextPlace::Left => (x - GAP - width, y),
        TextPlace::Right => (x + GAP, y),
        TextPlace::Center => (x - width / 2.0, y),
    };
    let plot = &frame.plot;
    let left = left.min(plot.right - width - 4.0).max(plot.left + 4.0);
    let middle = middle.min(plot.bottom - TICK_EM * 0.8).max(plot.top + TICK_EM * 0.8);
    let half = TICK_EM * 0.62;
    let halo =
        Rect { left: left - 2.0, top: middle - half, right: left + width + 2.0, bottom: middle + half };
    svg.fill(&[halo.ring()], PAPER, 0.75);
    let color = text.color.map_or(INK, series);
    let at = (left, middle + TICK_EM * DROP);
    svg.label(&Label { color, ..Label::new(label, at, Anchor::Start, TICK_EM) });
}
