//! The legend, in an area of its own below or beside the plot.

use super::areas;
use super::axes::DROP;
use super::clip::Rect;
use super::fonts::{fit, width};
use super::frame::{Frame, PAD, TICK_EM};
use super::layers::{line_pen, ref_pen};
use super::points::{BAR_WIDTH, MARKER, draw_marker};
use super::svg::{Pen, Svg};
use super::words::{Anchor, Label};
use crate::model::{Band, Figure, Layer, Legend, Polygons};
use crate::palette::{FILL_ALPHA, Marker, NEUTRAL, series};

const SAMPLE: f64 = 34.0;
const GAP: f64 = 8.0;
const BETWEEN: f64 = 20.0;
const ROW: f64 = 19.0;

/// How many entries are shown and where.
#[derive(Debug)]
pub(crate) struct Plan {
    pub(crate) width: f64,
    pub(crate) height: f64,
    columns: usize,
    column_width: f64,
    shown: usize,
    left_out: usize,
}

impl Plan {
    /// Plans the legend of a figure; `room` is the height of the page below the title.
    pub(crate) fn new(figure: &Figure, page_width: f64, room: f64) -> Option<Self> {
        let names: Vec<&str> = figure.layers.iter().filter(|l| l.in_legend()).map(Layer::name).collect();
        if figure.legend == Legend::Hidden || names.is_empty() {
            return None;
        }
        let widest = names.iter().map(|name| width(name, TICK_EM, false)).fold(0.0, f64::max);
        let plan = Self::with_entries(figure.legend, names.len(), widest, page_width, room);
        if plan.left_out == 0 {
            return Some(plan);
        }
        // The line that counts the others needs its room, too.
        let widest = widest.max(width(&others(names.len()), TICK_EM, false));
        Some(Self::with_entries(figure.legend, names.len(), widest, page_width, room))
    }

    fn with_entries(legend: Legend, entries: usize, widest: f64, page_width: f64, room: f64) -> Self {
        let beside = legend == Legend::Right;
        let (available, gap) =
            if beside { (page_width * 0.4, 0.0) } else { (page_width - 2.0 * PAD, BETWEEN) };
        let column_width = (SAMPLE + GAP + widest + gap).min(available);
        let columns = if beside { 1 } else { ((available / column_width) as usize).clamp(1, entries) };
        // The plot keeps the larger part of the page; entries beyond that are counted instead.
        let space = if beside { room - PAD } else { room * 0.38 };
        let most_rows = (space / ROW).max(2.0) as usize;
        let capacity = columns * most_rows;
        let shown = if entries <= capacity { entries } else { capacity - 1 };
        let left_out = entries - shown;
        let rows = (shown + usize::from(left_out > 0)).div_ceil(columns);
        let (width, height) = (column_width * columns as f64, ROW * rows as f64);
        Self { width, height, columns, column_width, shown, left_out }
    }
}

/// The line that stands for entries that are not shown.
fn others(count: usize) -> String {
    format!("… and {count} more")
}

/// Draws the legend as planned.
pub(crate) fn draw(figure: &Figure, plan: &Plan, frame: &Frame, svg: &mut Svg) {
    let (left, top) = match figure.legend {
        Legend::Right => (frame.page_width - PAD - plan.width, frame.plot.top),
        Legend::Below | Legend::Hidden => {
            ((frame.page_width - plan.width + BETWEEN) / 2.0, frame.page_height - PAD - plan.height)
        }
    };
    let place = |i: usize| {
        let (row, column) = (i / plan.columns, i % plan.columns);
        (left + column as f64 * plan.column_width, top + (row as f64 + 0.5) * ROW)
    };
    let room = plan.column_width - SAMPLE - GAP;
    let entry = |i: usize, text: &str, svg: &mut Svg| {
        let (x, middle) = place(i);
        let at = (x + SAMPLE + GAP, middle + TICK_EM * DROP);
        svg.label(&Label::new(fit(text, TICK_EM, false, room), at, Anchor::Start, TICK_EM));
    };
    for (i, layer) in figure.layers.iter().filter(|l| l.in_legend()).take(plan.shown).enumerate() {
        entry(i, layer.name(), svg);
        draw_sample(layer, place(i), svg);
    }
    if plan.left_out > 0 {
        entry(plan.shown, &others(plan.left_out), svg);
    }
}

/// A sample of how the layer looks.
fn draw_sample(layer: &Layer, (left, middle): (f64, f64), svg: &mut Svg) {
    let line = [vec![(left, middle), (left + SAMPLE, middle)]];
    let thin = |pen: Pen| Pen { width: pen.width.min(6.0), ..pen };
    let swatch = Rect { left, top: middle - 6.0, right: left + SAMPLE, bottom: middle + 6.0 };
    match layer {
        Layer::Line(l) => svg.stroke(&line, thin(line_pen(l))),
        Layer::RefLine(l) => svg.stroke(&line, ref_pen(l)),
        Layer::Paths(p) => {
            let color = p.color.map_or(NEUTRAL, series);
            svg.stroke(&line, thin(Pen::solid(p.width, color)));
            if p.arrows {
                let (tip, half) = (left + SAMPLE, 2.0 + p.width.min(3.0));
                let back = tip - 3.0 * half;
                svg.fill(&[vec![(back, middle - half), (tip, middle), (back, middle + half)]], color, 1.0);
            }
        }
        Layer::Points(p) => {
            let index = p.color.unwrap_or_default();
            let (center, color) = (left + SAMPLE / 2.0, series(index));
            if p.y_error.is_some() {
                let reach = MARKER + 4.0;
                let bar = vec![(center, middle - reach), (center, middle + reach)];
                svg.stroke(&[bar], Pen::solid(BAR_WIDTH, color));
            }
            draw_marker(p.marker.unwrap_or_else(|| Marker::of(index)), (center, middle), color, svg);
        }
        Layer::Band(Band { color, .. }) | Layer::Polygons(Polygons { color, .. }) => {
            areas::fill(&[swatch.ring()], *color, svg);
            svg.stroke(&[swatch.outline()], areas::edge(*color));
        }
        Layer::Span(s) => {
            svg.fill(&[swatch.ring()], s.color.map_or(NEUTRAL, series), FILL_ALPHA);
            svg.stroke(&[swatch.outline()], areas::edge(s.color));
        }
        Layer::Shades(_) | Layer::Text(_) => {}
    }
}
