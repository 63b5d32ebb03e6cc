//! The parts of a report and their HTML.

use super::{RichText, Table};
use crate::error::FigureError;
use crate::escape;
use crate::model::{Figure, Size};

/// What a callout says about its subject.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CalloutKind {
    /// Neutral information.
    Note,
    /// Something to be aware of.
    Warning,
    /// A criterion is met.
    Good,
    /// A criterion is not met.
    Bad,
}

impl CalloutKind {
    /// Class of the element and a symbol, which carries the meaning without colour.
    fn class_and_symbol(self) -> (&'static str, &'static str) {
        match self {
            Self::Note => ("note", "i"),
            Self::Warning => ("warning", "!"),
            Self::Good => ("good", "✓"),
            Self::Bad => ("bad", "✗"),
        }
    }
}

/// One part of a report.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Block {
    Heading { level: u8, text: String },
    Paragraph(RichText),
    Table(Table),
    Callout { kind: CalloutKind, title: String, text: RichText },
    Definitions(Vec<(String, RichText)>),
    Figure(Box<FigureBlock>),
}

impl Block {
    pub(crate) fn to_html(&self) -> String {
        match self {
            Self::Heading { level, text } => format!("<h{level}>{}</h{level}>\n", escape::html(text)),
            Self::Paragraph(text) => format!("<p>{}</p>\n", text.to_html()),
            Self::Table(table) => table.to_html(),
            Self::Callout { kind, title, text } => {
                let (class, symbol) = kind.class_and_symbol();
                format!(
                    "<div class=\"callout {class}\" role=\"note\">\
                     <p class=\"callout-title\"><span class=\"symbol\" aria-hidden=\"true\">{symbol}</span>{}</p>\
                     <p>{}</p></div>\n",
                    escape::html(title),
                    text.to_html()
                )
            }
            Self::Definitions(entries) => {
                let entry = |(term, text): &(String, RichText)| {
                    format!("<div><dt>{}</dt><dd>{}</dd></div>\n", escape::html(term), text.to_html())
                };
                format!("<dl>\n{}</dl>\n", entries.iter().map(entry).collect::<String>())
            }
            Self::Figure(figure) => figure.to_html(),
        }
    }
}

/// A figure, rendered for all uses when it was added.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FigureBlock {
    number: usize,
    title: String,
    caption: RichText,
    size: Size,
    svg: String,
    json: String,
    csv: String,
}

impl FigureBlock {
    pub(crate) fn new(
        figure: &Figure,
        size: Size,
        caption: RichText,
        number: usize,
    ) -> Result<Self, FigureError> {
        // The page shows the title as text, which wraps on narrow screens.
        let untitled = Figure { title: String::new(), ..figure.clone() };
        let mut json = untitled.to_plotly_json();
        json["layout"]["margin"]["t"] = 34.into();
        Ok(Self {
            number,
            title: figure.title().to_owned(),
            caption,
            size,
            svg: untitled.to_svg(size)?,
            json: escape::script_json(&json),
            csv: figure.to_csv(),
        })
    }

    fn to_html(&self) -> String {
        let Self { number, svg, json, .. } = self;
        let title = escape::html(&self.title);
        let (width, height) = (self.size.width(), self.size.height());
        let link = escape::data_uri("text/csv", &self.csv);
        let colon = if title.is_empty() { "" } else { ": " };
        format!(
            "<figure id=\"figure-{number}\">\n\
             <p class=\"figure-title\" id=\"figure-{number}-title\">Figure {number}{colon}{title}</p>\n\
             <div class=\"static\" style=\"max-width:{width}px\">{svg}</div>\n\
             <div class=\"plot\" id=\"plot-{number}\" role=\"group\" aria-labelledby=\"figure-{number}-title\" \
             style=\"aspect-ratio:{width}/{height}\"></div>\n\
             <script type=\"application/json\" class=\"plot-data\">{json}</script>\n\
             <figcaption>{caption} <a class=\"data\" download=\"figure-{number}.csv\" href=\"{link}\">Data of figure \
             {number} (CSV)</a></figcaption>\n</figure>\n",
            caption = self.caption.to_html(),
        )
    }
}
