//! Figures as plotly.js input.

mod fields;
mod layout;
mod motion;
mod traces;

pub(crate) use fields::colors as shades;
pub(crate) use motion::to_json as motion_to_json;
use serde_json::{Value, json};

use crate::model::Figure;
use crate::palette::{Dash, Rgb};

/// The `data` and `layout` of a figure.
pub(crate) fn to_json(figure: &Figure) -> Value {
    json!({ "data": traces::of(figure), "layout": layout::of(figure) })
}

/// A translucent colour.
fn translucent((r, g, b): Rgb, alpha: f64) -> String {
    format!("rgba({r},{g},{b},{alpha})")
}

/// A dash pattern as lengths in px, the same as in the static renderers.
fn dash(dash: Dash, width: f64) -> String {
    let lengths: Vec<String> = dash.lengths(width).iter().map(|l| format!("{l:.1}px")).collect();
    if lengths.is_empty() { "solid".to_owned() } else { lengths.join(",") }
}
