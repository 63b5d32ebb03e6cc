//! Names in messages: a document may hold names of any length and number, a message is read by people.

/// The longest part of a name or value that a message repeats, in characters.
const LONGEST: usize = 80;
/// The most names that a message lists.
const MOST: usize = 20;

/// A name or value as it was written, cut where it is too long to be read.
pub(crate) fn cut(text: &str) -> String {
    cut_at(text, LONGEST)
}

/// The first characters of a text.
pub(crate) fn cut_at(text: &str, longest: usize) -> String {
    match text.char_indices().nth(longest) {
        Some((end, _)) => format!("{}…", text.get(..end).unwrap_or_default()),
        None => text.to_owned(),
    }
}

/// Names in a row, the first of them if there are many.
pub(crate) fn list<'a>(names: impl IntoIterator<Item = &'a str>) -> String {
    let mut names = names.into_iter();
    let mut text = String::new();
    for name in names.by_ref().take(MOST) {
        if !text.is_empty() {
            text.push_str(", ");
        }
        text.push_str(&cut(name));
    }
    match names.count() {
        0 => text,
        more => format!("{text} and {more} more"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_names_and_long_lists_are_cut_between_characters() {
        assert_eq!(cut("plate_tip"), "plate_tip");
        let long = cut(&"ß".repeat(500));
        assert_eq!(long.chars().count(), LONGEST + 1);
        assert_eq!(list(["a", "b"]), "a, b");
        assert!(list(std::iter::repeat_n("a", 25)).ends_with("a, a and 5 more"));
    }
}
