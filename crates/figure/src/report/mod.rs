//! Reports as one self-contained HTML file.

mod blocks;
mod page;
mod rich;
mod table;

pub use blocks::CalloutKind;
pub use rich::RichText;
pub use table::{Align, Table};

use crate::error::FigureError;
use crate::model::{Figure, Size};
use blocks::{Block, FigureBlock};

/// Builds a report of headings, paragraphs, tables, callouts, definition lists and figures.
///
/// The result is one HTML file without any outside references: it needs no network and its content
/// security policy forbids all loads. Figures are interactive where scripts run, and are static
/// vector graphics in print and where scripts do not run. All texts are escaped.
///
/// ```
/// use soilctl_figure::{CalloutKind, HtmlReport, RichText};
///
/// let mut report = HtmlReport::new("Direct shear test");
/// report
///     .subtitle("Sample S1 <loose>")
///     .heading("Result")
///     .paragraph(RichText::new("Peak friction angle ").strong("32.4°").text(" from ").code("s1.csv"))
///     .callout(CalloutKind::Good, "Within tolerance", "The density was met.")
///     .footer("soilctl 0.1.0");
/// let html = report.to_html();
/// assert!(html.contains("Sample S1 &lt;loose&gt;"));
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct HtmlReport {
    title: String,
    subtitle: Option<String>,
    footer: Option<String>,
    blocks: Vec<Block>,
}

impl HtmlReport {
    /// An empty report.
    pub fn new(title: impl Into<String>) -> Self {
        Self { title: title.into(), subtitle: None, footer: None, blocks: Vec::new() }
    }

    /// Sets the line under the title.
    pub fn subtitle(&mut self, text: impl Into<String>) -> &mut Self {
        self.subtitle = Some(text.into());
        self
    }

    /// Sets the last line of the page; the place for the program version.
    pub fn footer(&mut self, text: impl Into<String>) -> &mut Self {
        self.footer = Some(text.into());
        self
    }

    /// Starts a section.
    pub fn heading(&mut self, text: impl Into<String>) -> &mut Self {
        self.add(Block::Heading { level: 2, text: text.into() })
    }

    /// Starts a subsection.
    pub fn subheading(&mut self, text: impl Into<String>) -> &mut Self {
        self.add(Block::Heading { level: 3, text: text.into() })
    }

    /// Adds a paragraph.
    pub fn paragraph(&mut self, text: impl Into<RichText>) -> &mut Self {
        self.add(Block::Paragraph(text.into()))
    }

    /// Adds a table.
    pub fn table(&mut self, table: Table) -> &mut Self {
        self.add(Block::Table(table))
    }

    /// Adds a boxed remark or verdict.
    pub fn callout(
        &mut self,
        kind: CalloutKind,
        title: impl Into<String>,
        text: impl Into<RichText>,
    ) -> &mut Self {
        self.add(Block::Callout { kind, title: title.into(), text: text.into() })
    }

    /// Adds a list of terms and their definitions or values.
    pub fn definitions<T, D>(&mut self, entries: impl IntoIterator<Item = (T, D)>) -> &mut Self
    where
        T: Into<String>,
        D: Into<RichText>,
    {
        let entries = entries.into_iter().map(|(term, text)| (term.into(), text.into()));
        self.add(Block::Definitions(entries.collect()))
    }

    /// Adds a figure with a caption and a link that saves the figure's data as CSV.
    ///
    /// # Errors
    ///
    /// As [`Figure::to_svg`], which makes the static version.
    pub fn figure(
        &mut self,
        figure: &Figure,
        size: Size,
        caption: impl Into<RichText>,
    ) -> Result<&mut Self, FigureError> {
        let number = 1 + self.blocks.iter().filter(|block| matches!(block, Block::Figure(_))).count();
        let block = FigureBlock::new(figure, size, caption.into(), number)?;
        Ok(self.add(Block::Figure(Box::new(block))))
    }

    /// The report as one HTML file. Equal reports give equal files.
    pub fn to_html(&self) -> String {
        page::render(self)
    }

    fn add(&mut self, block: Block) -> &mut Self {
        self.blocks.push(block);
        self
    }
}
