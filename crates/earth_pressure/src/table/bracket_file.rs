//! Bracket tables in files.

use std::path::Path;

use csv::DeserializeErrorKind;
use serde::{Deserialize, Serialize};
use soilctl_jobs::sha256;

use super::bracket::{BracketRow, BracketRules, BracketTable};
use super::sidecar::{SLANT, file_error, program_version, sidecar_path, write_both};
use super::{MAX_NODES, Sidecar};
use crate::EarthPressureError;

/// Version of the bracket file format; a reader refuses any other.
pub const BRACKET_SCHEMA: &str = "soilctl.bracket-file/1";

/// What stands beside a bracket file, in `<file>.json`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct BracketSidecar {
    /// [`BRACKET_SCHEMA`].
    pub schema: String,
    /// Name of the table.
    pub name: String,
    /// Always `slant`, as in [`Sidecar::normalisation`].
    pub normalisation: String,
    /// Where the numbers come from, and how to make them again.
    pub source: String,
    /// The rules by which every case was stopped.
    pub rules: BracketRules,
    /// Number of rows, as a check against truncation.
    pub cells: usize,
    /// SHA-256 of the rows as they are written: of a file without it nothing counts as proven, since it may have been altered.
    #[serde(default)]
    pub sha256: Option<String>,
    /// Version of the program that computed the rows.
    pub program_version: String,
}

/// Whether a table file holds brackets, by the schema of its sidecar.
///
/// # Errors
/// [`EarthPressureError::File`] if the sidecar cannot be read.
pub fn is_bracket_file(path: &Path) -> Result<bool, EarthPressureError> {
    #[derive(Deserialize)]
    struct Schema {
        schema: String,
    }
    let path = sidecar_path(path);
    let text = std::fs::read_to_string(&path).map_err(|e| file_error(&path, &e))?;
    let found: Schema = serde_json::from_str(&text).map_err(|e| file_error(&path, &e))?;
    Ok(found.schema == BRACKET_SCHEMA)
}

/// Writes a bracket table and its sidecar. Each file is complete or not there at all, whatever happens meanwhile.
///
/// # Errors
/// [`EarthPressureError::File`] if a file cannot be written.
pub fn write_bracket(table: &BracketTable, source: &str, path: &Path) -> Result<(), EarthPressureError> {
    let bytes = written(table.rows()).map_err(|e| file_error(path, &e))?;
    let sidecar = BracketSidecar {
        schema: BRACKET_SCHEMA.into(),
        name: table.name().into(),
        normalisation: SLANT.into(),
        source: source.into(),
        rules: table.rules(),
        cells: table.rows().len(),
        sha256: Some(sha256(&bytes)),
        program_version: program_version().into(),
    };
    write_both(path, &bytes, &sidecar)
}

/// The bytes of a file of these rows.
fn written(rows: &[BracketRow]) -> Result<Vec<u8>, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for row in rows {
        writer.serialize(row)?;
    }
    writer.into_inner().map_err(|e| e.into_error().into())
}

/// Reads a bracket table and its sidecar. The columns may stand in any order and among others.
///
/// # Errors
/// [`EarthPressureError::File`] if a file cannot be read, [`EarthPressureError::BadTable`] if its content is wrong
/// (with the line) or another version's, [`EarthPressureError::TooLarge`] if it has more than [`MAX_NODES`] rows.
pub fn read_bracket(path: &Path) -> Result<(BracketTable, BracketSidecar), EarthPressureError> {
    let beside = sidecar_path(path);
    let sidecar = std::fs::read_to_string(&beside).map_err(|e| file_error(&beside, &e))?;
    let rows = std::fs::read_to_string(path).map_err(|e| file_error(path, &e))?;
    parse_bracket(&path.display().to_string(), &rows, &sidecar)
}

/// A bracket table from the text of its file and its sidecar; `whence` is its name in messages.
///
/// # Errors
/// As [`read_bracket`].
pub fn parse_bracket(
    whence: &str,
    text: &str,
    sidecar: &str,
) -> Result<(BracketTable, BracketSidecar), EarthPressureError> {
    let bad = |problem: String| EarthPressureError::BadTable { table: whence.to_owned(), problem };
    let sidecar: BracketSidecar =
        serde_json::from_str(sidecar).map_err(|e| bad(format!("its sidecar: {e}")))?;
    if sidecar.schema != BRACKET_SCHEMA {
        return Err(bad(format!("schema is {:?}; it must be {BRACKET_SCHEMA:?}", sidecar.schema)));
    }
    if sidecar.normalisation != SLANT {
        return Err(bad(format!("normalisation is {:?}; it must be {SLANT:?}", sidecar.normalisation)));
    }
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let headers = reader.headers().map_err(|e| bad(e.to_string()))?.clone();
    let mut rows = Vec::new();
    let mut record = csv::StringRecord::new();
    while reader.read_record(&mut record).map_err(|e| bad(e.to_string()))? {
        let line = record.position().map_or(0, csv::Position::line);
        let at_line =
            |problem| EarthPressureError::BadTable { table: format!("{whence}, line {line}"), problem };
        if rows.len() == MAX_NODES {
            let size = format!("more than {MAX_NODES} rows");
            return Err(EarthPressureError::TooLarge { table: whence.to_owned(), size, limit: MAX_NODES });
        }
        let row: BracketRow =
            record.deserialize(Some(&headers)).map_err(|e| at_line(cell_problem(&e, &headers, &record)))?;
        if let Some(problem) = row.problem() {
            return Err(at_line(problem));
        }
        rows.push(row);
    }
    Sidecar::same_count(whence, sidecar.cells, rows.len())?;
    if sidecar.sha256.is_none() {
        rows.iter_mut().for_each(|row| row.certified = false);
    }
    let table = BracketTable::new(&sidecar.name, sidecar.rules, rows)?;
    let found = sha256(&written(table.rows()).map_err(|e| bad(e.to_string()))?);
    if sidecar.sha256.as_ref().is_some_and(|stated| *stated != found) {
        let problem = "its rows are not those that its sidecar was written for: it was altered after it was built, so nothing \
                       in it counts as proven; build it anew";
        return Err(bad(problem.into()));
    }
    Ok((table, sidecar))
}

