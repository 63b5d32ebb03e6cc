//! Title, grid, ticks and axis labels.

use super::fonts::fit;
use super::frame::{Frame, LABEL_EM, PAD, TICK_EM, TICK_GAP, TITLE_EM, TITLE_STEP};
use super::scene::{Anchor, Label, Scene};
use crate::model::Figure;
use crate::palette::{GRID, INK};

/// Everything that lies beneath the data.
pub(crate) fn draw(figure: &Figure, frame: &Frame, scene: &mut Scene) {
    let plot = &frame.plot;
    draw_grid(frame, scene);
    for (i, line) in frame.title.iter().enumerate() {
        let at = (frame.page_width / 2.0, PAD + TITLE_EM * 0.8 + i as f64 * TITLE_STEP);
        scene.label(Label { bold: true, ..Label::new(line.as_str(), at, Anchor::Middle, TITLE_EM) });
    }
    for tick in &frame.x_ticks.major {
        let at = (frame.x(tick.value), plot.bottom + TICK_GAP + TICK_EM * 0.8);
        scene.label(Label::new(tick.label.as_str(), at, Anchor::Middle, TICK_EM));
    }
    for tick in &frame.y_ticks.major {
        let at = (plot.left - TICK_GAP, frame.y(tick.value) + TICK_EM * 0.36);
        scene.label(Label::new(tick.label.as_str(), at, Anchor::End, TICK_EM));
    }
    if !figure.x.label.is_empty() {
        let text = fit(&figure.x.label, LABEL_EM, false, plot.width() + plot.left - PAD);
        let at = ((plot.left + plot.right) / 2.0, plot.bottom + TICK_GAP + TICK_EM + 7.0 + LABEL_EM * 0.8);
        scene.label(Label::new(text, at, Anchor::Middle, LABEL_EM));
    }
    if !figure.y.label.is_empty() {
        let text = fit(&figure.y.label, LABEL_EM, false, frame.page_height - 2.0 * PAD);
        let half = super::fonts::width(&text, LABEL_EM, false) / 2.0;
        // Centred on the plot area, but moved as needed to stay on the page.
        let middle = ((plot.top + plot.bottom) / 2.0).max(half + PAD).min(frame.page_height - PAD - half);
        let at = (PAD + LABEL_EM * 0.8, middle);
        scene.label(Label { upwards: true, ..Label::new(text, at, Anchor::Middle, LABEL_EM) });
    }
}

fn draw_grid(frame: &Frame, scene: &mut Scene) {
    let plot = &frame.plot;
    let vertical = |value: f64| vec![(frame.x(value), plot.top), (frame.x(value), plot.bottom)];
    let horizontal = |value: f64| vec![(plot.left, frame.y(value)), (plot.right, frame.y(value))];
    for &value in &frame.x_ticks.minor {
        scene.stroke(vertical(value), 0.5, GRID);
    }
    for &value in &frame.y_ticks.minor {
        scene.stroke(horizontal(value), 0.5, GRID);
    }
    for tick in &frame.x_ticks.major {
        scene.stroke(vertical(tick.value), 1.0, GRID);
    }
    for tick in &frame.y_ticks.major {
        scene.stroke(horizontal(tick.value), 1.0, GRID);
    }
}

/// The border of the plot area with its tick marks, above the data.
pub(crate) fn draw_border(frame: &Frame, scene: &mut Scene) {
    const MARK: f64 = 4.0;
    let plot = &frame.plot;
    let mut border = plot.ring();
    border.push(border[0]);
    border.push(border[1]);
    scene.stroke(border, 1.0, INK);
    for tick in &frame.x_ticks.major {
        let x = frame.x(tick.value);
        scene.stroke(vec![(x, plot.bottom), (x, plot.bottom + MARK)], 1.0, INK);
    }
    for tick in &frame.y_ticks.major {
        let y = frame.y(tick.value);
        scene.stroke(vec![(plot.left - MARK, y), (plot.left, y)], 1.0, INK);
    }
}
