//! What is drawn, in px with y downwards, before any backend is involved.

use crate::model::Size;
use crate::palette::Rgb;

/// A position on the page.
pub(crate) type Px = (f64, f64);

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
        let color = crate::palette::INK;
        let text = crate::escape::printable(text.as_ref());
        Self { text, at, anchor, em, bold: false, upwards: false, color }
    }
}

/// One thing to draw.
#[derive(Debug, Clone)]
pub(crate) enum Item {
    Stroke {
        points: Vec<Px>,
        width: f64,
        color: Rgb,
    },
    /// Rings filled by the non-zero rule.
    Fill {
        rings: Vec<Vec<Px>>,
        color: Rgb,
        alpha: f64,
    },
    Disc {
        center: Px,
        radius: f64,
        color: Rgb,
    },
    Label(Label),
}

/// A page of items in draw order.
#[derive(Debug, Clone)]
pub(crate) struct Scene {
    pub(crate) size: Size,
    pub(crate) title: String,
    pub(crate) items: Vec<Item>,
}

impl Scene {
    pub(crate) fn new(size: Size, title: &str) -> Self {
        Self { size, title: title.to_owned(), items: Vec::new() }
    }

    pub(crate) fn stroke(&mut self, points: Vec<Px>, width: f64, color: Rgb) {
        self.items.push(Item::Stroke { points, width, color });
    }

    pub(crate) fn fill(&mut self, rings: Vec<Vec<Px>>, color: Rgb, alpha: f64) {
        self.items.push(Item::Fill { rings, color, alpha });
    }

    pub(crate) fn label(&mut self, label: Label) {
        self.items.push(Item::Label(label));
    }

    /// Adds the items of another scene, moved by `offset`.
    pub(crate) fn place(&mut self, scene: Scene, offset: Px) {
        let moved = |p: Px| (p.0 + offset.0, p.1 + offset.1);
        let all = |points: Vec<Px>| points.into_iter().map(moved).collect::<Vec<_>>();
        self.items.extend(scene.items.into_iter().map(|item| match item {
            Item::Stroke { points, width, color } => Item::Stroke { points: all(points), width, color },
            Item::Fill { rings, color, alpha } => {
                Item::Fill { rings: rings.into_iter().map(all).collect(), color, alpha }
            }
            Item::Disc { center, radius, color } => Item::Disc { center: moved(center), radius, color },
            Item::Label(label) => Item::Label(Label { at: moved(label.at), ..label }),
        }));
    }
}
