//! Figures in motion as input of the page's own script.

use serde_json::{Value, json};

use crate::draw::Frame;
use crate::model::{DataPoint, Motion, MovingPoint};
use crate::palette::{NEUTRAL, hex, series};

/// Steps a px: places are whole numbers of these, which takes a third of the space.
const STEPS: f64 = 16.0;

/// What areas are painted with on dark paper.
const NIGHT_TONE: &str = "#57462a";

/// What moves, in steps from the left upper corner of the axes, and where on the figure that is, as parts of its size.
/// A point is four numbers: x, y and how far it goes along both.
pub(crate) fn to_json(motion: &Motion, frame: &Frame) -> Value {
    let steps = |px: f64| (STEPS * px).round() as i64;
    let part = |points: &Vec<MovingPoint>| -> Vec<i64> {
        let place = |p: DataPoint| {
            let (x, y) = frame.at(p);
            (x - frame.plot.left, y - frame.plot.top)
        };
        let four = |p: &MovingPoint| {
            let (from, to) = (place(p.at), place((p.at.0 + p.by.0, p.at.1 + p.by.1)));
            [from.0, from.1, to.0 - from.0, to.1 - from.1].map(steps)
        };
        points.iter().flat_map(four).collect()
    };
    let parts = |all: &[Vec<MovingPoint>]| all.iter().map(part).collect::<Vec<_>>();
    let lines = motion.lines.iter().map(|lines| {
        let color = hex(lines.color.map_or(NEUTRAL, series));
        json!({ "width": lines.width, "color": color, "parts": parts(&lines.parts) })
    });
    let plot = &frame.plot;
    json!({
        "left": plot.left / frame.page_width, "top": plot.top / frame.page_height,
        "width": plot.width() / frame.page_width, "height": plot.height() / frame.page_height,
        "steps": [steps(plot.width()), steps(plot.height())],
        "tones": [hex(motion.tone()), NIGHT_TONE], "areas": parts(&motion.areas), "lines": lines.collect::<Vec<_>>(),
    })
}
