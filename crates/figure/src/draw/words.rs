//! Lines of text on a page.

use super::fonts;
use super::px::{Px, rounded};
use crate::escape;
use crate::palette::{INK, Rgb, hex};

/// What words become.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Words {
    /// Text, which can be searched and selected; who shows it needs the font or one of the same widths.
    Text,
    /// Outlines of the embedded font, which are the same wherever they are drawn.
    Outlines,
}

/// Which point of a text its position refers to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Anchor {
    Start,
    Middle,
    End,
}

/// A line of text; `at` lies on its baseline.
#[derive(Debug, Clone)]
pub(crate) struct Label {
    pub(crate) text: String,
    pub(crate) at: Px,
    pub(crate) anchor: Anchor,
    /// Font size in px.
    pub(crate) em: f64,
    pub(crate) bold: bool,
    /// Reading upwards instead of to the right.
    pub(crate) upwards: bool,
    pub(crate) color: Rgb,
}

impl Label {
    pub(crate) fn new(text: impl AsRef<str>, at: Px, anchor: Anchor, em: f64) -> Self {
        let text = escape::printable(text.as_ref());
        Self { text, at, anchor, em, bold: false, upwards: false, color: INK }
    }

    /// The label as an element of SVG.
    pub(crate) fn element(&self, words: Words) -> String {
        let turn = if self.upwards { " rotate(-90)" } else { "" };
        let place = format!("translate({} {}){turn}", rounded(self.at.0), rounded(self.at.1));
        match words {
            Words::Text => self.text(&place),
            Words::Outlines => self.outlines(&place),
        }
    }

    fn text(&self, place: &str) -> String {
        let anchor = match self.anchor {
            Anchor::Start => "",
            Anchor::Middle => r#" text-anchor="middle""#,
            Anchor::End => r#" text-anchor="end""#,
        };
        let weight = if self.bold { r#" font-weight="bold""# } else { "" };
        let (em, fill, text) = (self.em, hex(self.color), escape::html(&self.text));
        format!(r#"<text transform="{place}" font-size="{em}"{weight}{anchor} fill="{fill}">{text}</text>"#)
    }

    fn outlines(&self, place: &str) -> String {
        let before = match self.anchor {
            Anchor::Start => 0.0,
            Anchor::Middle => 0.5,
            Anchor::End => 1.0,
        };
        let left = rounded(-before * fonts::width(&self.text, self.em, self.bold));
        let (outline, units_per_em) = fonts::outline(&self.text, self.bold);
        let (scale, fill) = (self.em / units_per_em, hex(self.color));
        // Fonts count upwards.
        let down = -scale;
        format!(
            r#"<path transform="{place} translate({left}) scale({scale} {down})" d="{outline}" fill="{fill}"/>"#
        )
    }
}
