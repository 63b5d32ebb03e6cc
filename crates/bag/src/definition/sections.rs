use std::collections::BTreeMap;

use super::short_name;

/// Bytes of the longest text of definitions that is read. The largest messages of ROS have some 20 kB.
const MOST_BYTES: usize = 1 << 20;

/// The text of a recording, taken apart.
#[derive(Debug, Default)]
pub(super) struct Sections<'a> {
    /// The type itself.
    pub(super) first: &'a str,
    /// The others, by their short names.
    pub(super) others: BTreeMap<String, &'a str>,
}

/// Takes a text of definitions apart at its lines of `=`.
///
/// # Errors
/// In words.
pub(super) fn sections(text: &str) -> Result<Sections<'_>, String> {
    if text.len() > MOST_BYTES {
        return Err(format!(
            "its definition has {} bytes; the longest that is read has {MOST_BYTES}",
            text.len()
        ));
    }
    let mut sections = Sections::default();
    let mut name = None;
    // Where the section began, where the line began, and whether the line before was one of `=`.
    let (mut begin, mut place, mut parted) = (0, 0, false);
    for line in text.split_inclusive('\n') {
        let word = line.trim();
        if parted {
            let Some(next) = word.strip_prefix("MSG:") else {
                return Err(format!(
                    "in its definition a line of `=` is followed by {:?} instead of `MSG: package/Type`",
                    shown(word)
                ));
            };
            name = Some(short_name(next.trim()));
            begin = place + line.len();
        }
        parted = is_line(word);
        if parted {
            sections.keep(name.take(), text.get(begin..place).unwrap_or_default());
            begin = place + line.len();
        }
        place += line.len();
    }
    if !parted {
        sections.keep(name, text.get(begin..).unwrap_or_default());
    }
    Ok(sections)
}

impl<'a> Sections<'a> {
    fn keep(&mut self, name: Option<String>, body: &'a str) {
        match name {
            Some(name) => {
                self.others.entry(name).or_insert(body);
            }
            None => self.first = body,
        }
    }
}

/// ROS writes 80 of them, other programs fewer; no field is written so.
fn is_line(word: &str) -> bool {
    word.len() >= 3 && word.bytes().all(|byte| byte == b'=')
}

/// So much of a line as a message can hold.
pub(super) fn shown(line: &str) -> String {
    line.chars().take(60).collect()
}
