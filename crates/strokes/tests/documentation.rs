//! The documentation says of every column what the table of columns says.
#![allow(clippy::unwrap_used)]

use std::path::Path;

use soilctl_columns::{Columns, markdown};
use soilctl_strokes::{StrokeRow, TraceSample};

fn holds(text: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/files.md");
    let page = std::fs::read_to_string(&path).unwrap();
    assert!(
        page.contains(text),
        "the table in {} is not that of the columns; paste\n\n{text}",
        path.display()
    );
}

#[test]
fn files_lists_the_columns() {
    holds(&markdown::<StrokeRow>());
    holds(&markdown::<TraceSample>());
}

#[test]
fn every_column_says_its_unit_in_its_name_if_it_has_one() {
    let endings =
        [("deg", "_deg"), ("m", "_m"), ("s", "_s"), ("N", "_n"), ("m/s", "_mps"), ("kg/m3", "_kg_m3")];
    for about in
        StrokeRow::COLUMNS.iter().map(|c| &c.about).chain(TraceSample::COLUMNS.iter().map(|c| &c.about))
    {
        match endings.iter().find(|(unit, _)| *unit == about.unit) {
            Some((_, ending)) => assert!(about.name.ends_with(ending), "{}", about.name),
            None => assert!(["1", "text"].contains(&about.unit), "{}", about.name),
        }
    }
}
