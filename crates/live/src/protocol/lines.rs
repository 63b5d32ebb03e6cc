use serde::Serialize;

/// Longest line in bytes, its end not counted.
pub const MOST_LINE_BYTES: usize = 4096;

/// Cuts bytes into lines of bounded length, wherever they come from.
#[derive(Debug, Default)]
pub struct LineReader {
    line: Vec<u8>,
    too_long: bool,
}

/// What a [`LineReader`] found.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Line {
    /// A line without its end.
    Text(String),
    /// A line that is too long; it was left out.
    TooLong,
    /// A line that is not UTF-8; it was left out.
    NotText,
}

impl LineReader {
    /// Takes bytes and hands out the lines that end in them; empty lines are skipped.
    pub fn read(&mut self, bytes: &[u8], mut take: impl FnMut(Line)) {
        for &byte in bytes {
            if byte != b'\n' {
                if self.line.len() < MOST_LINE_BYTES {
                    self.line.push(byte);
                } else {
                    self.too_long = true;
                }
                continue;
            }
            let line = std::mem::take(&mut self.line);
            if std::mem::take(&mut self.too_long) {
                take(Line::TooLong);
            } else {
                match String::from_utf8(line) {
                    Ok(text) if text.trim().is_empty() => {}
                    Ok(text) => take(Line::Text(text.trim().to_owned())),
                    Err(_) => take(Line::NotText),
                }
            }
        }
    }
}

/// A message as a line with its end. Numbers that are not finite become null.
pub(crate) fn encode<T: Serialize>(message: &T) -> String {
    // Our messages have text keys only, so nothing can fail.
    let mut line = serde_json::to_string(message).unwrap_or_default();
    line.push('\n');
    line
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn lines(chunks: &[&[u8]]) -> Vec<Line> {
        let (mut reader, mut found) = (LineReader::default(), Vec::new());
        chunks.iter().for_each(|bytes| reader.read(bytes, |line| found.push(line)));
        found
    }

    #[test]
    fn a_long_line_is_left_out_and_the_next_one_read() {
        let long = vec![b'x'; MOST_LINE_BYTES + 1];
        let just = vec![b'x'; MOST_LINE_BYTES];
        let found = lines(&[&long, b"\n", &just, b"\nab", b"c\r\n\n\xff\n"]);
        let text = String::from_utf8(just).unwrap();
        let wanted = [Line::TooLong, Line::Text(text), Line::Text("abc".to_owned()), Line::NotText];
        assert_eq!(found, wanted);
    }

    proptest! {
        #[test]
        fn it_does_not_matter_where_the_bytes_are_cut(
            bytes in prop::collection::vec(prop_oneof![Just(b'\n'), Just(b'a'), any::<u8>()], 0..200),
            cut in 0_usize..200,
        ) {
            let (first, rest) = bytes.split_at(cut.min(bytes.len()));
            prop_assert_eq!(lines(&[&bytes]), lines(&[first, rest]));
        }
    }
}
