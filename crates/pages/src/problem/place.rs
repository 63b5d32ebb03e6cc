//! Points, directions, and how large symbols are.

use soilctl_figure::Size;
use soilctl_limit_analysis::results::Point;

use crate::PageError;

/// Width of a drawing, what axes, title and margins take of it, and the height of a row of the legend, in px.
const WIDTH: f64 = 900.0;
const AROUND: [f64; 2] = [100.0, 110.0];
const ROW: f64 = 19.0;
/// Least and greatest height.
const HEIGHTS: [f64; 2] = [320.0, 900.0];
/// Room for symbols on both sides together, in px.
const SYMBOLS: f64 = 110.0;

/// How long a px is in the units of the axes, about.
pub(super) struct Scale {
    px: f64,
    pub(super) low: Point,
    pub(super) high: Point,
}

impl Scale {
    /// For soil with these corners.
    pub(super) fn new<'a>(corners: impl Iterator<Item = &'a Point>) -> Self {
        let [low, high] = corners.fold([[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]], |[low, high], p| {
            [[0, 1].map(|i| low[i].min(p[i])), [0, 1].map(|i| high[i].max(p[i]))]
        });
        let room = [WIDTH - AROUND[0] - SYMBOLS, HEIGHTS[1] - AROUND[1] - SYMBOLS - 4.0 * ROW];
        let px = [0, 1].map(|i| (high[i] - low[i]) / room[i]);
        Self { px: px[0].max(px[1]), low, high }
    }

    /// So many px in the units of the axes.
    pub(super) fn px(&self, count: f64) -> f64 {
        count * self.px
    }

    /// The page, with a legend of so many entries.
    pub(super) fn size(&self, entries: usize) -> Result<Size, PageError> {
        let height = (self.high[1] - self.low[1]) / self.px
            + SYMBOLS
            + AROUND[1]
            + ROW * (entries as f64 / 2.0).ceil();
        Ok(Size::new(WIDTH as u32, height.clamp(HEIGHTS[0], HEIGHTS[1]) as u32)?)
    }
}

/// A point as figures have it.
pub(super) fn data(p: Point) -> (f64, f64) {
    p.into()
}

/// Points as figures have them.
pub(super) fn ring(points: &[Point]) -> Vec<(f64, f64)> {
    points.iter().map(|p| data(*p)).collect()
}

/// `a + s b`.
pub(super) fn add(a: Point, s: f64, b: Point) -> Point {
    [a[0] + s * b[0], a[1] + s * b[1]]
}

/// The point a part of the way from `a` to `b`.
pub(super) fn between([a, b]: [Point; 2], part: f64) -> Point {
    add(a, part, [b[0] - a[0], b[1] - a[1]])
}

/// The mean of some points.
pub(super) fn middle(points: &[Point]) -> Point {
    let sum = points.iter().fold([0.0; 2], |sum, p| add(sum, 1.0, *p));
    sum.map(|x| x / points.len().max(1) as f64)
}

/// Length, direction, and the direction out of the soil, of a side walked with the soil on the left.
pub(super) fn along([a, b]: [Point; 2]) -> (f64, Point, Point) {
    let (x, y) = (b[0] - a[0], b[1] - a[1]);
    let length = x.hypot(y);
    let t = if length > 0.0 { [x / length, y / length] } else { [1.0, 0.0] };
    (length, t, [t[1], -t[0]])
}

/// Parts of the way along a side at which symbols stand that are about so far apart: at least `least` of them.
pub(super) fn stations(length: f64, apart: f64, least: usize) -> Vec<f64> {
    // A side may be longer than a drawing can show anything of.
    let count = ((length / apart).round().min(400.0) as usize).max(least);
    (0..count).map(|i| (i as f64 + 0.5) / count as f64).collect()
}
