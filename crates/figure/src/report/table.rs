//! Tables.

use super::RichText;
use crate::error::FigureError;
use crate::escape;

/// Alignment of a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Align {
    /// For words.
    Left,
    /// For numbers; digits get equal widths.
    Right,
    /// For marks and short codes.
    Center,
}

impl Align {
    fn class(self) -> &'static str {
        match self {
            Self::Left => "left",
            Self::Right => "right",
            Self::Center => "center",
        }
    }
}

/// A table with a caption.
///
/// ```
/// use soilctl_figure::{Align, Table};
///
/// # fn main() -> Result<(), soilctl_figure::FigureError> {
/// let mut table = Table::new("Peak states", [("Test", Align::Left), ("τ (kPa)", Align::Right)]);
/// table.row(["S1", "61.2"])?.row(["S2", "118.0"])?;
/// assert!(table.row(["S3"]).is_err());
/// # Ok(()) }
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    caption: String,
    columns: Vec<(String, Align)>,
    rows: Vec<Vec<RichText>>,
}

impl Table {
    /// An empty table with the given column headings and alignments.
    pub fn new<S: Into<String>>(
        caption: impl Into<String>,
        columns: impl IntoIterator<Item = (S, Align)>,
    ) -> Self {
        let columns = columns.into_iter().map(|(name, align)| (name.into(), align)).collect();
        Self { caption: caption.into(), columns, rows: Vec::new() }
    }

    /// Adds a row.
    ///
    /// # Errors
    ///
    /// [`FigureError::BadRow`] unless there is one cell per column.
    pub fn row<C: Into<RichText>>(
        &mut self,
        cells: impl IntoIterator<Item = C>,
    ) -> Result<&mut Self, FigureError> {
        let cells: Vec<RichText> = cells.into_iter().map(Into::into).collect();
        if cells.len() != self.columns.len() {
            return Err(FigureError::BadRow {
                table: self.caption.clone(),
                expected: self.columns.len(),
                found: cells.len(),
            });
        }
        self.rows.push(cells);
        Ok(self)
    }

    pub(crate) fn to_html(&self) -> String {
        let caption = escape::html(&self.caption);
        let mut out = String::new();
        // Above the frame, or it would be as wide as the table and scroll with it.
        if !self.caption.is_empty() {
            out += &format!("<p class=\"table-title\">{caption}</p>\n");
        }
        // Wide tables scroll inside their frame, which the keyboard can reach.
        out += &format!(
            "<div class=\"table\" role=\"region\" aria-label=\"{caption}\" tabindex=\"0\">\n<table aria-label=\"{caption}\">\n"
        );
        out += "<thead><tr>";
        for (name, align) in &self.columns {
            out += &format!("<th scope=\"col\" class=\"{}\">{}</th>", align.class(), escape::html(name));
        }
        out += "</tr></thead>\n<tbody>\n";
        for row in &self.rows {
            out += "<tr>";
            for (cell, (_, align)) in row.iter().zip(&self.columns) {
                out += &format!("<td class=\"{}\">{}</td>", align.class(), cell.to_html());
            }
            out += "</tr>\n";
        }
        out + "</tbody>\n</table>\n</div>\n"
    }
}
