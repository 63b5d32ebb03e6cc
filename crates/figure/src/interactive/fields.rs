//! Many lines and maps of a value as plotly.js traces.

use serde_json::{Value, json};

use super::trace::trace;
use crate::escape;
use crate::model::{DataPoint, Paths, STEPS, Shades};
use crate::palette::{NEUTRAL, PAPER, hex, series, shade};

/// Coordinates of lines in one trace, a gap after each.
fn set_lines<'a>(json: &mut Value, lines: impl Iterator<Item = &'a [DataPoint]>) {
    let (mut x, mut y): (Vec<Value>, Vec<Value>) = (Vec::new(), Vec::new());
    for line in lines {
        for point in line {
            x.push(short(point.0));
            y.push(short(point.1));
        }
        x.push(Value::Null);
        y.push(Value::Null);
    }
    x.pop();
    y.pop();
    json["x"] = x.into();
    json["y"] = y.into();
}

/// Seven digits are more than a screen shows, and half the size of all of them.
fn short(value: f64) -> Value {
    format!("{value:.6e}").parse::<f64>().unwrap_or(value).into()
}

pub(super) fn paths_trace(paths: &Paths) -> Value {
    let mut json = trace(&paths.name, "lines");
    let lines: Vec<Vec<DataPoint>> = paths
        .parts
        .iter()
        .map(|part| {
            let mut line = part.clone();
            if let Some([left, tip, right]) = paths.head(part) {
                line.extend([left, right, tip]);
            }
            line
        })
        .collect();
    set_lines(&mut json, lines.iter().map(Vec::as_slice));
    json["line"] = json!({ "color": hex(paths.color.map_or(NEUTRAL, series)), "width": paths.width });
    json["hoverinfo"] = json!("skip");
    json
}

pub(super) fn shades_traces(shades: &Shades) -> Vec<Value> {
    let mut traces: Vec<Value> = shades
        .level_sets()
        .into_iter()
        .map(|(color, mut rings)| {
            for ring in &mut rings {
                ring.extend(ring.first().copied());
            }
            let mut json = trace("", "lines");
            set_lines(&mut json, rings.iter().map(Vec::as_slice));
            json["fill"] = json!("toself");
            json["fillcolor"] = json!(hex(color));
            // Hides the seams between neighbours of one level.
            json["line"] = json!({ "color": hex(color), "width": 0.3 });
            json["hoverinfo"] = json!("skip");
            json
        })
        .collect();
    if shades.bar {
        traces.push(color_bar(shades));
    }
    traces
}

/// The colours of a map from little to much, without that of nothing.
pub(crate) fn colors() -> Value {
    (1..STEPS).map(|step| hex(shade(step as f64 / (STEPS - 1) as f64))).collect()
}

/// A trace without a point that brings the colour bar.
fn color_bar(shades: &Shades) -> Value {
    let color = |step: usize| hex(if step == 0 { PAPER } else { shade(step as f64 / (STEPS - 1) as f64) });
    let scale: Vec<Value> = (0..STEPS)
        .flat_map(|step| [step, step + 1].map(|end| json!([end as f64 / STEPS as f64, color(step)])))
        .collect();
    let mut json = trace("", "markers");
    json["x"] = json!([null]);
    json["y"] = json!([null]);
    json["hoverinfo"] = json!("skip");
    json["marker"] = json!({
        "color": [shades.range.0], "cmin": shades.range.0, "cmax": shades.range.1,
        "colorscale": scale, "showscale": true,
        "colorbar": {
            "title": { "text": escape::plotly(&shades.name), "side": "right" },
            "thickness": 14, "outlinewidth": 1, "ticks": "outside",
        },
    });
    json
}
