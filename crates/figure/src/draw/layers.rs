//! The layers of a figure in draw order, and the line-like and point-like ones among them.

use super::areas::{draw_band, draw_polygons, draw_span, stroke};
use super::clip::Rect;
use super::fonts;
use super::frame::{Frame, TICK_EM};
use super::paths::draw_paths;
use super::scene::{Anchor, Item, Label, Px, Scene};
use super::shades::draw_shades;
use crate::model::{Figure, Layer, Line, Orientation, Points, RefLine, Text, TextPlace};
use crate::palette::{Dash, INK, Marker, NEUTRAL, PAPER, Rgb, series};

/// Radius of a marker in px.
pub(crate) const MARKER: f64 = 4.2;
/// Width of reference lines in px.
pub(crate) const REF_WIDTH: f64 = 1.5;

/// Draws spans, then data, then reference lines, then texts.
pub(crate) fn draw(figure: &Figure, frame: &Frame, scene: &mut Scene) {
    for layer in &figure.layers {
        if let Layer::Span(span) = layer {
            draw_span(span, frame, scene);
        }
    }
    for layer in &figure.layers {
        match layer {
            Layer::Line(line) => draw_line(line, frame, scene),
            Layer::Band(band) => draw_band(band, frame, scene),
            Layer::Polygons(polygons) => draw_polygons(polygons, frame, scene),
            Layer::Points(points) => draw_points(points, frame, scene),
            Layer::Paths(paths) => draw_paths(paths, frame, scene),
            Layer::Shades(shades) => draw_shades(shades, frame, scene),
            Layer::Span(_) | Layer::RefLine(_) | Layer::Text(_) => {}
        }
    }
    for layer in &figure.layers {
        if let Layer::RefLine(line) = layer {
            draw_ref_line(line, frame, scene);
        }
    }
    for layer in &figure.layers {
        if let Layer::Text(text) = layer {
            draw_text(text, frame, scene);
        }
    }
}

fn draw_line(line: &Line, frame: &Frame, scene: &mut Scene) {
    let index = line.color.unwrap_or_default();
    let points = frame.all(&line.points);
    if let [alone] = points[..] {
        // A line of one point has no length; a dot of its width shows where it is.
        if frame.plot.contains(alone) {
            scene.items.push(Item::Disc { center: alone, radius: line.width, color: series(index) });
        }
        return;
    }
    let dash = line.dash.unwrap_or_else(|| Dash::of(index));
    stroke(&points, dash, line.width, series(index), frame, scene);
}

fn draw_ref_line(line: &RefLine, frame: &Frame, scene: &mut Scene) {
    let plot = &frame.plot;
    let points = match line.orientation {
        Orientation::Horizontal => [(plot.left, frame.y(line.at)), (plot.right, frame.y(line.at))],
        Orientation::Vertical => [(frame.x(line.at), plot.bottom), (frame.x(line.at), plot.top)],
    };
    stroke(&points, line.dash, REF_WIDTH, line.color.map_or(NEUTRAL, series), frame, scene);
}

fn draw_points(points: &Points, frame: &Frame, scene: &mut Scene) {
    const CAP: f64 = 4.0;
    let index = points.color.unwrap_or_default();
    let color = series(index);
    let bars = points.bars().unwrap_or_default();
    for (point, (low, high)) in points.points.iter().zip(bars) {
        let (x, low, high) = (frame.x(point.0), frame.y(low), frame.y(high));
        let strokes =
            [[(x, low), (x, high)], [(x - CAP, low), (x + CAP, low)], [(x - CAP, high), (x + CAP, high)]];
        for ends in strokes {
            stroke(&ends, Dash::Solid, 1.3, color, frame, scene);
        }
    }
    let shape = points.marker.unwrap_or_else(|| Marker::of(index));
    for &point in &points.points {
        let center = frame.at(point);
        if frame.plot.contains(center) {
            draw_marker(shape, center, color, scene);
        }
    }
}

/// One marker, with a thin rim of paper that keeps overlapping markers apart.
pub(crate) fn draw_marker(shape: Marker, (x, y): Px, color: Rgb, scene: &mut Scene) {
    const RIM: f64 = 0.8;
    let corners = |r: f64| match shape {
        Marker::Square => vec![(x - r, y - r), (x + r, y - r), (x + r, y + r), (x - r, y + r)],
        Marker::Diamond => vec![(x, y - r), (x + r, y), (x, y + r), (x - r, y)],
        _ => vec![(x, y - r), (x + 0.95 * r, y + 0.65 * r), (x - 0.95 * r, y + 0.65 * r)],
    };
    match shape {
        Marker::Circle => {
            scene.items.push(Item::Disc { center: (x, y), radius: MARKER + RIM, color: PAPER });
            scene.items.push(Item::Disc { center: (x, y), radius: MARKER, color });
        }
        Marker::Cross => {
            let r = MARKER * 0.95;
            scene.stroke(vec![(x - r, y - r), (x + r, y + r)], 2.0, color);
            scene.stroke(vec![(x - r, y + r), (x + r, y - r)], 2.0, color);
        }
        Marker::Square | Marker::Diamond | Marker::Triangle => {
            // Radii that give all shapes about the same area.
            let r = match shape {
                Marker::Square => MARKER * 0.9,
                Marker::Diamond => MARKER * 1.25,
                _ => MARKER * 1.3,
            };
            scene.fill(vec![corners(r + 1.3 * RIM)], PAPER, 1.0);
            scene.fill(vec![corners(r)], color, 1.0);
        }
    }
}

fn draw_text(text: &Text, frame: &Frame, scene: &mut Scene) {
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
    scene.fill(vec![halo.ring()], PAPER, 0.75);
    let color = text.color.map_or(INK, series);
    let at = (left, middle + TICK_EM * 0.36);
    scene.label(Label { color, ..Label::new(label, at, Anchor::Start, TICK_EM) });
}
