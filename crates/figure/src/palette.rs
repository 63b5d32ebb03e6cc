//! Colours, dashes, markers and hatches that stay apart for every reader.
//!
//! The colours are those of Okabe and Ito, which are distinct under the common colour vision
//! deficiencies. Each palette index also has a dash, a marker and a hatch of its own, so that a
//! figure can be read without colour.

use serde::Serialize;

/// A colour as red, green and blue.
pub(crate) type Rgb = (u8, u8, u8);

/// Dark and light ink that carries titles and axes.
pub(crate) const INK: Rgb = (0x1f, 0x23, 0x28);
/// Spans and reference lines without a colour of their own.
pub(crate) const NEUTRAL: Rgb = (0x5a, 0x62, 0x6b);
/// Grid lines.
pub(crate) const GRID: Rgb = (0xdf, 0xe3, 0xe8);
/// Background.
pub(crate) const PAPER: Rgb = (0xff, 0xff, 0xff);
/// Opacity of bands, polygons and spans.
pub(crate) const FILL_ALPHA: f64 = 0.22;

/// Yellow comes last, because it is weak on white.
const SERIES: [Rgb; 8] = [
    (0x00, 0x72, 0xb2),
    (0xd5, 0x5e, 0x00),
    (0x00, 0x9e, 0x73),
    (0xcc, 0x79, 0xa7),
    (0xe6, 0x9f, 0x00),
    (0x56, 0xb4, 0xe9),
    (0x00, 0x00, 0x00),
    (0xf0, 0xe4, 0x42),
];

/// A colour as SVG, plotly.js and the page script read it.
pub(crate) fn hex((r, g, b): Rgb) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// The colour of a palette index; indices wrap around.
pub(crate) fn series(index: usize) -> Rgb {
    SERIES[index % SERIES.len()]
}

/// Colours of a scale from nothing to much, from light to dark so that it can be read without colour.
const SCALE: [Rgb; 6] = [
    (0xff, 0xff, 0xff),
    (0xfd, 0xe3, 0xa7),
    (0xf9, 0xb2, 0x5c),
    (0xe8, 0x6f, 0x33),
    (0xb3, 0x2b, 0x24),
    (0x55, 0x0b, 0x1d),
];

/// The colour of a part, from 0 to 1, of the way along the scale.
pub(crate) fn shade(part: f64) -> Rgb {
    let place = part.clamp(0.0, 1.0) * (SCALE.len() - 1) as f64;
    let first = (place as usize).min(SCALE.len() - 2);
    let (a, b, s) = (SCALE[first], SCALE[first + 1], place - first as f64);
    let mix = |a: u8, b: u8| (f64::from(a) + s * (f64::from(b) - f64::from(a))).round() as u8;
    (mix(a.0, b.0), mix(a.1, b.1), mix(a.2, b.2))
}

/// Dash pattern of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Dash {
    /// Unbroken.
    Solid,
    /// Medium dashes.
    Dash,
    /// Dots.
    Dot,
    /// Dashes and dots in turn.
    DashDot,
    /// Long dashes.
    LongDash,
    /// One dash and two dots in turn.
    DashDotDot,
    /// Long dashes and dots in turn.
    LongDashDot,
    /// Dots far apart.
    LooseDot,
}

impl Dash {
    /// The pattern that goes with a palette index.
    pub(crate) fn of(index: usize) -> Self {
        const IN_ORDER: [Dash; 8] = [
            Dash::Solid,
            Dash::Dash,
            Dash::Dot,
            Dash::DashDot,
            Dash::LongDash,
            Dash::DashDotDot,
            Dash::LongDashDot,
            Dash::LooseDot,
        ];
        IN_ORDER[index % IN_ORDER.len()]
    }

    /// Lengths drawn and skipped in turn along a line of the given width, all in px; empty for an unbroken line.
    pub(crate) fn lengths(self, width: f64) -> Vec<f64> {
        let in_widths: &[f64] = match self {
            Self::Solid => &[],
            Self::Dash => &[4.0, 2.0],
            Self::Dot => &[1.2, 1.6],
            Self::DashDot => &[4.5, 1.8, 1.2, 1.8],
            Self::LongDash => &[8.0, 2.5],
            Self::DashDotDot => &[4.5, 1.6, 1.2, 1.6, 1.2, 1.6],
            Self::LongDashDot => &[8.0, 2.0, 1.2, 2.0],
            Self::LooseDot => &[1.2, 3.6],
        };
        in_widths.iter().map(|length| (length * width).max(0.5)).collect()
    }
}

/// Shape of a point.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Marker {
    /// A filled circle.
    Circle,
    /// A filled square.
    Square,
    /// A filled triangle.
    Triangle,
    /// A filled diamond.
    Diamond,
    /// Two crossing strokes.
    Cross,
}

impl Marker {
    /// The shape that goes with a palette index.
    pub(crate) fn of(index: usize) -> Self {
        [Self::Circle, Self::Square, Self::Triangle, Self::Diamond, Self::Cross][index % 5]
    }
}

/// Lines across an area, by palette index.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Hatch(usize);

impl Hatch {
    /// The hatch that goes with a palette index.
    pub(crate) fn of(index: usize) -> Self {
        Self(index % 8)
    }

    /// Name of the plotly.js fill pattern; empty for a plain fill.
    pub(crate) fn name(self) -> &'static str {
        ["", "/", "\\", "x", "-", "|", "+", "."][self.0]
    }

    /// Its place among all hatches.
    pub(crate) fn number(self) -> usize {
        self.0
    }

    /// Side of the square it repeats in px, and the lines in that square as SVG path data; none for a plain fill.
    ///
    /// Sides are whole, so that the squares fall onto pixels.
    pub(crate) fn tile(self) -> Option<(u8, &'static str)> {
        match self.name() {
            "/" => Some((12, "M-3 3 3 -3M-3 15 15 -3M9 15 15 9")),
            "\\" => Some((12, "M-3 9 3 15M-3 -3 15 15M9 -3 15 3")),
            "x" => Some((12, "M-3 3 3 -3M-3 15 15 -3M9 15 15 9M-3 9 3 15M-3 -3 15 15M9 -3 15 3")),
            "-" => Some((9, "M0 4.5H9")),
            "|" => Some((9, "M4.5 0V9")),
            "+" => Some((9, "M0 4.5H9M4.5 0V9")),
            "." => Some((9, "M3.75 4.5H5.25")),
            _ => None,
        }
    }
}

/// A colour that is nearer to paper, for what lies over a fill.
pub(crate) fn faint(color: Rgb) -> Rgb {
    let mix = |a: u8, b: u8| u8::midpoint(a, b);
    (mix(color.0, PAPER.0), mix(color.1, PAPER.1), mix(color.2, PAPER.2))
}