/// Which cell of a row is not what it should be.
fn cell_problem(error: &csv::Error, headers: &csv::StringRecord, record: &csv::StringRecord) -> String {
    let csv::ErrorKind::Deserialize { err, .. } = error.kind() else { return error.to_string() };
    let wanted = match err.kind() {
        DeserializeErrorKind::ParseFloat(_) => "a number with a decimal point",
        DeserializeErrorKind::ParseInt(_) => "a whole number",
        DeserializeErrorKind::ParseBool(_) => "true or false",
        _ => return err.kind().to_string(),
    };
    let at = err.field().and_then(|field| usize::try_from(field).ok()).unwrap_or(usize::MAX);
    match (headers.get(at), record.get(at)) {
        (Some(name), Some(text)) => format!("{name} is {text:?}; it must be {wanted}"),
        _ => format!("{}; it must be {wanted}", err.kind()),
    }
}

#[cfg(test)]
mod tests {
    use std::path::PathBuf;

    use super::super::bracket::tests::{RULES, square};
    use super::*;

    fn written() -> (tempfile::TempDir, PathBuf, BracketTable) {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("b.csv");
        let table = BracketTable::new("t", RULES, square()).unwrap();
        write_bracket(&table, "a test", &path).unwrap();
        (dir, path, table)
    }

    #[test]
    fn a_table_reads_back_the_same_bits_and_leaves_no_other_files() {
        let (dir, path, table) = written();
        assert!(is_bracket_file(&path).unwrap());
        let (read, sidecar) = read_bracket(&path).unwrap();
        assert_eq!((read, sidecar.source.as_str()), (table, "a test"));
        let mut names: Vec<_> =
            std::fs::read_dir(dir.path()).unwrap().map(|f| f.unwrap().file_name()).collect();
        names.sort();
        assert_eq!(names, ["b.csv", "b.csv.json"]);
    }

    /// Bounds that are all multiplied by a number contradict nothing else.
    #[test]
    fn an_altered_table_is_not_proven() {
        let (_dir, path, table) = written();
        let rows = table.rows().iter().map(|row| BracketRow {
            lower: 1.3 * row.lower,
            upper: 1.3 * row.upper,
            ..*row
        });
        let other = BracketTable::new("t", RULES, rows.collect()).unwrap();
        let text = String::from_utf8(super::written(other.rows()).unwrap()).unwrap();
        std::fs::write(&path, &text).unwrap();
        let message = read_bracket(&path).unwrap_err().to_string();
        assert!(message.contains("it was altered after it was built"), "{message}");
        let beside = sidecar_path(&path);
        let sidecar = std::fs::read_to_string(&beside).unwrap();
        let without: String =
            sidecar.lines().filter(|line| !line.contains("sha256")).map(|l| l.to_owned() + "\n").collect();
        std::fs::write(&beside, without).unwrap();
        assert!(read_bracket(&path).unwrap().0.rows().iter().all(|row| !row.certified));
    }

    #[test]
    fn what_is_wrong_is_named_with_its_line() {
        let (_dir, path, _) = written();
        let good = std::fs::read_to_string(&path).unwrap();
        let line_2 = good.lines().nth(1).unwrap();
        let header = good.lines().next().unwrap();
        for (from, to, words) in [
            (line_2, line_2.replacen("2.0", "x", 1), "line 2: lower is \"x\"; it must be a number"),
            (
                line_2,
                line_2.replacen("2.0", "-2.0", 1),
                "line 2: lower is -2; it must be a finite number above 0",
            ),
            (line_2, line_2.replacen("2.0", "1.9", 1), "line 2: gap is"),
            (line_2, line_2.replacen("true", "maybe", 1), "certified is \"maybe\"; it must be true or false"),
            (
                line_2,
                line_2.replacen("600", "6.5", 1),
                "lower_elements is \"6.5\"; it must be a whole number",
            ),
            (header, header.replacen("lower,", "low,", 1), "missing field `lower`"),
            (line_2, String::new(), "its sidecar says 8"),
        ] {
            std::fs::write(&path, good.replacen(from, &to, 1)).unwrap();
            let message = read_bracket(&path).unwrap_err().to_string();
            assert!(message.contains(words), "{words} is not in: {message}");
        }
    }
}
