//! Codes and their values.

use crate::DrawingError;

/// A code and its value.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pair<'a> {
    pub(super) code: i32,
    pub(super) value: &'a str,
    /// Line of the value.
    pub(super) line: usize,
}

/// First bytes of the binary form.
const BINARY: &[u8] = b"AutoCAD Binary DXF";
/// First bytes of a DWG file, followed by its version.
const DWG: &[u8] = b"AC10";

/// The text of a file: UTF-8 since version 2007; before, a code page whose letters matter for names of layers only. Those are taken for Latin-1.
pub(super) fn text_of(bytes: &[u8]) -> Result<String, DrawingError> {
    let refused = |why: &str| Err(DrawingError::Kind(why.to_owned()));
    if bytes.starts_with(BINARY) {
        return refused("it is binary DXF; save it as DXF text (ASCII)");
    }
    if bytes.starts_with(DWG) {
        return refused("it is DWG; save it as DXF");
    }
    Ok(match std::str::from_utf8(bytes) {
        Ok(text) => text.trim_start_matches('\u{feff}').to_owned(),
        Err(_) => bytes.iter().map(|&byte| char::from(byte)).collect(),
    })
}

/// All pairs but comments.
pub(super) fn pairs(text: &str) -> Result<Vec<Pair<'_>>, DrawingError> {
    let mut lines = text.lines().enumerate();
    let mut pairs = Vec::new();
    while let Some((i, code)) = lines.next() {
        if code.trim().is_empty() && lines.clone().all(|(_, rest)| rest.trim().is_empty()) {
            break;
        }
        let malformed = |reason: &str| DrawingError::Malformed { line: i + 1, reason: reason.to_owned() };
        let code: i32 =
            code.trim().parse().map_err(|_| malformed("a code of DXF must be a number; is it DXF text?"))?;
        let (i, value) = lines.next().ok_or_else(|| malformed("the code has no value"))?;
        if code != 999 {
            pairs.push(Pair { code, value, line: i + 1 });
        }
        if code == 0 && value.trim() == "EOF" {
            break;
        }
    }
    Ok(pairs)
}

impl Pair<'_> {
    /// The value as a number.
    pub(super) fn number(&self) -> Result<f64, DrawingError> {
        let text = self.value.trim();
        let malformed = || DrawingError::Malformed {
            line: self.line,
            reason: format!("{text:?} must be a finite number"),
        };
        text.parse().ok().filter(|x: &f64| x.is_finite()).ok_or_else(malformed)
    }

    /// The value as flags; 0 if it is no number.
    pub(super) fn flags(&self) -> i32 {
        self.value.trim().parse().unwrap_or_default()
    }
}

/// A name in which letters that its code page lacks are written `\U+00E4`.
pub(super) fn unescaped(name: &str) -> String {
    let mut parts = name.split("\\U+");
    let mut text = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let letter = part.get(..4).and_then(|hex| u32::from_str_radix(hex, 16).ok()).and_then(char::from_u32);
        match letter {
            Some(letter) => {
                text.push(letter);
                text.push_str(&part[4..]);
            }
            None => {
                text.push_str("\\U+");
                text.push_str(part);
            }
        }
    }
    text
}
