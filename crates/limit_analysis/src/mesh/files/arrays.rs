//! The arrays of a VTU file.

use std::fmt::Write;

use super::base64::encode;
use super::vtu::{Encoding, Field};

/// The arrays of a file.
pub(super) struct Arrays {
    pub(super) encoding: Encoding,
    /// The file up to here.
    pub(super) xml: String,
    /// The appended part, encoded.
    pub(super) appended: String,
}

impl Arrays {
    /// Adds an array of numbers; vectors of two components get a third.
    pub(super) fn field(&mut self, field: &Field) {
        let padded;
        let (components, values) = if field.components == 2 {
            padded = field.values.chunks(2).flat_map(|v| [v[0], v[1], 0.0]).collect::<Vec<f64>>();
            (3, padded.as_slice())
        } else {
            (field.components, field.values)
        };
        let name = escaped(field.name);
        let bytes = || values.iter().flat_map(|v| v.to_le_bytes()).collect();
        let words = values.iter().map(|v| format!("{v:?}"));
        self.array("Float64", &name, components, bytes, words);
    }

    /// Adds an array of integers.
    pub(super) fn integers(&mut self, kind: &str, name: &str, values: impl Iterator<Item = usize> + Clone) {
        let bytes = || {
            let all = values.clone().flat_map(|v| (v as u64).to_le_bytes());
            if kind == "UInt8" { all.step_by(8).collect() } else { all.collect() }
        };
        self.array(kind, name, 1, bytes, values.clone().map(|v| v.to_string()));
    }

    fn array(
        &mut self,
        kind: &str,
        name: &str,
        components: usize,
        bytes: impl Fn() -> Vec<u8>,
        words: impl Iterator<Item = String>,
    ) {
        let _ = write!(self.xml, "<DataArray type=\"{kind}\" Name=\"{name}\"");
        // One goes without saying; some readers take a stated one for a column of a matrix.
        if components > 1 {
            let _ = write!(self.xml, " NumberOfComponents=\"{components}\"");
        }
        match self.encoding {
            Encoding::Ascii => {
                self.xml += " format=\"ascii\">\n";
                for (i, word) in words.enumerate() {
                    self.xml += &word;
                    self.xml.push(if (i + 1) % (4 * components) == 0 { '\n' } else { ' ' });
                }
                self.xml += "\n</DataArray>\n";
            }
            Encoding::Base64 => {
                let _ = writeln!(self.xml, " format=\"appended\" offset=\"{}\"/>", self.appended.len());
                let bytes = bytes();
                let mut block = (bytes.len() as u64).to_le_bytes().to_vec();
                block.extend(bytes);
                encode(&block, &mut self.appended);
            }
        }
    }
}

/// A text as an attribute of XML; control characters, which XML does not have, become spaces.
fn escaped(text: &str) -> String {
    let mut out = String::new();
    for c in text.chars() {
        match c {
            '&' => out += "&amp;",
            '<' => out += "&lt;",
            '>' => out += "&gt;",
            '"' => out += "&quot;",
            c if c.is_control() => out.push(' '),
            c => out.push(c),
        }
    }
    out
}
