//! CSV text with line numbers that survive into error messages.

use std::path::Path;

use crate::DirectShearError;

/// A CSV table whose rows remember the line they came from. Lines that begin with `#` are comments.
#[derive(Debug)]
pub(crate) struct Table {
    pub(crate) file: String,
    header_line: u64,
    header: Vec<String>,
    pub(crate) rows: Vec<Row>,
}

#[derive(Debug)]
pub(crate) struct Row {
    pub(crate) line: u64,
    cells: Vec<String>,
}

impl Table {
    pub(crate) fn read(path: &Path) -> Result<Self, DirectShearError> {
        let file = path.display().to_string();
        let bytes =
            std::fs::read(path).map_err(|source| DirectShearError::Io { file: file.clone(), source })?;
        Self::parse(&bytes, &file)
    }

    pub(crate) fn parse(bytes: &[u8], file: &str) -> Result<Self, DirectShearError> {
        let file = file.to_owned();
        let text = std::str::from_utf8(bytes).map_err(|error| DirectShearError::NotUtf8 {
            file: file.clone(),
            line: lines_before(bytes, error.valid_up_to()) + 1,
        })?;
        // Spreadsheets put a byte-order mark in front, which would otherwise become part of the first name.
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let mut reader = csv::ReaderBuilder::new()
            .has_headers(false)
            .comment(Some(b'#'))
            .trim(csv::Trim::All)
            .from_reader(text.as_bytes());
        let mut rows = Vec::new();
        for record in reader.records() {
            let record = record.map_err(|error| csv_error(&file, text, &error))?;
            let line = record.position().map_or(0, |position| line_of(text, position));
            rows.push(Row { line, cells: record.iter().map(str::to_owned).collect() });
        }
        if rows.len() < 2 {
            return Err(DirectShearError::Empty { file });
        }
        let header = rows.remove(0);
        let table = Self { file, header_line: header.line, header: header.cells, rows };
        table.refuse_duplicates()?;
        Ok(table)
    }

    fn refuse_duplicates(&self) -> Result<(), DirectShearError> {
        for (index, name) in self.header.iter().enumerate() {
            if self.header[..index].contains(name) {
                return Err(self.columns_error(format!("column `{name}` appears twice; keep one")));
            }
        }
        Ok(())
    }

    /// Refuses a column that differs from a known one only in case or punctuation: it would be skipped in
    /// silence otherwise, because columns that are not known are allowed.
    pub(crate) fn refuse_misspelt(&self, known: &[&str]) -> Result<(), DirectShearError> {
        let plain = |name: &str| -> String {
            name.chars().filter(|c| c.is_alphanumeric()).flat_map(char::to_lowercase).collect()
        };
        for name in &self.header {
            if let Some(meant) = known.iter().find(|k| *k != name && plain(k) == plain(name)) {
                return Err(self.columns_error(format!("column `{name}` is not known; write `{meant}`")));
            }
        }
        Ok(())
    }

    pub(crate) fn column(&self, name: &str) -> Option<usize> {
        self.header.iter().position(|header| header == name)
    }

    pub(crate) fn require(&self, name: &str) -> Result<usize, DirectShearError> {
        self.column(name).ok_or_else(|| self.columns_error(format!("column `{name}` is missing; add it")))
    }

    pub(crate) fn columns_error(&self, problem: String) -> DirectShearError {
        DirectShearError::Columns {
            file: self.file.clone(),
            line: self.header_line,
            problem,
            present: self.header.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", "),
        }
    }

    pub(crate) fn cell_error(&self, row: &Row, column: usize, allowed: &str) -> DirectShearError {
        DirectShearError::Cell {
            file: self.file.clone(),
            line: row.line,
            column: self.header[column].clone(),
            value: row.cells[column].clone(),
            allowed: allowed.to_owned(),
        }
    }

    pub(crate) fn is_empty(&self, row: &Row, column: usize) -> bool {
        row.cells[column].is_empty()
    }

    pub(crate) fn text<'a>(&self, row: &'a Row, column: usize) -> Result<&'a str, DirectShearError> {
        let text = row.cells[column].as_str();
        if text.is_empty() { Err(self.cell_error(row, column, "not empty")) } else { Ok(text) }
    }

    pub(crate) fn number(
        &self,
        row: &Row,
        column: usize,
        allowed: &str,
        ok: impl Fn(f64) -> bool,
    ) -> Result<f64, DirectShearError> {
        match row.cells[column].parse::<f64>() {
            Ok(value) if value.is_finite() && ok(value) => Ok(value),
            _ => Err(self.cell_error(row, column, allowed)),
        }
    }
}

fn lines_before(bytes: &[u8], end: usize) -> u64 {
    bytes[..end].iter().fold(0, |count, byte| count + u64::from(*byte == b'\n'))
}

/// The reader's own line is that of the blank or comment lines it skipped before the record.
fn line_of(text: &str, position: &csv::Position) -> u64 {
    let start = usize::try_from(position.byte()).unwrap_or(usize::MAX).min(text.len());
    let mut line = position.line();
    for skipped in text.as_bytes()[start..].split(|byte| *byte == b'\n') {
        if !skipped.trim_ascii().is_empty() && skipped[0] != b'#' {
            break;
        }
        line += 1;
    }
    line
}

fn csv_error(file: &str, text: &str, error: &csv::Error) -> DirectShearError {
    let file = file.to_owned();
    match error.kind() {
        csv::ErrorKind::UnequalLengths { pos, expected_len, len } => DirectShearError::RaggedLine {
            file,
            line: pos.as_ref().map_or(0, |position| line_of(text, position)),
            expected: *expected_len,
            found: *len,
        },
        // Reading records from text in memory has no other way to fail; kept as an error all the same.
        _ => DirectShearError::Io { file, source: std::io::Error::other(error.to_string()) },
    }
}
