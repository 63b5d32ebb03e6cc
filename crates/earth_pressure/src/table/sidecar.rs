use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use soilctl_jobs::write_atomically;

use super::{PredictionTable, Quantity};
use crate::EarthPressureError;

/// Version of the table file format; a reader refuses any other.
pub const SIDECAR_SCHEMA: &str = "soilctl.table-file/1";

/// What stands beside a table file, in `<file>.json`: everything needed to read its numbers right.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Sidecar {
    /// [`SIDECAR_SCHEMA`].
    pub schema: String,
    /// Name of the table.
    pub name: String,
    /// What the numbers are.
    pub quantity: Quantity,
    /// Always `slant`: `K_L = 2 F / (gamma L^2 w)`, passive minus active.
    pub normalisation: String,
    /// Where the numbers come from.
    pub source: String,
    /// Number of filled cells, as a check against truncation.
    pub cells: usize,
    /// Version of the program that wrote it.
    pub program_version: String,
}

/// The one normalisation there is.
pub(super) const SLANT: &str = "slant";

/// Version of the program, which all crates share.
pub(super) const fn program_version() -> &'static str {
    env!("CARGO_PKG_VERSION")
}

impl Sidecar {
    pub(crate) fn of(table: &PredictionTable, source: &str) -> Self {
        Self {
            schema: SIDECAR_SCHEMA.into(),
            name: table.name().into(),
            quantity: table.quantity(),
            normalisation: SLANT.into(),
            source: source.into(),
            cells: table.filled().count(),
            program_version: program_version().into(),
        }
    }

    pub(crate) fn read(table_path: &Path) -> Result<Self, EarthPressureError> {
        let path = sidecar_path(table_path);
        let text = std::fs::read_to_string(&path).map_err(|e| file_error(&path, &e))?;
        let sidecar: Self = serde_json::from_str(&text).map_err(|e| file_error(&path, &e))?;
        let bad =
            |problem: String| EarthPressureError::BadTable { table: path.display().to_string(), problem };
        if sidecar.schema != SIDECAR_SCHEMA {
            return Err(bad(format!(
                "schema is {:?}; this version reads {SIDECAR_SCHEMA:?}",
                sidecar.schema
            )));
        }
        if sidecar.normalisation != SLANT {
            return Err(bad(format!("normalisation is {:?}; it must be {SLANT:?}", sidecar.normalisation)));
        }
        Ok(sidecar)
    }

    pub(crate) fn check_count(&self, path: &Path, cells: usize) -> Result<(), EarthPressureError> {
        Self::same_count(&path.display().to_string(), self.cells, cells)
    }

    /// Refuses a file that has not as many cells as its sidecar says.
    pub(super) fn same_count(table: &str, said: usize, found: usize) -> Result<(), EarthPressureError> {
        if said == found {
            return Ok(());
        }
        Err(EarthPressureError::BadTable {
            table: table.to_owned(),
            problem: format!("it has {found} cells, its sidecar says {said}; the file was cut or edited"),
        })
    }
}

/// Path of the sidecar of a table file.
#[must_use]
pub fn sidecar_path(table_path: &Path) -> PathBuf {
    let mut name = table_path.as_os_str().to_owned();
    name.push(".json");
    name.into()
}

/// Writes a table file and its sidecar, each in one go.
pub(crate) fn write_both(
    path: &Path,
    rows: &[u8],
    sidecar: &impl Serialize,
) -> Result<(), EarthPressureError> {
    let beside = sidecar_path(path);
    let json = serde_json::to_string_pretty(sidecar).map_err(|e| file_error(&beside, &e))? + "\n";
    write_atomically(path, rows).map_err(|e| file_error(path, &e))?;
    write_atomically(&beside, json.as_bytes()).map_err(|e| file_error(&beside, &e))
}

pub(crate) fn file_error(path: &Path, problem: &dyn std::fmt::Display) -> EarthPressureError {
    EarthPressureError::File { path: path.display().to_string(), problem: problem.to_string() }
}
