//! The plot area of a figure, its ticks and the map from data to px.

use super::clip::{self, Rect};
use super::fonts::width;
use super::px::Px;
use super::ticks::{Ticks, ticks};
use crate::extent::{self, Extent};
use crate::model::{DataPoint, Figure, Orientation, Scale};

pub(crate) const PAD: f64 = 12.0;
pub(crate) const LABEL_EM: f64 = 13.0;
pub(crate) const TICK_EM: f64 = 12.0;
/// Distance between the plot area and its tick labels.
pub(crate) const TICK_GAP: f64 = 7.0;
/// What remains of the plot area on the smallest page, whatever its labels and names.
const SMALLEST: f64 = 16.0;

/// Room for what lies around the plot area and its axes.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Margins {
    /// Down to the plot area.
    pub(crate) top: f64,
    pub(crate) below: f64,
    pub(crate) beside: f64,
}

/// The layout of one figure.
#[derive(Debug)]
pub(crate) struct Frame {
    pub(crate) plot: Rect,
    pub(crate) x_ticks: Ticks,
    pub(crate) y_ticks: Ticks,
    pub(crate) page_width: f64,
    pub(crate) page_height: f64,
    extent: Extent,
    scales: (Scale, Scale),
}

impl Frame {
    pub(crate) fn new(figure: &Figure, page_width: f64, page_height: f64, margins: Margins) -> Self {
        let Margins { top, below, beside } = margins;
        let x_title = if figure.x.label.is_empty() { 0.0 } else { LABEL_EM + 9.0 };
        let left = 64f64.min(page_width * 0.3);
        let plot = Rect {
            left,
            top: crisp(top),
            right: crisp((page_width - PAD - 6.0 - beside).max(left + SMALLEST)),
            bottom: crisp((page_height - PAD - below - x_title - TICK_GAP - TICK_EM).max(top + SMALLEST)),
        };
        let mut frame = Self {
            plot,
            x_ticks: Ticks::default(),
            y_ticks: Ticks::default(),
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
            let left = (PAD + y_title + widest + TICK_GAP)
                .min(self.page_width * 0.45)
                .min(self.plot.right - SMALLEST);
            self.plot.left = crisp(left);
            self.x_ticks = self.spaced_x_ticks(figure.x.scale);
            let overhang = self.x_ticks.major.last().map_or(0.0, |tick| {
                self.x(tick.value) + width(&tick.label, TICK_EM, false) / 2.0 - self.plot.right - PAD
            });
            let right = (self.plot.right - overhang.max(0.0)).max(self.plot.left + SMALLEST);
            self.plot.right = crisp(right).min(right_edge);
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

    /// A line at a value of one axis along all of the other.
    pub(crate) fn across(&self, along: Orientation, value: f64) -> Vec<Px> {
        match along {
            Orientation::Horizontal => {
                vec![(self.plot.left, self.y(value)), (self.plot.right, self.y(value))]
            }
            Orientation::Vertical => vec![(self.x(value), self.plot.bottom), (self.x(value), self.plot.top)],
        }
    }

    /// What of lines is inside of the plot area. They are cut here and not by who shows the picture, since programs count px
    /// in single precision, and data may lie far beyond a fixed range.
    pub(crate) fn cut_lines(&self, lines: impl IntoIterator<Item = Vec<Px>>) -> Vec<Vec<Px>> {
        lines.into_iter().flat_map(|line| clip::polyline(&line, &self.plot)).collect()
    }

    /// What of areas is inside of the plot area.
    pub(crate) fn cut_rings(&self, rings: impl IntoIterator<Item = Vec<Px>>) -> Vec<Vec<Px>> {
        rings.into_iter().map(|ring| clip::ring(&ring, &self.plot)).filter(|ring| ring.len() > 2).collect()
    }
}

/// The middle of a pixel, where a line of 1 px covers whole pixels.
pub(crate) fn crisp(px: f64) -> f64 {
    px.floor() + 0.5
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
