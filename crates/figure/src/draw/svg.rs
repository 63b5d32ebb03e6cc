//! The one writer of SVG: a page that shapes and words are added to.

use super::fonts;
use super::px::{Px, rounded};
use super::words::{Label, Words};
use crate::escape;
use crate::model::Size;
use crate::palette::{Dash, Hatch, PAPER, Rgb, faint, hex, series};

/// How a line is drawn.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pen {
    /// In px.
    pub(crate) width: f64,
    pub(crate) color: Rgb,
    pub(crate) dash: Dash,
}

impl Pen {
    pub(crate) fn solid(width: f64, color: Rgb) -> Self {
        Self { width, color, dash: Dash::Solid }
    }
}

/// A document under construction.
#[derive(Debug)]
pub(crate) struct Svg {
    out: String,
    words: Words,
    /// Goes before names of patterns, which must differ between the pictures of one HTML page.
    prefix: String,
    /// Hatches whose patterns are written.
    patterns: Vec<Hatch>,
}

impl Svg {
    /// An empty page.
    pub(crate) fn new(size: Size, title: &str, words: Words, prefix: &str) -> Self {
        let (width, height) = (size.width(), size.height());
        let (family, paper, title) = (fonts::FAMILY, hex(PAPER), escape::html(title));
        let mut svg = Self { out: String::new(), words, prefix: prefix.to_owned(), patterns: Vec::new() };
        svg.line(&format!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}""#
        ));
        svg.line(&format!(r#"role="img" font-family="{family}" fill="none" stroke-linejoin="round">"#));
        svg.line(&format!("<title>{title}</title>"));
        svg.line(&format!(r#"<rect width="{width}" height="{height}" fill="{paper}"/>"#));
        svg
    }

    /// The whole document.
    pub(crate) fn finish(mut self) -> String {
        self.line("</svg>");
        self.out
    }

    /// Draws something that counts its px from `corner`.
    pub(crate) fn moved<T>(&mut self, corner: Px, draw: impl FnOnce(&mut Self) -> T) -> T {
        self.line(&format!(r#"<g transform="translate({} {})">"#, corner.0, corner.1));
        let drawn = draw(self);
        self.line("</g>");
        drawn
    }

    /// Lines; those that end where they begin are closed.
    pub(crate) fn stroke(&mut self, lines: &[Vec<Px>], pen: Pen) {
        let (color, width) = (hex(pen.color), rounded(pen.width));
        let lengths: Vec<String> =
            pen.dash.lengths(pen.width).into_iter().map(|length| rounded(length).to_string()).collect();
        let dashes = match &lengths[..] {
            [] => String::new(),
            lengths => format!(r#" stroke-dasharray="{}""#, lengths.join(" ")),
        };
        self.path(lines, &format!(r#"stroke="{color}" stroke-width="{width}"{dashes}"#));
    }

    /// Rings filled by the non-zero rule; `alpha` is their opacity, from 0 to 1.
    pub(crate) fn fill(&mut self, rings: &[Vec<Px>], color: Rgb, alpha: f64) {
        let color = hex(color);
        let opacity = if alpha < 1.0 { format!(r#" fill-opacity="{alpha}""#) } else { String::new() };
        self.path(&closed(rings), &format!(r#"fill="{color}"{opacity}"#));
    }

    /// The hatch of a palette index across rings. It lies on one grid for the whole page, so lines of neighbours meet.
    pub(crate) fn hatch(&mut self, rings: &[Vec<Px>], index: usize) {
        let hatch = Hatch::of(index);
        let Some((side, lines)) = hatch.tile() else { return };
        let id = format!("{}hatch-{}", self.prefix, hatch.number());
        if !self.patterns.contains(&hatch) {
            self.patterns.push(hatch);
            let color = hex(faint(series(index)));
            self.line(&format!(
                r#"<pattern id="{id}" width="{side}" height="{side}" patternUnits="userSpaceOnUse">"#
            ));
            self.line(&format!(r#"<path d="{lines}" stroke="{color}" stroke-width="0.9"/>"#));
            self.line("</pattern>");
        }
        self.path(&closed(rings), &format!(r#"fill="url(#{id})""#));
    }

    /// A ring with a rim of paper, which keeps it apart from what it overlaps.
    pub(crate) fn patch(&mut self, ring: &[Px], color: Rgb, rim: f64) {
        let (color, paper) = (hex(color), hex(PAPER));
        let style = format!(r#"fill="{color}" stroke="{paper}" stroke-width="{rim}""#);
        self.path(&closed(&[ring.to_vec()]), &style);
    }

    /// A disc with a rim of paper.
    pub(crate) fn disc(&mut self, center: Px, radius: f64, color: Rgb, rim: f64) {
        let (x, y, r) = (rounded(center.0), rounded(center.1), rounded(radius));
        let (color, paper) = (hex(color), hex(PAPER));
        self.line(&format!(
            r#"<circle cx="{x}" cy="{y}" r="{r}" fill="{color}" stroke="{paper}" stroke-width="{rim}"/>"#
        ));
    }

    /// A line of text.
    pub(crate) fn label(&mut self, label: &Label) {
        let element = label.element(self.words);
        self.line(&element);
    }

    /// A path of all lines together, unless nothing of them is left.
    fn path(&mut self, lines: &[Vec<Px>], style: &str) {
        let mut steps = String::new();
        for line in lines {
            let mut points: Vec<Px> = line.iter().map(|p| (rounded(p.0), rounded(p.1))).collect();
            points.dedup();
            let ends_where_it_began = points.len() > 2 && points.first() == points.last();
            if ends_where_it_began {
                points.pop();
            }
            if points.len() < 2 {
                continue;
            }
            for (i, (x, y)) in points.iter().enumerate() {
                let before = if i == 0 { "M" } else { " " };
                steps += &format!("{before}{x} {y}");
            }
            steps += if ends_where_it_began { "Z" } else { "" };
        }
        if !steps.is_empty() {
            self.line(&format!(r#"<path d="{steps}" {style}/>"#));
        }
    }

    fn line(&mut self, element: &str) {
        self.out += element;
        self.out.push('\n');
    }
}

/// Rings as lines that end where they begin.
fn closed(rings: &[Vec<Px>]) -> Vec<Vec<Px>> {
    rings.iter().map(|ring| ring.iter().chain(ring.first()).copied().collect()).collect()
}
