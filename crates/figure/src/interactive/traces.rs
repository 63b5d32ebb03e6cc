//! The layers with points as plotly.js scatter traces.

use serde_json::{Value, json};

use super::fields::{paths_trace, shades_traces};
use super::trace::{dash, trace, translucent};
use crate::escape;
use crate::model::{Band, Figure, Layer, Line, Points, Polygons, Text, TextPlace};
use crate::palette::{Dash, FILL_ALPHA, Hatch, INK, Marker, hex, series};

/// The traces of a figure; texts last, so that they stay on top.
pub(super) fn of(figure: &Figure) -> Vec<Value> {
    let hover = Hover::new(figure);
    let trace = |layer: &Layer| match layer {
        Layer::Line(line) => vec![line_trace(line, &hover)],
        Layer::Band(band) => vec![band_trace(band, &hover)],
        Layer::Polygons(polygons) => vec![polygons_trace(polygons, &hover)],
        Layer::Points(points) => vec![points_trace(points, &hover)],
        Layer::Paths(paths) => vec![paths_trace(paths)],
        Layer::Shades(shades) => shades_traces(shades),
        Layer::Span(_) | Layer::RefLine(_) | Layer::Text(_) => Vec::new(),
    };
    let text = |layer: &Layer| match layer {
        Layer::Text(text) => Some(text_trace(text)),
        _ => None,
    };
    figure.layers.iter().flat_map(trace).chain(figure.layers.iter().filter_map(text)).collect()
}

/// Hover templates: each value after the label of its axis, which carries the unit.
struct Hover {
    x: String,
    y: String,
}

impl Hover {
    fn new(figure: &Figure) -> Self {
        Self { x: escape::plotly(&figure.x.label), y: escape::plotly(&figure.y.label) }
    }

    fn point(&self) -> String {
        format!("{}: %{{x:.5~g}}<br>{}: %{{y:.5~g}}<extra>%{{fullData.name}}</extra>", self.x, self.y)
    }

    fn labelled(&self) -> String {
        format!("<b>%{{text}}</b><br>{}", self.point())
    }

    fn band(&self) -> String {
        format!(
            "{}: %{{x:.5~g}}<br>{}: %{{customdata[0]:.5~g}} to %{{customdata[1]:.5~g}}\
             <extra>%{{fullData.name}}</extra>",
            self.x, self.y
        )
    }
}

fn line_trace(line: &Line, hover: &Hover) -> Value {
    let index = line.color.unwrap_or_default();
    // A line of one point has no length; a marker shows where it is.
    let alone = line.points.len() == 1;
    let mut json = trace(&line.name, if alone { "markers" } else { "lines" });
    json["x"] = line.points.iter().map(|p| p.0).collect();
    json["y"] = line.points.iter().map(|p| p.1).collect();
    json["line"] = json!({
        "color": hex(series(index)),
        "width": line.width,
        "dash": dash(line.dash.unwrap_or_else(|| Dash::of(index)), line.width),
    });
    if alone {
        json["marker"] = json!({ "color": hex(series(index)), "size": 2.0 * line.width });
    }
    json["hovertemplate"] = hover.point().into();
    json
}

/// Fill, hatch and outline of an area.
fn fill(json: &mut Value, index: usize) {
    let color = series(index);
    json["fill"] = json!("toself");
    json["fillcolor"] = json!(translucent(color, FILL_ALPHA));
    let hatch = Hatch::of(index).name();
    if !hatch.is_empty() {
        json["fillpattern"] = json!({
            "shape": hatch, "size": 9, "solidity": 0.12,
            "fgcolor": hex(color), "bgcolor": translucent(color, 0.16), "fgopacity": 0.55,
        });
    }
    json["line"] = json!({ "color": hex(color), "width": 1.2, "dash": dash(Dash::of(index), 1.2) });
    json["hoveron"] = json!("points");
}

