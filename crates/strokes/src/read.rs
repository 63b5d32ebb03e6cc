use std::io::{Chain, Read, Take};

use csv::{ByteRecord, ReaderBuilder, Terminator};

use crate::cell::CellPlace;
use crate::columns::{Column, NUMBERS};
use crate::line_guard::LineGuard;
use crate::{StrokesError, header};

/// Most rows that a table may have. A number takes 8 bytes of memory.
pub const MAX_ROWS: usize = 5_000_000;

/// Most bytes that are read from a file.
pub const MAX_BYTES: u64 = 1 << 30;

/// What the reader lets pass.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct ReadOptions {
    /// Whether `force_sd_n` may be 0, as in data made by a model.
    pub allow_zero_sd: bool,
}

type Input<R> = Chain<LineGuard<Take<R>>, &'static [u8]>;

/// Rows of a csv file with the line on which each one starts.
pub(crate) struct Records<'a, R> {
    reader: csv::Reader<Input<R>>,
    pub(crate) record: ByteRecord,
    file: &'a str,
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
        Self { reader, record: ByteRecord::new(), file }
    }

    /// Reads the next row that is not blank; its line, or `None` at the end.
    pub(crate) fn next(&mut self) -> Result<Option<usize>, StrokesError> {
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

/// Columns with their cells, and the line of each row.
pub(crate) fn read_columns<R: Read>(
    input: R,
    file: &str,
    options: ReadOptions,
) -> Result<(Vec<Column>, Vec<usize>), StrokesError> {
    let mut records = Records::new(input, file);
    let Some(line) = records.next()? else { return Err(StrokesError::Empty { file: file.into() }) };
    let mut columns = header::parse(&records.record, file, line)?;
    let crlf = records.record.as_slice().ends_with(b"\r");
    let mut lines = Vec::new();
    while let Some(line) = records.next()? {
        if lines.len() == MAX_ROWS {
            return Err(StrokesError::TooLarge { file: file.into(), limit: format!("{MAX_ROWS} rows") });
        }
        let (expected, found) = (columns.len(), records.record.len());
        if found != expected {
            return Err(StrokesError::Ragged { file: file.into(), line, found, expected });
        }
        for (i, (cell, column)) in records.record.iter().zip(&mut columns).enumerate() {
            let last = i + 1 == expected;
            let cell = if crlf && last { cell.strip_suffix(b"\r").unwrap_or(cell) } else { cell };
            push(column, cell, file, line, options)?;
        }
        lines.push(line);
    }
    if lines.is_empty() {
        return Err(StrokesError::NoRows { file: file.into() });
    }
    Ok((columns, lines))
}

fn push(
    column: &mut Column,
    cell: &[u8],
    file: &str,
    line: usize,
    options: ReadOptions,
) -> Result<(), StrokesError> {
    match column {
        Column::Number(index, values) => {
            let place = CellPlace { file, line, column: NUMBERS[*index].name };
            values.push(place.number(cell, *index, options.allow_zero_sd)?.unwrap_or(f64::NAN));
        }
        Column::Text(column) => {
            let text = CellPlace { file, line, column: column.name() }.text(cell)?;
            column.push(text);
        }
    }
    Ok(())
}
