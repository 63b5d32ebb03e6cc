//! Static rendering: a figure is written as an SVG document, and PNG files are drawn from that.

mod areas;
mod axes;
mod bars;
mod clip;
mod fonts;
mod frame;
mod grid;
mod layers;
mod legend;
mod paths;
mod png;
mod points;
mod px;
mod svg;
mod ticks;
mod words;

pub(crate) use frame::Frame;
pub use grid::FigureGrid;
pub(crate) use layers::REF_WIDTH;

use crate::error::FigureError;
use crate::model::{Figure, Legend, Size};
use frame::{Margins, PAD};
use svg::Svg;
use words::Words;

/// A figure as an SVG document; `prefix` must differ between the pictures of one HTML page.
pub(crate) fn to_svg(figure: &Figure, size: Size, prefix: &str) -> Result<String, FigureError> {
    document(figure, size, Words::Text, prefix)
}

/// A figure as a PNG file.
pub(crate) fn to_png(figure: &Figure, size: Size) -> Result<Vec<u8>, FigureError> {
    png::render(&document(figure, size, Words::Outlines, "")?, size)
}

fn document(figure: &Figure, size: Size, words: Words, prefix: &str) -> Result<String, FigureError> {
    let mut svg = Svg::new(size, &figure.title, words, prefix);
    draw_figure(figure, size, &mut svg)?;
    Ok(svg.finish())
}

/// The axes of a figure without its layers, and where things go between them.
pub(crate) fn axes_of(figure: &Figure, size: Size) -> Result<(String, Frame), FigureError> {
    let mut svg = Svg::new(size, &figure.title, Words::Text, "");
    let Layout { title, frame, .. } = Layout::new(figure, size)?;
    axes::draw(figure, &title, &frame, &mut svg);
    axes::draw_border(&frame, &mut svg);
    Ok((svg.finish(), frame))
}

/// Draws a figure at the upper left corner of a document.
fn draw_figure(figure: &Figure, size: Size, svg: &mut Svg) -> Result<(), FigureError> {
    if figure.layers.is_empty() {
        return Err(FigureError::EmptyFigure { title: figure.title.clone() });
    }
    let Layout { title, frame, legend } = Layout::new(figure, size)?;
    axes::draw(figure, &title, &frame, svg);
    layers::draw(figure, &frame, svg);
    axes::draw_border(&frame, svg);
    bars::draw(figure, &frame, svg);
    if let Some(plan) = legend {
        legend::draw(figure, &plan, &frame, svg);
    }
    Ok(())
}

/// Where everything goes on a page.
struct Layout {
    /// The lines of the title.
    title: Vec<String>,
    frame: Frame,
    legend: Option<legend::Plan>,
}

impl Layout {
    fn new(figure: &Figure, size: Size) -> Result<Self, FigureError> {
        fonts::check()?;
        let (width, height) = (f64::from(size.width()), f64::from(size.height()));
        let title = fonts::wrap(&figure.title, axes::TITLE_EM, true, width - 2.0 * PAD, 3);
        let top = match title.len() {
            0 => PAD,
            lines => PAD + lines as f64 * axes::TITLE_STEP + 4.0,
        };
        let legend = legend::Plan::new(figure, width, height - top);
        let (below, beside) = match (&legend, figure.legend) {
            (Some(plan), Legend::Below) => (plan.height + 8.0, 0.0),
            (Some(plan), Legend::Right) => (0.0, plan.width + 14.0),
            (Some(_), Legend::Hidden) | (None, _) => (0.0, 0.0),
        };
        let beside = beside + bars::beside(figure);
        let frame = Frame::new(figure, width, height, Margins { top, below, beside });
        Ok(Self { title, frame, legend })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Axis, Line};

    fn frame(figure: &Figure, width: u32, height: u32) -> Frame {
        Layout::new(figure, Size::new(width, height).unwrap()).unwrap().frame
    }

    #[test]
    fn a_plot_area_remains_on_the_smallest_page() {
        for name in ["w", "a name that is longer than its page is wide, and then some"] {
            let mut figure = Figure::new(name, Axis::linear(name), Axis::linear(name))
                .with_legend(Legend::Right)
                .with_equal_aspect()
                .unwrap();
            figure.push(Line::new(name, [(0.0, -1e-60), (1e100, 1e15)])).unwrap();
            let plot = frame(&figure, 160, 160).plot;
            assert!(plot.width() >= 16.0 && plot.height() >= 16.0, "{plot:?}");
        }
    }

    #[test]
    fn equal_aspect_has_equal_units() {
        let mut figure = Figure::new("t", Axis::linear("x"), Axis::linear("y")).with_equal_aspect().unwrap();
        figure.push(Line::new("l", [(0.0, 0.0), (1.0, 30.0)])).unwrap();
        let frame = frame(&figure, 760, 480);
        let (dx, dy) = (frame.x(1.0) - frame.x(0.0), frame.y(0.0) - frame.y(1.0));
        assert!((dx / dy - 1.0).abs() < 0.02, "{dx} {dy}");
        assert!(frame.plot.contains(frame.at((1.0, 30.0))));
    }
}
