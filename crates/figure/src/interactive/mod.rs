//! Figures as plotly.js input.

mod fields;
mod layout;
mod motion;
mod trace;
mod traces;

pub(crate) use fields::colors as shades;
pub(crate) use motion::to_json as motion_to_json;
use serde_json::{Value, json};

use crate::model::Figure;

/// The `data` and `layout` of a figure.
pub(crate) fn to_json(figure: &Figure) -> Value {
    json!({ "data": traces::of(figure), "layout": layout::of(figure) })
}
