//! Text with simple inline markup.

use crate::escape;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Mark {
    Plain,
    Strong,
    Emphasis,
    Code,
}

/// Text with emphasis and code; everything in it is escaped, so any text is safe.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct RichText {
    runs: Vec<(Mark, String)>,
}

impl RichText {
    /// Starts with plain text.
    pub fn new(text: impl Into<String>) -> Self {
        Self::default().text(text)
    }

    /// Adds plain text.
    #[must_use]
    pub fn text(self, text: impl Into<String>) -> Self {
        self.with(Mark::Plain, text.into())
    }

    /// Adds text of strong importance (bold).
    #[must_use]
    pub fn strong(self, text: impl Into<String>) -> Self {
        self.with(Mark::Strong, text.into())
    }

    /// Adds stressed text (italic).
    #[must_use]
    pub fn emphasis(self, text: impl Into<String>) -> Self {
        self.with(Mark::Emphasis, text.into())
    }

    /// Adds code, such as a file name or a command (monospaced).
    #[must_use]
    pub fn code(self, text: impl Into<String>) -> Self {
        self.with(Mark::Code, text.into())
    }

    fn with(mut self, mark: Mark, text: String) -> Self {
        self.runs.push((mark, text));
        self
    }

    pub(crate) fn to_html(&self) -> String {
        let run = |(mark, text): &(Mark, String)| {
            let text = escape::html(text);
            match mark {
                Mark::Plain => text,
                Mark::Strong => format!("<strong>{text}</strong>"),
                Mark::Emphasis => format!("<em>{text}</em>"),
                Mark::Code => format!("<code>{text}</code>"),
            }
        };
        self.runs.iter().map(run).collect()
    }
}

impl From<&str> for RichText {
    fn from(text: &str) -> Self {
        Self::new(text)
    }
}

impl From<String> for RichText {
    fn from(text: String) -> Self {
        Self::new(text)
    }
}

impl From<&String> for RichText {
    fn from(text: &String) -> Self {
        Self::new(text)
    }
}
