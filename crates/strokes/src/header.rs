use csv::ByteRecord;

use crate::StrokesError;
use crate::cell::{shortened, text_of};

/// Number of columns listed in a message.
const LISTED: usize = 40;

/// The names of the columns.
pub(crate) fn names<'r>(
    record: &'r ByteRecord,
    file: &str,
    line: usize,
) -> Result<Vec<&'r str>, StrokesError> {
    let name = |(i, bytes)| text_of(bytes, file, line, || format!("the name of column {}", i + 1));
    record.iter().enumerate().map(|cell| name(cell).map(str::trim)).collect()
}

/// Refuses a header without one of the required columns.
pub(crate) fn refuse_missing(
    names: &[&str],
    mut required: impl Iterator<Item = &'static str>,
    file: &str,
) -> Result<(), StrokesError> {
    let Some(column) = required.find(|column| !names.contains(column)) else { return Ok(()) };
    let mut found = names.iter().take(LISTED).map(|name| shortened(name)).collect::<Vec<_>>().join(", ");
    if names.len() > LISTED {
        found += &format!(" and {} more", names.len() - LISTED);
    }
    let hint = match names {
        [one] if one.contains(';') => " (cells seem to be separated by semicolons; use commas)",
        [one] if one.contains('\t') => " (cells seem to be separated by tabs; use commas)",
        _ => "; add it, with the unit of its name",
    };
    Err(StrokesError::MissingColumn { file: file.into(), column, found, hint })
}

/// Refuses two columns of one name, among those names that `counts`.
pub(crate) fn refuse_duplicates(
    names: &[&str],
    counts: impl Fn(&str) -> bool,
    file: &str,
    line: usize,
) -> Result<(), StrokesError> {
    // Sorted, because a hostile header may hold a million names.
    let mut sorted: Vec<(&str, usize)> =
        names.iter().enumerate().filter(|(_, name)| counts(name)).map(|(i, name)| (*name, i)).collect();
    sorted.sort_unstable();
    match sorted.windows(2).find(|pair| pair[0].0 == pair[1].0) {
        None => Ok(()),
        Some(pair) => Err(StrokesError::DuplicateColumn {
            file: file.into(),
            line,
            column: shortened(pair[0].0),
            first: pair[0].1 + 1,
            second: pair[1].1 + 1,
        }),
    }
}
