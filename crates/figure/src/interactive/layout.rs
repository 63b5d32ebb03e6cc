//! Axes, legend, spans and reference lines of the plotly.js layout.

use serde_json::{Map, Value, json};

use super::trace::{dash, translucent};
use crate::draw::REF_WIDTH;
use crate::escape;
use crate::extent;
use crate::model::{Axis, Figure, Layer, Legend, Orientation, RefLine, Scale, Span};
use crate::palette::{Dash, FILL_ALPHA, GRID, INK, NEUTRAL, PAPER, hex, series};

/// The layout of a figure.
pub(super) fn of(figure: &Figure) -> Value {
    let extent = extent::of(figure);
    let mut layout = json!({
        "autosize": true,
        "hovermode": "closest",
        "hoverlabel": { "font": { "family": "system-ui, sans-serif", "size": 13 } },
        "dragmode": "zoom",
        "paper_bgcolor": hex(PAPER),
        "plot_bgcolor": hex(PAPER),
        "font": { "family": "system-ui, sans-serif", "size": 13, "color": hex(INK) },
        "margin": { "l": 12, "r": 20, "t": 56, "b": 12 },
        "xaxis": axis(&figure.x, extent.x),
        "yaxis": axis(&figure.y, extent.y),
        "showlegend": figure.legend != Legend::Hidden && figure.layers.iter().any(Layer::in_legend),
        "legend": legend(figure.legend),
        "shapes": shapes(figure),
    });
    if !figure.title.is_empty() {
        let text = escape::plotly(&figure.title);
        layout["title"] = json!({ "text": text, "font": { "size": 16 }, "automargin": true });
    }
    if figure.equal_aspect {
        layout["yaxis"]["scaleanchor"] = json!("x");
    }
    layout
}

fn axis(axis: &Axis, (low, high): (f64, f64)) -> Value {
    let (kind, range) = match axis.scale {
        Scale::Linear => ("linear", [low, high]),
        Scale::Log => ("log", [low.log10(), high.log10()]),
    };
    let mut json = json!({
        "title": { "text": escape::plotly(&axis.label), "standoff": 8 },
        "type": kind,
        "range": range,
        "automargin": true,
        "exponentformat": "power",
        "minexponent": 5,
        "gridcolor": hex(GRID),
        "linecolor": hex(INK),
        "tickcolor": hex(INK),
        "ticks": "outside",
        "showline": true,
        "mirror": true,
        "zeroline": false,
    });
    if axis.scale == Scale::Log {
        json["minor"] = json!({ "ticks": "outside", "ticklen": 3, "tickcolor": hex(INK) });
        // Labels between the decades as well where only few of these are in view.
        json["dtick"] = match high / low {
            ratio if ratio < 15.0 => json!("D1"),
            ratio if ratio < 300.0 => json!("D2"),
            _ => json!(decade_step(low, high)),
        };
        if high / low < 300.0 {
            // Between decades plotly.js writes bare digits unless it is given a form.
            json["tickformat"] = json!("~g");
        }
    }
    json
}

/// Decades between labels; plotly.js leaves none out by itself once the step is given.
fn decade_step(low: f64, high: f64) -> u32 {
    let decades = high.log10() - low.log10();
    [1, 2, 5, 10].into_iter().find(|&step| decades / f64::from(step) <= 9.0).unwrap_or(25)
}

fn legend(place: Legend) -> Value {
    match place {
        Legend::Right => json!({ "orientation": "v", "x": 1.02, "xanchor": "left", "y": 1, "itemwidth": 40 }),
        Legend::Below | Legend::Hidden => json!({
            "orientation": "h", "x": 0.5, "xanchor": "center",
            "y": 0, "yref": "container", "yanchor": "bottom", "itemwidth": 40,
        }),
    }
}

fn shapes(figure: &Figure) -> Vec<Value> {
    let shape = |layer: &Layer| match layer {
        Layer::Span(span) => Some(named(span_shape(span), &span.name)),
        Layer::RefLine(line) => Some(named(line_shape(line), &line.name)),
        _ => None,
    };
    figure.layers.iter().filter_map(shape).collect()
}

fn named(mut shape: Map<String, Value>, name: &str) -> Value {
    shape.insert("showlegend".into(), json!(!name.is_empty()));
    shape.insert("name".into(), json!(escape::plotly(name)));
    Value::Object(shape)
}

fn span_shape(span: &Span) -> Map<String, Value> {
    let color = span.color.map_or(NEUTRAL, series);
    let outline = dash(span.color.map_or(Dash::LooseDot, Dash::of), 1.2);
    let mut shape = across(span.orientation, span.low, span.high);
    shape.insert("type".into(), json!("rect"));
    shape.insert("layer".into(), json!("below"));
    shape.insert("fillcolor".into(), json!(translucent(color, FILL_ALPHA)));
    shape.insert("line".into(), json!({ "color": hex(color), "width": 1.2, "dash": outline }));
    shape
}

fn line_shape(line: &RefLine) -> Map<String, Value> {
    let color = hex(line.color.map_or(NEUTRAL, series));
    let mut shape = across(line.orientation, line.at, line.at);
    shape.insert("type".into(), json!("line"));
    shape.insert("layer".into(), json!("above"));
    let pattern = dash(line.dash, REF_WIDTH);
    shape.insert("line".into(), json!({ "color": color, "width": REF_WIDTH, "dash": pattern }));
    shape
}

/// Corners of a shape that runs over the whole figure.
fn across(orientation: Orientation, low: f64, high: f64) -> Map<String, Value> {
    let (along, over) = match orientation {
        Orientation::Horizontal => ("x", "y"),
        Orientation::Vertical => ("y", "x"),
    };
    let mut shape = Map::new();
    shape.insert(format!("{along}ref"), json!("paper"));
    shape.insert(format!("{over}ref"), json!(over));
    shape.insert(format!("{along}0"), json!(0));
    shape.insert(format!("{along}1"), json!(1));
    shape.insert(format!("{over}0"), json!(low));
    shape.insert(format!("{over}1"), json!(high));
    shape
}
