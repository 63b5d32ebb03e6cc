//! Where everything goes on a page: margins, the plot area and the map from data to px.

use super::clip::Rect;
use super::fonts::{width, wrap};
use super::legend;
use super::scene::Px;
use super::shades;
use super::ticks::{Ticks, ticks};
use crate::extent::{self, Extent};
use crate::model::{DataPoint, Figure, Legend, Scale};

pub(crate) const PAD: f64 = 12.0;
pub(crate) const TITLE_EM: f64 = 15.0;
pub(crate) const TITLE_STEP: f64 = 20.0;
pub(crate) const LABEL_EM: f64 = 13.0;
pub(crate) const TICK_EM: f64 = 12.0;
/// Distance between the plot area and its tick labels.
pub(crate) const TICK_GAP: f64 = 7.0;
/// What remains of the plot area on the smallest page, whatever its labels and names.
const SMALLEST: f64 = 16.0;

/// The layout of one figure.
#[derive(Debug)]
pub(crate) struct Frame {
    pub(crate) plot: Rect,
    pub(crate) title: Vec<String>,
    pub(crate) x_ticks: Ticks,
    pub(crate) y_ticks: Ticks,
    pub(crate) legend: Option<legend::Plan>,
    pub(crate) page_width: f64,
    pub(crate) page_height: f64,
    extent: Extent,
    scales: (Scale, Scale),
}

impl Frame {
    pub(crate) fn new(figure: &Figure, page_width: f64, page_height: f64) -> Self {
        let title = wrap(&figure.title, TITLE_EM, true, page_width - 2.0 * PAD, 3);
        let top = match title.len() {
            0 => PAD,
            lines => PAD + lines as f64 * TITLE_STEP + 4.0,
        };
        let legend = legend::Plan::new(figure, page_width, page_height - top);
        let below =
            legend.as_ref().filter(|_| figure.legend == Legend::Below).map_or(0.0, |l| l.height + 8.0);
        let beside =
            legend.as_ref().filter(|_| figure.legend == Legend::Right).map_or(0.0, |l| l.width + 14.0);
        let beside = beside + shades::beside(figure);
        let x_title = if figure.x.label.is_empty() { 0.0 } else { LABEL_EM + 9.0 };
        let left = 64f64.min(page_width * 0.3);
        let plot = Rect {
            left,
            top,
            right: (page_width - PAD - 6.0 - beside).max(left + SMALLEST),
            bottom: (page_height - PAD - below - x_title - TICK_GAP - TICK_EM).max(top + SMALLEST),
        };
        let mut frame = Self {
            plot,
            title,
            x_ticks: Ticks::default(),
            y_ticks: Ticks::default(),
            legend,
            page_width,
            page_height,
            extent: extent::of(figure),
            scales: (figure.x.scale, figure.y.scale),
        };
        frame.settle(figure);
        frame
    }

    /// Tick labels need margins, margins change the plot area, and with equal aspect the area
    /// changes the ticks; two rounds settle this to within a px.
    fn settle(&mut self, figure: &Figure) {
        let data = self.extent;
        let right_edge = self.plot.right;
        for _ in 0..2 {
            self.extent = if figure.equal_aspect { with_equal_aspect(data, &self.plot) } else { data };
            let rows = (self.plot.height() / 45.0).clamp(2.0, 10.0) as usize;
            self.y_ticks = ticks(figure.y.scale, self.extent.y, rows);
            let y_title = if figure.y.label.is_empty() { 0.0 } else { LABEL_EM + 9.0 };
            let widest =
                self.y_ticks.major.iter().map(|t| width(&t.label, TICK_EM, false)).fold(8.0, f64::max);
            self.plot.left = (PAD + y_title + widest + TICK_GAP)
                .min(self.page_width * 0.45)
                .min(self.plot.right - SMALLEST);
            self.x_ticks = self.spaced_x_ticks(figure.x.scale);
            let overhang = self.x_ticks.major.last().map_or(0.0, |tick| {
                self.x(tick.value) + width(&tick.label, TICK_EM, false) / 2.0 - self.plot.right - PAD
            });
            self.plot.right =
                (self.plot.right - overhang.max(0.0)).max(self.plot.left + SMALLEST).min(right_edge);
        }
    }

