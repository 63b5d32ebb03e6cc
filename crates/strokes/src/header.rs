use csv::ByteRecord;

use crate::StrokesError;
use crate::cell::shortened;
use crate::columns::{Column, NUMBERS};

/// Number of columns listed in a message.
const LISTED: usize = 40;

/// The columns that a header names, without cells.
pub(crate) fn parse(record: &ByteRecord, file: &str, line: usize) -> Result<Vec<Column>, StrokesError> {
    let mut names = Vec::with_capacity(record.len());
    for (i, bytes) in record.iter().enumerate() {
        let name = std::str::from_utf8(bytes).map_err(|problem| StrokesError::NotUtf8 {
            file: file.into(),
            line,
            cell: format!("the name of column {}", i + 1),
            at: problem.valid_up_to() + 1,
            byte: bytes.get(problem.valid_up_to()).copied().unwrap_or_default(),
        })?;
        names.push(name.trim());
    }
    refuse_duplicates(&names, file, line)?;
    refuse_missing(&names, file)?;
    Ok(names.into_iter().map(Column::new).collect())
}

fn refuse_missing(names: &[&str], file: &str) -> Result<(), StrokesError> {
    let missing = NUMBERS.iter().find(|column| column.required && !names.contains(&column.name));
    let Some(column) = missing else { return Ok(()) };
    let mut found = names.iter().take(LISTED).map(|name| shortened(name)).collect::<Vec<_>>().join(", ");
    if names.len() > LISTED {
        found += &format!(" and {} more", names.len() - LISTED);
    }
    let hint = match names {
        [one] if one.contains(';') => " (cells seem to be separated by semicolons; use commas)",
        [one] if one.contains('\t') => " (cells seem to be separated by tabs; use commas)",
        _ => "; add it, with the unit of its name",
    };
    Err(StrokesError::MissingColumn { file: file.into(), column: column.name, found, hint })
}

fn refuse_duplicates(names: &[&str], file: &str, line: usize) -> Result<(), StrokesError> {
    // Sorted, because a hostile header may hold a million names.
    let mut sorted: Vec<(&str, usize)> = names.iter().enumerate().map(|(i, name)| (*name, i)).collect();
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
