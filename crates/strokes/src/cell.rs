use crate::allowed::Allowed;
use crate::columns::NUMBERS;
use crate::{Place, StrokesError};

/// Where a cell is: all that is needed to report it, put together only when there is something to report.
#[derive(Clone, Copy)]
pub(crate) struct CellPlace<'a> {
    pub(crate) file: &'a str,
    pub(crate) line: usize,
    pub(crate) column: &'a str,
}

impl CellPlace<'_> {
    fn owned(self) -> Place {
        Place { file: self.file.into(), line: self.line, column: self.column.into() }
    }

    /// The text of a cell.
    pub(crate) fn text(self, bytes: &[u8]) -> Result<&str, StrokesError> {
        std::str::from_utf8(bytes).map_err(|problem| {
            let at = problem.valid_up_to();
            StrokesError::NotUtf8 {
                file: self.file.into(),
                line: self.line,
                cell: format!("column {}", self.column),
                at: at + 1,
                byte: bytes.get(at).copied().unwrap_or_default(),
            }
        })
    }

    /// The value of a cell of column `index` of [`NUMBERS`]; `None` if it is empty.
    pub(crate) fn number(
        self,
        bytes: &[u8],
        index: usize,
        allow_zero_sd: bool,
    ) -> Result<Option<f64>, StrokesError> {
        let column = &NUMBERS[index];
        let text = self.text(bytes)?.trim();
        if text.is_empty() {
            if column.required {
                return Err(StrokesError::EmptyCell { place: self.owned(), allowed: column.allowed.words() });
            }
            return Ok(None);
        }
        let Ok(value) = text.parse::<f64>() else {
            return Err(StrokesError::NotANumber {
                place: self.owned(),
                text: shortened(text),
                allowed: column.allowed.words(),
            });
        };
        self.check(value, text, index, allow_zero_sd)?;
        Ok(Some(value))
    }

    /// Refuses a value that column `index` does not take.
    pub(crate) fn check(
        self,
        value: f64,
        text: &str,
        index: usize,
        allow_zero_sd: bool,
    ) -> Result<(), StrokesError> {
        let allowed = NUMBERS[index].allowed;
        if allowed == Allowed::Deviation && value <= 0.0 && !(allow_zero_sd && value == 0.0) {
            return Err(StrokesError::ZeroUncertainty { place: self.owned(), text: shortened(text) });
        }
        if allowed.holds(value) {
            return Ok(());
        }
        Err(StrokesError::OutOfRange { place: self.owned(), text: shortened(text), allowed: allowed.words() })
    }
}

/// The text, cut where it would make a message unreadable.
pub(crate) fn shortened(text: &str) -> String {
    const KEPT: usize = 40;
    match text.char_indices().nth(KEPT) {
        Some((end, _)) => format!("{}...", &text[..end]),
        None => text.into(),
    }
}
