//! Colour bars of maps of a value.

use super::axes::{DROP, MARK};
use super::clip::Rect;
use super::fonts::{fit, width};
use super::frame::{Frame, LABEL_EM, PAD, TICK_EM, TICK_GAP, crisp};
use super::svg::{Pen, Svg};
use super::ticks::ticks;
use super::words::{Anchor, Label};
use crate::model::{Figure, Layer, STEPS, Scale, Shades};
use crate::palette::{INK, shade};

/// Width of a colour bar, and its distance from the plot.
const BAR: f64 = 14.0;
const GAP: f64 = 14.0;

fn bars(figure: &Figure) -> impl Iterator<Item = &Shades> {
    figure.layers.iter().filter_map(|layer| match layer {
        Layer::Shades(shades) if shades.bar => Some(shades),
        _ => None,
    })
}

fn labels(shades: &Shades, height: f64) -> Vec<(f64, String)> {
    let rows = (height / 45.0).clamp(2.0, 10.0) as usize;
    ticks(Scale::Linear, shades.range, rows).major.into_iter().map(|t| (t.value, t.label)).collect()
}

/// Room that a colour bar takes with its labels.
fn room(shades: &Shades) -> f64 {
    // Labels hardly depend on the height.
    let widest = labels(shades, 300.0).iter().map(|(_, l)| width(l, TICK_EM, false)).fold(8.0, f64::max);
    GAP + BAR + TICK_GAP + widest + 8.0 + LABEL_EM
}

/// Room beside the plot for all colour bars.
pub(crate) fn beside(figure: &Figure) -> f64 {
    bars(figure).map(room).sum()
}

/// Draws the colour bars, from the plot outwards.
pub(crate) fn draw(figure: &Figure, frame: &Frame, svg: &mut Svg) {
    let plot = &frame.plot;
    let mut left = plot.right;
    for shades in bars(figure) {
        let bar = Rect { left: crisp(left + GAP), right: crisp(left + GAP + BAR), ..*plot };
        let at = |part: f64| bar.bottom - part * bar.height();
        for step in 1..STEPS {
            let above = Rect { bottom: at(step as f64 / STEPS as f64), ..bar };
            svg.fill(&[above.ring()], shade(step as f64 / (STEPS - 1) as f64), 1.0);
        }
        let mut lines = vec![bar.outline()];
        let (low, high) = shades.range;
        for (value, label) in labels(shades, bar.height()) {
            let y = at((value - low) / (high - low));
            lines.push(vec![(bar.right, crisp(y)), (bar.right + MARK, crisp(y))]);
            let place = (bar.right + TICK_GAP, y + TICK_EM * DROP);
            svg.label(&Label::new(label, place, Anchor::Start, TICK_EM));
        }
        svg.stroke(&lines, Pen::solid(1.0, INK));
        left += room(shades);
        let middle = (bar.top + bar.bottom) / 2.0;
        let place = ((left - 2.0).min(frame.page_width - PAD / 2.0), middle);
        let name = fit(&shades.name, LABEL_EM, false, bar.height());
        svg.label(&Label { upwards: true, ..Label::new(name, place, Anchor::Middle, LABEL_EM) });
    }
}
