//! Tables by name or from a file.

use std::path::Path;

use soilctl_earth_pressure::table::{
    PredictionTable, Sidecar, read_csv, read_parquet, write_csv, write_parquet,
};
use soilctl_earth_pressure::thesis::{Column, appendix_c};

use crate::error::CliError;

const BUILT_IN: [(&str, Column); 6] = [
    ("appendix-c-coulomb", Column::Coulomb),
    ("appendix-c-log-spiral", Column::LogSpiral),
    ("appendix-c-chen", Column::Chen),
    ("appendix-c-caquot", Column::Caquot),
    ("appendix-c-num-ub", Column::UpperBound),
    ("appendix-c-num-lb", Column::LowerBound),
];

/// A built-in table or one from a file, and where its numbers come from.
pub(super) fn find_table(source: &str) -> Result<(PredictionTable, String), CliError> {
    if let Some((_, column)) = BUILT_IN.iter().find(|(name, _)| *name == source) {
        return Ok((appendix_c(*column)?, "Hong 2001, Appendix C".into()));
    }
    let (table, sidecar) = read_table(source.as_ref())?;
    Ok((table, sidecar.source))
}

/// Reads a table file by its ending.
pub(crate) fn read_table(path: &Path) -> Result<(PredictionTable, Sidecar), CliError> {
    Ok(match Kind::of(path)? {
        Kind::Csv => read_csv(path)?,
        Kind::Parquet => read_parquet(path)?,
    })
}

/// Writes a table file and its sidecar.
pub(super) fn write_table(table: &PredictionTable, source: &str, path: &Path) -> Result<(), CliError> {
    match Kind::of(path)? {
        Kind::Csv => write_csv(table, source, path)?,
        Kind::Parquet => write_parquet(table, source, path)?,
    }
    Ok(())
}

/// Form of a table file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Csv,
    Parquet,
}

impl Kind {
    pub(super) fn of(path: &Path) -> Result<Self, CliError> {
        match path.extension().and_then(|ending| ending.to_str()) {
            Some("csv") => Ok(Self::Csv),
            Some("parquet") => Ok(Self::Parquet),
            _ => {
                let names: Vec<&str> = BUILT_IN.iter().map(|(name, _)| *name).collect();
                Err(CliError::Usage(format!(
                    "{} is neither a table file, which ends in .csv or .parquet, nor a built-in table, which are {}",
                    path.display(),
                    names.join(", ")
                )))
            }
        }
    }
}
