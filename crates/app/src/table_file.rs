//! Tables by name or from a file.

use std::path::Path;

use soilctl_earth_pressure::table::{
    self, BracketModel, BracketTable, Form, PredictionTable, Sidecar, TableModel, is_bracket_file,
    read_bracket, read_csv, read_parquet, write_bracket,
};
use soilctl_earth_pressure::thesis::{Column, appendix_c};
use soilctl_earth_pressure::{ForceModel, plate_bounds};

use crate::AppError;

const BUILT_IN: [(&str, Column); 6] = [
    ("appendix-c-coulomb", Column::Coulomb),
    ("appendix-c-log-spiral", Column::LogSpiral),
    ("appendix-c-chen", Column::Chen),
    ("appendix-c-caquot", Column::Caquot),
    ("appendix-c-num-ub", Column::UpperBound),
    ("appendix-c-num-lb", Column::LowerBound),
];

/// The built-in table of brackets.
const BRACKETS: &str = "plate-bounds";

/// A table of either kind.
pub enum AnyTable {
    /// Coefficients, and where they come from.
    Points(PredictionTable, String),
    /// Brackets of proven bounds.
    Brackets(BracketTable),
}

/// A built-in table or one from a file, and where its numbers come from.
///
/// # Errors
/// [`AppError`] if the file cannot be read or written, or makes no sense.
pub fn find_table(source: &str) -> Result<AnyTable, AppError> {
    if source == BRACKETS {
        return Ok(AnyTable::Brackets(plate_bounds()?));
    }
    if let Some((_, column)) = BUILT_IN.iter().find(|(name, _)| *name == source) {
        return Ok(AnyTable::Points(appendix_c(*column)?, "Hong 2001, Appendix C".into()));
    }
    let path: &Path = source.as_ref();
    form(path)?;
    if is_bracket_file(path)? {
        return Ok(AnyTable::Brackets(read_brackets(path)?.0));
    }
    let (table, sidecar) = read_table(path)?;
    Ok(AnyTable::Points(table, sidecar.source))
}

/// A force model from a table file of either kind, and where its numbers come from.
///
/// # Errors
/// [`AppError`] if the file cannot be read or written, or makes no sense.
pub fn read_model(path: &Path) -> Result<(Box<dyn ForceModel>, String), AppError> {
    const ID: &str = "table-file";
    const REFERENCE: &str = "a prediction table read from a file";
    form(path)?;
    if is_bracket_file(path)? {
        let (table, sidecar) = read_bracket(path)?;
        let model = BracketModel::of(ID, REFERENCE, &table)?;
        return Ok((Box::new(model), format!("{} ({})", sidecar.source, sidecar.name)));
    }
    let (table, sidecar) = read_table(path)?;
    let reference = format!("{} ({})", sidecar.source, sidecar.name);
    Ok((Box::new(TableModel::new(ID, REFERENCE, table)), reference))
}

/// Reads a table file by its ending.
fn read_table(path: &Path) -> Result<(PredictionTable, Sidecar), AppError> {
    Ok(match form(path)? {
        Form::Csv => read_csv(path)?,
        Form::Parquet => read_parquet(path)?,
    })
}

/// Reads a bracket file: the table, and the version of the program that built it.
///
/// # Errors
/// [`AppError`] if the file cannot be read or written, or makes no sense.
pub fn read_brackets(path: &Path) -> Result<(BracketTable, String), AppError> {
    for_brackets(path)?;
    if !is_bracket_file(path)? {
        return Err(AppError::Request(format!(
            "{} is a table, but not one of bounds; choose a file that `table build --model bounds` wrote",
            path.display()
        )));
    }
    let (table, sidecar) = read_bracket(path)?;
    Ok((table, sidecar.program_version))
}

/// Writes a bracket file and its sidecar.
///
/// # Errors
/// [`AppError`] if the file cannot be read or written, or makes no sense.
pub fn write_brackets(table: &BracketTable, source: &str, path: &Path) -> Result<(), AppError> {
    for_brackets(path)?;
    Ok(write_bracket(table, source, path)?)
}

/// Writes a table file and its sidecar.
///
/// # Errors
/// [`AppError`] if the file cannot be read or written, or makes no sense.
pub fn write_table(table: &PredictionTable, source: &str, path: &Path) -> Result<(), AppError> {
    Ok(table::write_table(form(path)?, table, source, path)?)
}

/// Refuses what a table of brackets cannot be written to.
///
/// # Errors
/// [`AppError`] if the file cannot be read or written, or makes no sense.
pub fn for_brackets(path: &Path) -> Result<(), AppError> {
    match form(path)? {
        Form::Csv => Ok(()),
        Form::Parquet => Err(AppError::Request(format!(
            "{} ends in .parquet, but a table of bounds is a CSV file; choose a name that ends in .csv",
            path.display()
        ))),
    }
}

/// Form of a table file, by its ending.
///
/// # Errors
/// [`AppError::Request`] for another ending, with the names of the built-in tables.
pub fn form(path: &Path) -> Result<Form, AppError> {
    Form::of(path).ok_or_else(|| {
        let names: Vec<&str> = BUILT_IN.iter().map(|(name, _)| *name).chain([BRACKETS]).collect();
        AppError::Request(format!(
            "{} is neither a table file, which ends in .csv or .parquet, nor a built-in table, which are {}",
            path.display(),
            names.join(", ")
        ))
    })
}
