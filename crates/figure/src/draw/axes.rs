//! Title, grid, ticks and axis labels.

use super::fonts::{fit, width};
use super::frame::{Frame, LABEL_EM, PAD, TICK_EM, TICK_GAP, crisp};
use super::px::Px;
use super::svg::{Pen, Svg};
use super::words::{Anchor, Label};
use crate::model::Figure;
use crate::palette::{GRID, INK};

pub(crate) const TITLE_EM: f64 = 15.0;
pub(crate) const TITLE_STEP: f64 = 20.0;
/// Length of a tick's mark.
pub(crate) const MARK: f64 = 4.0;
/// From the middle of a line of text down to its baseline, in em.
pub(crate) const DROP: f64 = 0.36;

/// Everything that lies beneath the data.
pub(crate) fn draw(figure: &Figure, title: &[String], frame: &Frame, svg: &mut Svg) {
    let plot = &frame.plot;
    draw_grid(frame, svg);
    for (i, line) in title.iter().enumerate() {
        let at = (frame.page_width / 2.0, PAD + TITLE_EM * 0.8 + i as f64 * TITLE_STEP);
        svg.label(&Label { bold: true, ..Label::new(line, at, Anchor::Middle, TITLE_EM) });
    }
    for tick in &frame.x_ticks.major {
        let at = (frame.x(tick.value), plot.bottom + TICK_GAP + TICK_EM * 0.8);
        svg.label(&Label::new(&tick.label, at, Anchor::Middle, TICK_EM));
    }
    for tick in &frame.y_ticks.major {
        let at = (plot.left - TICK_GAP, frame.y(tick.value) + TICK_EM * DROP);
        svg.label(&Label::new(&tick.label, at, Anchor::End, TICK_EM));
    }
    if !figure.x.label.is_empty() {
        let text = fit(&figure.x.label, LABEL_EM, false, plot.width() + plot.left - PAD);
        let at = ((plot.left + plot.right) / 2.0, plot.bottom + TICK_GAP + TICK_EM + 7.0 + LABEL_EM * 0.8);
        svg.label(&Label::new(text, at, Anchor::Middle, LABEL_EM));
    }
    if !figure.y.label.is_empty() {
        let text = fit(&figure.y.label, LABEL_EM, false, frame.page_height - 2.0 * PAD);
        let half = width(&text, LABEL_EM, false) / 2.0;
        // Centred on the plot area, but moved as needed to stay on the page.
        let middle = ((plot.top + plot.bottom) / 2.0).max(half + PAD).min(frame.page_height - PAD - half);
        let at = (PAD + LABEL_EM * 0.8, middle);
        svg.label(&Label { upwards: true, ..Label::new(text, at, Anchor::Middle, LABEL_EM) });
    }
}

fn draw_grid(frame: &Frame, svg: &mut Svg) {
    let plot = &frame.plot;
    let minor = frame.x_ticks.minor.iter().map(|&value| upright(frame, value, plot.top, plot.bottom));
    let minor =
        minor.chain(frame.y_ticks.minor.iter().map(|&value| level(frame, value, plot.left, plot.right)));
    svg.stroke(&minor.collect::<Vec<_>>(), Pen::solid(0.5, GRID));
    let major = frame.x_ticks.major.iter().map(|tick| upright(frame, tick.value, plot.top, plot.bottom));
    let major =
        major.chain(frame.y_ticks.major.iter().map(|tick| level(frame, tick.value, plot.left, plot.right)));
    svg.stroke(&major.collect::<Vec<_>>(), Pen::solid(1.0, GRID));
}

/// The border of the plot area with its tick marks, above the data.
pub(crate) fn draw_border(frame: &Frame, svg: &mut Svg) {
    let plot = &frame.plot;
    let (below, before) = (plot.bottom + MARK, plot.left - MARK);
    let marks = frame.x_ticks.major.iter().map(|tick| upright(frame, tick.value, plot.bottom, below));
    let marks =
        marks.chain(frame.y_ticks.major.iter().map(|tick| level(frame, tick.value, before, plot.left)));
    let lines: Vec<Vec<Px>> = std::iter::once(plot.outline()).chain(marks).collect();
    svg.stroke(&lines, Pen::solid(1.0, INK));
}

/// A line at an x value.
fn upright(frame: &Frame, value: f64, from: f64, to: f64) -> Vec<Px> {
    let x = crisp(frame.x(value));
    vec![(x, from), (x, to)]
}

/// A line at a y value.
fn level(frame: &Frame, value: f64, from: f64, to: f64) -> Vec<Px> {
    let y = crisp(frame.y(value));
    vec![(from, y), (to, y)]
}
