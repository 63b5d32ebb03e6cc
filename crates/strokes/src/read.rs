use std::io::{Chain, Read, Take};

use csv::{ByteRecord, ReaderBuilder, Terminator};
use soilctl_columns::Columns;

use crate::StrokesError;
use crate::line_guard::LineGuard;

/// Most rows that a table may have. A number takes 8 bytes of memory.
pub const MAX_ROWS: usize = 5_000_000;

/// Most bytes that are read from a file.
pub const MAX_BYTES: u64 = 1 << 30;

type Input<R> = Chain<LineGuard<Take<R>>, &'static [u8]>;

/// The columns that every row needs.
pub(crate) fn required<R: Columns>() -> impl Iterator<Item = &'static str> {
    R::COLUMNS.iter().filter(|column| column.about.required).map(|column| column.about.name)
}

/// A csv file, row by row: a header first, then rows of as many cells.
pub(crate) struct Records<'a, R> {
    reader: csv::Reader<Input<R>>,
    record: ByteRecord,
    file: &'a str,
    rows: usize,
    /// Cells of the header.
    width: usize,
    /// Whether the header ends in CRLF.
    crlf: bool,
}

impl<'a, R: Read> Records<'a, R> {
    pub(crate) fn new(input: R, file: &'a str) -> Self {
        // Lines end at LF, so that the line count is right after every record (in CRLF mode it is not); a CR
        // before it is taken off below. The last line gets an LF if it has none, for the same reason.
        let input = LineGuard::new(input.take(MAX_BYTES)).chain(&b"\n"[..]);
        let reader = ReaderBuilder::new()
            .has_headers(false)
            .flexible(true)
            .terminator(Terminator::Any(b'\n'))
            .buffer_capacity(1 << 16)
            .from_reader(input);
        Self { reader, record: ByteRecord::new(), file, rows: 0, width: 0, crlf: false }
    }

    /// Reads the header; its line, and its cells. Without one the message names the columns that are `required`.
    pub(crate) fn header(
        &mut self,
        required: impl Iterator<Item = &'static str>,
    ) -> Result<(usize, &ByteRecord), StrokesError> {
        let Some(line) = self.next()? else {
            let columns = required.collect::<Vec<_>>().join(", ");
            return Err(StrokesError::Empty { file: self.file.into(), columns });
        };
        self.width = self.record.len();
        self.crlf = self.record.as_slice().ends_with(b"\r");
        Ok((line, &self.record))
    }

    /// Reads the next row; its line, or `None` at the end.
    pub(crate) fn row(&mut self) -> Result<Option<usize>, StrokesError> {
        let Some(line) = self.next()? else { return Ok(None) };
        let (file, found, expected) = (self.file, self.record.len(), self.width);
        self.rows += 1;
        if self.rows > MAX_ROWS {
            return Err(StrokesError::TooLarge { file: file.into(), limit: format!("{MAX_ROWS} rows") });
        }
        if found != expected {
            return Err(StrokesError::Ragged { file: file.into(), line, found, expected });
        }
        Ok(Some(line))
    }

    /// A cell of the row; empty where the row has none.
    pub(crate) fn cell(&self, place: usize) -> &[u8] {
        let cell = self.record.get(place).unwrap_or_default();
        let last = place + 1 == self.width;
        if self.crlf && last { cell.strip_suffix(b"\r").unwrap_or(cell) } else { cell }
    }

    /// Reads the next line that is not blank; its number, or `None` at the end.
    fn next(&mut self) -> Result<Option<usize>, StrokesError> {
        loop {
            let before = self.reader.position().line();
            let more = self.reader.read_byte_record(&mut self.record).map_err(|problem| {
                StrokesError::File { file: self.file.into(), problem: problem.to_string() }
            })?;
            if !more {
                return self.refuse_cut().map(|()| None);
            }
            if self.record.len() == 1 && self.record.as_slice() == b"\r" {
                continue;
            }
            let after = self.reader.position().line();
            let first = if after == before + 1 {
                before
            } else {
                // Blank lines before the row, or line breaks in quotes inside of it.
                let inside = self.record.as_slice().iter().filter(|byte| **byte == b'\n').count() as u64;
                after.saturating_sub(1 + inside)
            };
            return Ok(Some(usize::try_from(first).unwrap_or(usize::MAX)));
        }
    }

    fn refuse_cut(&self) -> Result<(), StrokesError> {
        if self.reader.get_ref().get_ref().0.inner().limit() == 0 {
            return Err(StrokesError::TooLarge {
                file: self.file.into(),
                limit: format!("{} MiB", MAX_BYTES >> 20),
            });
        }
        Ok(())
    }
}
