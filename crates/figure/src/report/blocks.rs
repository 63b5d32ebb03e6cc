//! The parts of a report and their HTML.

use super::drawn::Drawn;
use super::{RichText, Table};
use crate::escape;

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

/// A boxed remark.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Callout {
    pub(crate) kind: CalloutKind,
    pub(crate) title: String,
    pub(crate) text: RichText,
}

impl Callout {
    /// As an element of this class beside those of its kind.
    pub(crate) fn to_html(&self, class: &str) -> String {
        let (kind, symbol) = self.kind.class_and_symbol();
        format!(
            "<div class=\"{class} {kind}\" role=\"note\">\
             <p class=\"callout-title\"><span class=\"symbol\" aria-hidden=\"true\">{symbol}</span>{}</p>\
             <p>{}</p></div>\n",
            escape::html(&self.title),
            self.text.to_html()
        )
    }
}

/// One part of a report.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Block {
    /// Sections are numbered, so that the contents can lead there.
    Section {
        number: usize,
        text: String,
    },
    Subheading(String),
    Paragraph(RichText),
    Table(Table),
    Callout(Callout),
    Definitions(Vec<(String, RichText)>),
    ToFillIn(Vec<String>),
    Figure(Box<Drawn>),
}

impl Block {
    pub(crate) fn to_html(&self, still: bool) -> String {
        match self {
            Self::Section { number, text } => {
                format!("<h2 id=\"section-{number}\">{}</h2>\n", escape::html(text))
            }
            Self::Subheading(text) => format!("<h3>{}</h3>\n", escape::html(text)),
            Self::Paragraph(text) => format!("<p>{}</p>\n", text.to_html()),
            Self::Table(table) => table.to_html(),
            Self::Callout(callout) => callout.to_html("callout"),
            Self::Definitions(entries) => {
                let entry = |(term, text): &(String, RichText)| {
                    format!("<div><dt>{}</dt><dd>{}</dd></div>\n", escape::html(term), text.to_html())
                };
                format!("<dl>\n{}</dl>\n", entries.iter().map(entry).collect::<String>())
            }
            Self::ToFillIn(entries) => {
                let entry = |term: &String| format!("<div><dt>{}</dt><dd></dd></div>\n", escape::html(term));
                format!("<dl class=\"fill-in\">\n{}</dl>\n", entries.iter().map(entry).collect::<String>())
            }
            Self::Figure(drawn) => drawn.to_html(still),
        }
    }
}
