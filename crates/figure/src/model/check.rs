//! What a layer must fulfil before a figure accepts it.

use super::areas::open_ring;
use super::narrowest;
use super::{Axis, Band, DataPoint, Layer, Orientation, Paths, Points, Polygons, Scale, Shades, Span};
use crate::error::{FigureError, MAX_MAGNITUDE, MIN_POSITIVE};

/// Checks one layer against the axes of its figure.
pub(crate) fn check(layer: &Layer, x: &Axis, y: &Axis) -> Result<(), FigureError> {
    let on = Checker { layer: layer.name(), x: x.scale, y: y.scale };
    match layer {
        Layer::Line(line) => {
            on.width(line.width, 0.5)?;
            on.enough("points", line.points.len(), 1)?;
            on.points(&line.points)
        }
        Layer::Band(band) => on.band(band),
        Layer::Polygons(polygons) => on.polygons(polygons),
        Layer::Points(points) => on.marks(points),
        Layer::Paths(paths) => on.paths(paths),
        Layer::Shades(shades) => on.shades(shades),
        Layer::Span(span) => on.span(span),
        Layer::RefLine(line) => on.value("at", 0, line.at, on.scale_across(line.orientation)),
        Layer::Text(text) => on.points(&[text.at]),
    }
}

struct Checker<'a> {
    layer: &'a str,
    x: Scale,
    y: Scale,
}

impl Checker<'_> {
    fn value(&self, what: &'static str, index: usize, value: f64, scale: Scale) -> Result<(), FigureError> {
        let layer = || self.layer.to_owned();
        if !value.is_finite() || value.abs() > MAX_MAGNITUDE {
            return Err(FigureError::NotFinite { layer: layer(), what, index, value });
        }
        if scale == Scale::Log && value < MIN_POSITIVE {
            return Err(FigureError::NotPositive { layer: layer(), what, index, value });
        }
        Ok(())
    }

    fn values(&self, what: &'static str, values: &[f64], scale: Scale) -> Result<(), FigureError> {
        values.iter().enumerate().try_for_each(|(index, &value)| self.value(what, index, value, scale))
    }

    fn points(&self, points: &[DataPoint]) -> Result<(), FigureError> {
        points.iter().enumerate().try_for_each(|(index, point)| {
            self.value("x", index, point.0, self.x)?;
            self.value("y", index, point.1, self.y)
        })
    }

    fn enough(&self, what: &'static str, found: usize, needed: usize) -> Result<(), FigureError> {
        if found >= needed {
            return Ok(());
        }
        Err(FigureError::TooFewPoints { layer: self.layer.to_owned(), what, needed, found })
    }

    fn same_length(&self, what: &'static str, found: usize, expected: usize) -> Result<(), FigureError> {
        if found == expected {
            return Ok(());
        }
        Err(FigureError::LengthMismatch { layer: self.layer.to_owned(), what, expected, found })
    }

    fn band(&self, band: &Band) -> Result<(), FigureError> {
        self.enough("x", band.x.len(), 2)?;
        self.same_length("low", band.low.len(), band.x.len())?;
        self.same_length("high", band.high.len(), band.x.len())?;
        self.values("x", &band.x, self.x)?;
        self.values("low", &band.low, self.y)?;
        self.values("high", &band.high, self.y)
    }

    fn polygons(&self, polygons: &Polygons) -> Result<(), FigureError> {
        self.enough("parts", polygons.parts.len(), 1)?;
        for part in &polygons.parts {
            for ring in std::iter::once(&part.exterior).chain(&part.holes) {
                self.enough("ring", open_ring(ring).len(), 3)?;
                self.points(ring)?;
            }
        }
        Ok(())
    }

    fn marks(&self, points: &Points) -> Result<(), FigureError> {
        let expected = points.points.len();
        self.enough("points", expected, 1)?;
        self.points(&points.points)?;
        if let Some(labels) = &points.labels {
            self.same_length("labels", labels.len(), expected)?;
        }
        let Some(lengths) = &points.y_error else { return Ok(()) };
        self.same_length("y_error", lengths.len(), expected)?;
        for (index, &(down, up)) in lengths.iter().enumerate() {
            for value in [down, up] {
                if !(0.0..=MAX_MAGNITUDE).contains(&value) {
                    let layer = self.layer.to_owned();
                    return Err(FigureError::BadErrorBar { layer, index, value });
                }
            }
        }
        for (index, (low, high)) in points.bars().unwrap_or_default().into_iter().enumerate() {
            self.value("y error bar", index, low, self.y)?;
            self.value("y error bar", index, high, self.y)?;
        }
        Ok(())
    }

    fn width(&self, width: f64, least: f64) -> Result<(), FigureError> {
        if (least..=12.0).contains(&width) {
            return Ok(());
        }
        Err(FigureError::BadWidth { layer: self.layer.to_owned(), value: width, least })
    }

    fn paths(&self, paths: &Paths) -> Result<(), FigureError> {
        self.width(paths.width, 0.2)?;
        self.enough("parts", paths.parts.len(), 1)?;
        paths.parts.iter().try_for_each(|part| {
            self.enough("part", part.len(), 2)?;
            self.points(part)
        })
    }

    fn shades(&self, shades: &Shades) -> Result<(), FigureError> {
        self.enough("parts", shades.parts.len(), 1)?;
        for (index, part) in shades.parts.iter().enumerate() {
            self.enough("ring", part.ring.len(), 3)?;
            self.points(&part.ring)?;
            self.value("values", index, part.value, Scale::Linear)?;
        }
        let (low, high) = shades.range;
        self.values("range", &[low, high], Scale::Linear)?;
        if high - low > narrowest(low, high) {
            return Ok(());
        }
        Err(FigureError::Inverted { what: format!("colours of layer \"{}\"", self.layer), low, high })
    }

    fn span(&self, span: &Span) -> Result<(), FigureError> {
        self.values("ends", &[span.low, span.high], self.scale_across(span.orientation))?;
        if span.low < span.high {
            return Ok(());
        }
        Err(FigureError::Inverted {
            what: format!("layer \"{}\"", self.layer),
            low: span.low,
            high: span.high,
        })
    }

    fn scale_across(&self, orientation: Orientation) -> Scale {
        match orientation {
            Orientation::Horizontal => self.y,
            Orientation::Vertical => self.x,
        }
    }
}
