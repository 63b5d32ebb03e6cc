//! Filled layers: bands, polygons, spans and maps of a value.

use super::frame::Frame;
use super::px::Px;
use super::svg::{Pen, Svg};
use crate::model::{Band, DataPoint, Polygons, Shades, Span};
use crate::palette::{Dash, FILL_ALPHA, NEUTRAL, series};

pub(crate) fn draw_band(band: &Band, frame: &Frame, svg: &mut Svg) {
    fill(&frame.cut_rings([frame.all(&band.outline())]), band.color, svg);
    let curves = [&band.low, &band.high].map(|curve| {
        let points: Vec<DataPoint> = band.x.iter().copied().zip(curve.iter().copied()).collect();
        frame.all(&points)
    });
    svg.stroke(&frame.cut_lines(curves), edge(band.color));
}

pub(crate) fn draw_polygons(polygons: &Polygons, frame: &Frame, svg: &mut Svg) {
    for part in &polygons.parts {
        let rings = part.oriented_rings();
        fill(&frame.cut_rings(rings.iter().map(|ring| frame.all(ring))), polygons.color, svg);
        let lines = rings.iter().map(|ring| {
            let mut line = frame.all(ring);
            line.extend(line.first().copied());
            line
        });
        svg.stroke(&frame.cut_lines(lines), edge(polygons.color));
    }
}

/// Spans are not hatched: the other layers lie on them.
pub(crate) fn draw_span(span: &Span, frame: &Frame, svg: &mut Svg) {
    let [low, high] = [span.low, span.high].map(|end| frame.across(span.orientation, end));
    let ring: Vec<Px> = low.iter().chain(high.iter().rev()).copied().collect();
    svg.fill(&frame.cut_rings([ring]), span.color.map_or(NEUTRAL, series), FILL_ALPHA);
    svg.stroke(&frame.cut_lines([low, high]), edge(span.color));
}

pub(crate) fn draw_shades(shades: &Shades, frame: &Frame, svg: &mut Svg) {
    for (color, rings) in shades.level_sets() {
        svg.fill(&frame.cut_rings(rings.iter().map(|ring| frame.all(ring))), color, 1.0);
    }
}

/// Fills an area that is told from others by its colour and its hatch.
pub(crate) fn fill(rings: &[Vec<Px>], index: Option<usize>, svg: &mut Svg) {
    let index = index.unwrap_or_default();
    svg.fill(rings, series(index), FILL_ALPHA);
    svg.hatch(rings, index);
}

/// What the edges of an area are drawn with; areas without a palette index are grey.
pub(crate) fn edge(index: Option<usize>) -> Pen {
    let (color, dash) = (index.map_or(NEUTRAL, series), index.map_or(Dash::LooseDot, Dash::of));
    Pen { width: 1.2, color, dash }
}
