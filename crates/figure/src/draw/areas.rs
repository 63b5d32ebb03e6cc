//! Filled layers: bands, polygons and spans, each with an outline of its own dash.

use super::clip;
use super::dash::dashes;
use super::frame::Frame;
use super::hatch::draw_hatch;
use super::scene::{Px, Scene};
use crate::model::{Band, DataPoint, Orientation, Polygons, Span};
use crate::palette::{Dash, FILL_ALPHA, Hatch, NEUTRAL, Rgb, series};

const OUTLINE: f64 = 1.2;

pub(crate) fn draw_band(band: &Band, frame: &Frame, scene: &mut Scene) {
    let index = band.color.unwrap_or_default();
    fill(&[band.outline()], index, frame, scene);
    for curve in [&band.low, &band.high] {
        let points: Vec<DataPoint> = band.x.iter().copied().zip(curve.iter().copied()).collect();
        outline(&frame.all(&points), Dash::of(index), series(index), frame, scene);
    }
}

pub(crate) fn draw_polygons(polygons: &Polygons, frame: &Frame, scene: &mut Scene) {
    let index = polygons.color.unwrap_or_default();
    for part in &polygons.parts {
        let rings = part.oriented_rings();
        fill(&rings, index, frame, scene);
        for ring in &rings {
            let mut closed = frame.all(ring);
            closed.extend(closed.first().copied());
            outline(&closed, Dash::of(index), series(index), frame, scene);
        }
    }
}

pub(crate) fn draw_span(span: &Span, frame: &Frame, scene: &mut Scene) {
    let color = span.color.map_or(NEUTRAL, series);
    let dash = span.color.map_or(Dash::LooseDot, Dash::of);
    let plot = &frame.plot;
    let edges = [span.low, span.high].map(|end| match span.orientation {
        Orientation::Horizontal => vec![(plot.left, frame.y(end)), (plot.right, frame.y(end))],
        Orientation::Vertical => vec![(frame.x(end), plot.top), (frame.x(end), plot.bottom)],
    });
    let ring: Vec<Px> = edges[0].iter().chain(edges[1].iter().rev()).copied().collect();
    let ring = clip::ring(&ring, plot);
    if ring.len() > 2 {
        scene.fill(vec![ring], color, FILL_ALPHA);
    }
    for edge in &edges {
        outline(edge, dash, color, frame, scene);
    }
}

fn fill(rings: &[Vec<DataPoint>], index: usize, frame: &Frame, scene: &mut Scene) {
    let rings: Vec<Vec<Px>> = rings
        .iter()
        .map(|ring| clip::ring(&frame.all(ring), &frame.plot))
        .filter(|ring| ring.len() > 2)
        .collect();
    if !rings.is_empty() {
        scene.fill(rings.clone(), series(index), FILL_ALPHA);
        draw_hatch(&rings, Hatch::of(index), series(index), scene);
    }
}

fn outline(points: &[Px], dash: Dash, color: Rgb, frame: &Frame, scene: &mut Scene) {
    stroke(points, dash, OUTLINE, color, frame, scene);
}

/// A dashed line, cut at the edges of the plot area.
pub(crate) fn stroke(points: &[Px], dash: Dash, width: f64, color: Rgb, frame: &Frame, scene: &mut Scene) {
    for part in clip::polyline(points, &frame.plot) {
        for piece in dashes(&part, dash.pattern(), width) {
            scene.stroke(piece, width, color);
        }
    }
}