    /// As many x ticks as fit without their labels touching.
    fn spaced_x_ticks(&self, scale: Scale) -> Ticks {
        let most = (self.plot.width() / 65.0).clamp(1.0, 10.0) as usize;
        let fits = |candidate: &Ticks| {
            candidate.major.windows(2).all(|pair| {
                let half = |i: usize| width(&pair[i].label, TICK_EM, false) / 2.0;
                self.x(pair[1].value) - self.x(pair[0].value) > half(0) + half(1) + 9.0
            })
        };
        let candidates = (1..=most).rev().map(|target| ticks(scale, self.extent.x, target));
        let mut fallback = Ticks::default();
        for candidate in candidates {
            if fits(&candidate) {
                return candidate;
            }
            fallback = candidate;
        }
        fallback
    }

    /// Horizontal position of an x value.
    pub(crate) fn x(&self, value: f64) -> f64 {
        self.plot.left + fraction(self.scales.0, self.extent.x, value) * self.plot.width()
    }

    /// Vertical position of a y value.
    pub(crate) fn y(&self, value: f64) -> f64 {
        self.plot.bottom - fraction(self.scales.1, self.extent.y, value) * self.plot.height()
    }

    /// Position of a data point.
    pub(crate) fn at(&self, point: DataPoint) -> Px {
        (self.x(point.0), self.y(point.1))
    }

    /// Positions of data points.
    pub(crate) fn all(&self, points: &[DataPoint]) -> Vec<Px> {
        points.iter().map(|&p| self.at(p)).collect()
    }
}

fn fraction(scale: Scale, (low, high): (f64, f64), value: f64) -> f64 {
    match scale {
        Scale::Linear => (value - low) / (high - low),
        Scale::Log => (value.log10() - low.log10()) / (high.log10() - low.log10()),
    }
}

/// Widens the tighter of both ranges around its centre until units are equally long.
fn with_equal_aspect(extent: Extent, plot: &Rect) -> Extent {
    let per_px = |(low, high): (f64, f64), px: f64| (high - low) / px;
    let unit = per_px(extent.x, plot.width()).max(per_px(extent.y, plot.height()));
    let around = |(low, high): (f64, f64), px: f64| {
        let (center, half) = (low / 2.0 + high / 2.0, unit * px / 2.0);
        (center - half, center + half)
    };
    Extent { x: around(extent.x, plot.width()), y: around(extent.y, plot.height()) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Axis, Line};

    #[test]
    fn a_plot_area_remains_on_the_smallest_page() {
        super::super::fonts::register().unwrap();
        for name in ["w", "a name that is longer than its page is wide, and then some"] {
            let mut figure = Figure::new(name, Axis::linear(name), Axis::linear(name))
                .with_legend(Legend::Right)
                .with_equal_aspect()
                .unwrap();
            figure.push(Line::new(name, [(0.0, -1e-60), (1e100, 1e15)])).unwrap();
            let frame = Frame::new(&figure, 160.0, 160.0);
            assert!(frame.plot.width() >= SMALLEST && frame.plot.height() >= SMALLEST, "{:?}", frame.plot);
        }
    }

    #[test]
    fn equal_aspect_has_equal_units() {
        let mut figure = Figure::new("t", Axis::linear("x"), Axis::linear("y")).with_equal_aspect().unwrap();
        figure.push(Line::new("l", [(0.0, 0.0), (1.0, 30.0)])).unwrap();
        super::super::fonts::register().unwrap();
        let frame = Frame::new(&figure, 760.0, 480.0);
        let (dx, dy) = (frame.x(1.0) - frame.x(0.0), frame.y(0.0) - frame.y(1.0));
        assert!((dx / dy - 1.0).abs() < 0.02, "{dx} {dy}");
        assert!(frame.plot.contains(frame.at((1.0, 30.0))));
    }
}