fn band_trace(band: &Band, hover: &Hover) -> Value {
    let mut json = trace(&band.name, "lines");
    let outline = band.outline();
    let limits: Vec<[f64; 2]> = band.low.iter().zip(&band.high).map(|(&l, &h)| [l, h]).collect();
    json["x"] = outline.iter().map(|p| p.0).collect();
    json["y"] = outline.iter().map(|p| p.1).collect();
    json["customdata"] = limits.iter().chain(limits.iter().rev()).map(|l| json!(l)).collect();
    fill(&mut json, band.color.unwrap_or_default());
    json["hovertemplate"] = hover.band().into();
    json
}

fn polygons_trace(polygons: &Polygons, hover: &Hover) -> Value {
    let mut json = trace(&polygons.name, "lines");
    let (mut x, mut y): (Vec<Value>, Vec<Value>) = (Vec::new(), Vec::new());
    for ring in polygons.parts.iter().flat_map(|part| part.oriented_rings()) {
        if !x.is_empty() {
            // A gap ends one ring and starts the next.
            x.push(Value::Null);
            y.push(Value::Null);
        }
        for point in ring.iter().chain(ring.first()) {
            x.push(point.0.into());
            y.push(point.1.into());
        }
    }
    json["x"] = x.into();
    json["y"] = y.into();
    fill(&mut json, polygons.color.unwrap_or_default());
    json["hovertemplate"] = hover.point().into();
    json
}

fn points_trace(points: &Points, hover: &Hover) -> Value {
    let index = points.color.unwrap_or_default();
    let shape = points.marker.unwrap_or_else(|| Marker::of(index));
    let (symbol, size) = match shape {
        Marker::Circle => ("circle", 9),
        Marker::Square => ("square", 9),
        Marker::Triangle => ("triangle-up", 10),
        Marker::Diamond => ("diamond", 10),
        Marker::Cross => ("x-thin", 9),
    };
    let color = hex(series(index));
    // The thin cross consists of its outline only.
    let rim = if shape == Marker::Cross { 2.0 } else { 0.0 };
    let mut json = trace(&points.name, "markers");
    json["x"] = points.points.iter().map(|p| p.0).collect();
    json["y"] = points.points.iter().map(|p| p.1).collect();
    json["marker"] =
        json!({ "color": color, "symbol": symbol, "size": size, "line": { "color": color, "width": rim } });
    json["cliponaxis"] = json!(false);
    json["hovertemplate"] = hover.point().into();
    if let Some(labels) = &points.labels {
        json["text"] = labels.iter().map(|label| escape::plotly(label)).collect();
        json["hovertemplate"] = hover.labelled().into();
    }
    if let Some(lengths) = &points.y_error {
        json["error_y"] = json!({
            "type": "data", "symmetric": false, "color": color, "thickness": 1.3, "width": 4,
            "array": lengths.iter().map(|l| l.1).collect::<Vec<_>>(),
            "arrayminus": lengths.iter().map(|l| l.0).collect::<Vec<_>>(),
        });
    }
    json
}

fn text_trace(text: &Text) -> Value {
    let place = match text.place {
        TextPlace::Above => "top center",
        TextPlace::Below => "bottom center",
        TextPlace::Left => "middle left",
        TextPlace::Right => "middle right",
        TextPlace::Center => "middle center",
    };
    // Wide blanks keep the text off a marker at the same point.
    let words = escape::plotly(&text.text);
    let words = match text.place {
        TextPlace::Left => format!("{words}\u{2002}"),
        TextPlace::Right => format!("\u{2002}{words}"),
        _ => words,
    };
    let mut json = trace("", "text");
    json["x"] = json!([text.at.0]);
    json["y"] = json!([text.at.1]);
    json["text"] = json!([words]);
    json["textposition"] = json!(place);
    json["textfont"] = json!({ "color": hex(text.color.map_or(INK, series)), "size": 12 });
    json["hoverinfo"] = json!("skip");
    json["cliponaxis"] = json!(false);
    json
}
