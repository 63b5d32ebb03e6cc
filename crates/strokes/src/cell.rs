use std::fmt::Display;

use soilctl_columns::{About, Range};

use crate::{Place, StrokesError};

/// Where a cell is: all that is needed to report it, put together only when there is something to report.
#[derive(Clone, Copy)]
pub(crate) struct CellPlace<'a> {
    pub(crate) file: &'a str,
    pub(crate) line: usize,
    pub(crate) column: &'a str,
}

impl CellPlace<'_> {
    pub(crate) fn owned(self) -> Place {
        Place { file: self.file.into(), line: self.line, column: self.column.into() }
    }

    /// The text of a cell.
    pub(crate) fn text(self, bytes: &[u8]) -> Result<&str, StrokesError> {
        text_of(bytes, self.file, self.line, || format!("column {}", self.column))
    }

    /// The value of a cell of a column of numbers; `None` if it is empty. A standard deviation may be 0 if `allow_zero_sd`.
    pub(crate) fn number(
        self,
        bytes: &[u8],
        about: &About,
        allow_zero_sd: bool,
    ) -> Result<Option<f64>, StrokesError> {
        let text = self.text(bytes)?.trim();
        let allowed = || about.range.words(about.unit);
        if text.is_empty() {
            if about.required {
                return Err(StrokesError::EmptyCell { place: self.owned(), allowed: allowed() });
            }
            return Ok(None);
        }
        let Ok(value) = text.parse::<f64>() else {
            let (place, text) = (self.owned(), shortened(text));
            return Err(StrokesError::NotANumber { place, text, allowed: allowed() });
        };
        self.check(value, &text, about, allow_zero_sd)?;
        Ok(Some(value))
    }

    /// Refuses a value that the column does not take; `text` is how it is written.
    pub(crate) fn check(
        self,
        value: f64,
        text: &impl Display,
        about: &About,
        allow_zero_sd: bool,
    ) -> Result<(), StrokesError> {
        let found = || (self.owned(), shortened(&text.to_string()));
        if about.range == Range::Deviation && value <= 0.0 && !(allow_zero_sd && value == 0.0) {
            let (place, text) = found();
            return Err(StrokesError::ZeroUncertainty { place, text });
        }
        if about.range.holds(value) {
            return Ok(());
        }
        let (place, text) = found();
        Err(StrokesError::OutOfRange { place, text, allowed: about.range.words(about.unit) })
    }
}

/// Bytes as text; `cell` says in messages where they are.
pub(crate) fn text_of<'b>(
    bytes: &'b [u8],
    file: &str,
    line: usize,
    cell: impl Fn() -> String,
) -> Result<&'b str, StrokesError> {
    std::str::from_utf8(bytes).map_err(|problem| {
        let at = problem.valid_up_to();
        let byte = bytes.get(at).copied().unwrap_or_default();
        StrokesError::NotUtf8 { file: file.into(), line, cell: cell(), at: at + 1, byte }
    })
}

/// The text, cut where it would make a message unreadable.
pub(crate) fn shortened(text: &str) -> String {
    const KEPT: usize = 40;
    match text.char_indices().nth(KEPT) {
        Some((end, _)) => format!("{}...", &text[..end]),
        None => text.into(),
    }
}
