//! The words of a file, with line numbers.

use super::super::FileError;

/// Most characters of a wrong word that an error repeats.
const SHOWN: usize = 40;

/// Reads a file word by word.
pub(super) struct Scan<'a> {
    lines: std::slice::Split<'a, u8, fn(&u8) -> bool>,
    /// What is left of the line.
    rest: &'a str,
    /// Number of the line, from 1.
    pub(super) line: usize,
}

impl<'a> Scan<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        let newline: fn(&u8) -> bool = |b| *b == b'\n';
        Self { lines: bytes.split(newline), rest: "", line: 0 }
    }

    pub(super) fn syntax(&self, expected: &'static str, found: &str) -> FileError {
        FileError::Syntax { line: self.line, expected, found: found.chars().take(SHOWN).collect() }
    }

    /// The rest of the line, and if there is nothing the next line; `None` at the end of the file.
    pub(super) fn text(&mut self) -> Result<Option<&'a str>, FileError> {
        loop {
            let text = std::mem::take(&mut self.rest).trim();
            if !text.is_empty() {
                return Ok(Some(text));
            }
            let Some(line) = self.lines.next() else { return Ok(None) };
            self.line += 1;
            self.rest = std::str::from_utf8(line)
                .map_err(|_| self.syntax("text in UTF-8", &String::from_utf8_lossy(line)))?;
        }
    }

    /// The next word.
    pub(super) fn word(&mut self, expected: &'static str) -> Result<&'a str, FileError> {
        let text = self.text()?.ok_or(FileError::Ends { line: self.line, expected })?;
        let (word, rest) = text.split_once(|c: char| c.is_ascii_whitespace()).unwrap_or((text, ""));
        self.rest = rest;
        Ok(word)
    }

    /// The next word as a number.
    pub(super) fn number<T: std::str::FromStr>(&mut self, expected: &'static str) -> Result<T, FileError> {
        let word = self.word(expected)?;
        word.parse().map_err(|_| self.syntax(expected, word))
    }

    /// The next word as a coordinate, finite.
    pub(super) fn coordinate(&mut self) -> Result<f64, FileError> {
        let expected = "a coordinate, a finite number";
        let word = self.word(expected)?;
        word.parse().ok().filter(|c: &f64| c.is_finite()).ok_or_else(|| self.syntax(expected, word))
    }

    /// Skips a number of words.
    pub(super) fn skip(&mut self, count: u64, expected: &'static str) -> Result<(), FileError> {
        // A wrong count ends at a section's end or the file's.
        for _ in 0..count {
            let word = self.word(expected)?;
            if word.starts_with('$') {
                return Err(self.syntax(expected, word));
            }
        }
        Ok(())
    }

    /// Expects a certain word.
    pub(super) fn expect(&mut self, wanted: &'static str) -> Result<(), FileError> {
        let word = self.word(wanted)?;
        if word == wanted { Ok(()) } else { Err(self.syntax(wanted, word)) }
    }
}
