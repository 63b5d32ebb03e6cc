//! Reports as one self-contained HTML file.

mod blocks;
mod drawn;
mod page;
mod rich;
mod table;

pub use blocks::CalloutKind;
pub use rich::RichText;
pub use table::{Align, Table};

use crate::error::FigureError;
use crate::model::{Figure, Motion, Size};
use blocks::{Block, Callout};
use drawn::Drawn;

/// A figure of a report, as it is drawn where nothing moves.
#[derive(Debug, Clone, PartialEq)]
pub struct Shown {
    /// Its number on the page, from 1.
    pub number: usize,
    /// The figure; of a motion, its end.
    pub figure: Figure,
    /// Its size.
    pub size: Size,
}

/// Builds a report: what it is and of what, a verdict, then headings, paragraphs, tables, callouts, definition lists and figures.
///
/// All reports look alike: a head with the verdict, contents if there are three sections or more, and a foot that says what
/// made it. The result is one HTML file without any outside references: it needs no network and its content
/// security policy forbids all loads. Figures are interactive where scripts run, and are static
/// vector graphics in print and where scripts do not run. Colours are light or dark as the reader's system is, or as a
/// button says; nothing is told by colour alone. All texts are escaped.
///
/// ```
/// use soilctl_figure::{CalloutKind, HtmlReport, RichText};
///
/// let mut report = HtmlReport::new("Direct shear test");
/// report
///     .kind("Laboratory")
///     .subtitle("Sample S1 <loose>")
///     .verdict(CalloutKind::Good, "Within tolerance", "The density was met.")
///     .heading("Result")
///     .paragraph(RichText::new("Peak friction angle ").strong("32.4°").text(" from ").code("s1.csv"))
///     .footer("soilctl 0.1.0");
/// let html = report.to_html();
/// assert!(html.contains("Sample S1 &lt;loose&gt;"));
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct HtmlReport {
    title: String,
    kind: Option<String>,
    subtitle: Option<String>,
    verdict: Option<Callout>,
    footer: Option<String>,
    command: Option<String>,
    still: bool,
    blocks: Vec<Block>,
}

impl HtmlReport {
    /// An empty report.
    pub fn new(title: impl Into<String>) -> Self {
        Self {
            title: title.into(),
            kind: None,
            subtitle: None,
            verdict: None,
            footer: None,
            command: None,
            still: false,
            blocks: Vec::new(),
        }
    }

    /// Sets what sort of report it is: a few words above the title.
    pub fn kind(&mut self, text: impl Into<String>) -> &mut Self {
        self.kind = Some(text.into());
        self
    }

    /// Sets the line under the title.
    pub fn subtitle(&mut self, text: impl Into<String>) -> &mut Self {
        self.subtitle = Some(text.into());
        self
    }

    /// Sets what the report comes to, in a box below the title.
    pub fn verdict(
        &mut self,
        kind: CalloutKind,
        title: impl Into<String>,
        text: impl Into<RichText>,
    ) -> &mut Self {
        self.verdict = Some(Callout { kind, title: title.into(), text: text.into() });
        self
    }

    /// Sets the foot of the page; the place for the program version.
    pub fn footer(&mut self, text: impl Into<String>) -> &mut Self {
        self.footer = Some(text.into());
        self
    }

    /// Sets the command that made the report, which stands in the foot.
    pub fn command(&mut self, line: impl Into<String>) -> &mut Self {
        self.command = Some(line.into());
        self
    }

    /// Makes all figures still: the page is for paper, and a fraction of the size. In browsers' modules every page is.
    pub fn still(&mut self) -> &mut Self {
        self.still = true;
        self
    }

    /// Starts a section.
    pub fn heading(&mut self, text: impl Into<String>) -> &mut Self {
        let number = 1 + self.blocks.iter().filter(|block| matches!(block, Block::Section { .. })).count();
        self.add(Block::Section { number, text: text.into() })
    }

    /// Starts a subsection.
    pub fn subheading(&mut self, text: impl Into<String>) -> &mut Self {
        self.add(Block::Subheading(text.into()))
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
        self.add(Block::Callout(Callout { kind, title: title.into(), text: text.into() }))
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

    /// Adds lines to be filled in by hand, each behind what belongs there.
    pub fn to_fill_in<T: Into<String>>(&mut self, entries: impl IntoIterator<Item = T>) -> &mut Self {
        self.add(Block::ToFillIn(entries.into_iter().map(Into::into).collect()))
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
        let number = 1 + self.shown().count();
        let shown = Shown { number, figure: figure.clone(), size };
        let drawn = Drawn::figure(shown, caption.into(), number)?;
        Ok(self.add(Block::Figure(Box::new(drawn))))
    }

    /// Adds a figure that moves, with a button and a slider. It plays by itself while it is in view, unless the reader's
    /// system asks for less motion.
    ///
    /// # Errors
    ///
    /// As [`Motion::at`], and [`Figure::to_svg`] of its end.
    pub fn motion(
        &mut self,
        motion: &Motion,
        size: Size,
        caption: impl Into<RichText>,
    ) -> Result<&mut Self, FigureError> {
        let drawn = Drawn::motion(motion, size, caption.into(), 1 + self.shown().count())?;
        Ok(self.add(Block::Figure(Box::new(drawn))))
    }

    /// All figures in the order of the page, to be written to files.
    pub fn shown(&self) -> impl Iterator<Item = &Shown> {
        self.blocks.iter().filter_map(|block| match block {
            Block::Figure(drawn) => Some(drawn.shown()),
            _ => None,
        })
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
