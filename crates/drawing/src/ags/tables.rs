//! The tables of an AGS 4 file: rows of quoted cells, the first of which says what the row is (AGS 4.1.1, rules 2 to 6).

use std::collections::BTreeMap;

use crate::DrawingError;

/// A group: named columns with units, and rows of data.
#[derive(Debug, Default)]
pub(super) struct Group {
    headings: Vec<String>,
    units: Vec<String>,
    rows: Vec<(usize, Vec<String>)>,
}

/// A row of a group.
#[derive(Debug, Clone, Copy)]
pub(super) struct Row<'a> {
    group: &'a Group,
    cells: &'a [String],
    /// Line of the file.
    pub(super) line: usize,
}

/// All groups of a file by name.
pub(super) fn read(bytes: &[u8]) -> Result<BTreeMap<String, Group>, DrawingError> {
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .trim(csv::Trim::All)
        .from_reader(bytes.strip_prefix("\u{feff}".as_bytes()).unwrap_or(bytes));
    let mut groups: BTreeMap<String, Group> = BTreeMap::new();
    let mut open: Option<String> = None;
    let mut record = csv::ByteRecord::new();
    loop {
        let malformed = |line: usize, reason: String| DrawingError::Malformed { line, reason };
        match reader.read_byte_record(&mut record) {
            Ok(true) => {}
            Ok(false) => break,
            Err(error) => {
                let line = error.position().map_or(1, csv::Position::line);
                return Err(malformed(usize::try_from(line).unwrap_or(1), error.to_string()));
            }
        }
        let line = record.position().and_then(|at| usize::try_from(at.line()).ok()).unwrap_or(1);
        let mut cells = record.iter().map(|cell| String::from_utf8_lossy(cell).into_owned());
        let kind = cells.next().unwrap_or_default();
        let cells: Vec<String> = cells.collect();
        if kind.starts_with("**") {
            return Err(DrawingError::Kind(
                "it is written in AGS 3 or older; have it exported as AGS 4".into(),
            ));
        }
        if kind == "GROUP" {
            let name = cells.into_iter().next().filter(|name| !name.is_empty());
            let name = name.ok_or_else(|| malformed(line, "a GROUP has no name".into()))?;
            open = Some(name);
            continue;
        }
        if kind.is_empty() && cells.iter().all(String::is_empty) {
            continue;
        }
        let Some(name) = &open else {
            return Err(malformed(line, format!("the file must begin with a GROUP, and has {kind:?}")));
        };
        let group = groups.entry(name.clone()).or_default();
        match kind.as_str() {
            "HEADING" => group.headings = cells,
            "UNIT" => group.units = cells,
            "TYPE" => {}
            "DATA" if group.headings.is_empty() => {
                return Err(malformed(line, format!("group {name} has DATA before its HEADING")));
            }
            "DATA" => group.rows.push((line, cells)),
            other => {
                let reason = format!("{other:?} is none of GROUP, HEADING, UNIT, TYPE and DATA");
                return Err(malformed(line, reason));
            }
        }
    }
    if groups.is_empty() {
        return Err(DrawingError::Kind("it has no GROUP: is it an AGS 4 file?".into()));
    }
    Ok(groups)
}

impl Group {
    pub(super) fn rows(&self) -> impl Iterator<Item = Row<'_>> {
        self.rows.iter().map(|(line, cells)| Row { group: self, cells, line: *line })
    }
}

impl<'a> Row<'a> {
    fn column(&self, heading: &str) -> Option<usize> {
        self.group.headings.iter().position(|name| name == heading)
    }

    /// A cell that is there and not empty.
    pub(super) fn text(&self, heading: &str) -> Option<&'a str> {
        self.cells.get(self.column(heading)?).map(String::as_str).filter(|cell| !cell.is_empty())
    }

    /// A cell that must be there.
    pub(super) fn needed(&self, heading: &str) -> Result<&'a str, DrawingError> {
        let malformed = || self.malformed(format!("{heading} is missing"));
        self.text(heading).ok_or_else(malformed)
    }

    /// A number in a unit; `None` of an empty cell.
    pub(super) fn number(&self, heading: &str, unit: &str) -> Result<Option<f64>, DrawingError> {
        let Some((text, column)) = self.text(heading).zip(self.column(heading)) else { return Ok(None) };
        let said = self.group.units.get(column).map_or("", String::as_str);
        let is_same = said == unit || [said, unit] == ["kN/m2", "kPa"];
        if !is_same {
            let reason = format!("{heading} is in {said:?}; only {unit} is read");
            return Err(self.malformed(reason));
        }
        let number = text.parse::<f64>().ok().filter(|number| number.is_finite());
        number.map(Some).ok_or_else(|| self.malformed(format!("{heading} is {text:?}, and must be a number")))
    }

    pub(super) fn malformed(&self, reason: String) -> DrawingError {
        DrawingError::Malformed { line: self.line, reason }
    }
}
