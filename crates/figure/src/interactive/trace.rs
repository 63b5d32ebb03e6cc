//! What all traces of plotly.js have in common.

use serde_json::{Value, json};

use crate::escape;
use crate::palette::{Dash, Rgb};

/// What all traces have in common.
pub(super) fn trace(name: &str, mode: &str) -> Value {
    json!({
        "type": "scatter",
        "mode": mode,
        "name": escape::plotly(name),
        "showlegend": !name.is_empty(),
    })
}

/// A translucent colour.
pub(super) fn translucent((r, g, b): Rgb, alpha: f64) -> String {
    format!("rgba({r},{g},{b},{alpha})")
}

/// A dash pattern as lengths in px, the same as in the static renderers.
pub(super) fn dash(dash: Dash, width: f64) -> String {
    let lengths: Vec<String> = dash.lengths(width).iter().map(|l| format!("{l:.1}px")).collect();
    if lengths.is_empty() { "solid".to_owned() } else { lengths.join(",") }
}
