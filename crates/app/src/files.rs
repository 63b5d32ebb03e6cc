//! Files in and out.

use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use soilctl_columns::{Cell, ColumnsError, Form, Kind, TableWriter};

use crate::AppError;

/// What a problem with a file is called.
pub(crate) fn failed(path: &Path) -> impl Fn(std::io::Error) -> AppError + use<'_> {
    move |problem| AppError::File { path: path.display().to_string(), problem }
}

/// A text file.
///
/// # Errors
/// [`AppError::File`] if it cannot be read or is no UTF-8.
pub fn read_text(path: &Path) -> Result<String, AppError> {
    std::fs::read_to_string(path).map_err(failed(path))
}

/// Writes a file in one go: whoever reads it sees the old one or the new one.
///
/// # Errors
/// [`AppError::File`] if it cannot be written.
pub fn save(path: &Path, bytes: &[u8]) -> Result<(), AppError> {
    soilctl_jobs::write_atomically(path, bytes).map_err(failed(path))
}

/// Refuses to write over a file that is there, for those who were not told to.
///
/// # Errors
/// [`AppError::Request`] if it is there.
pub fn refuse_over(path: &Path, replace: bool) -> Result<(), AppError> {
    if replace || !path.exists() {
        return Ok(());
    }
    Err(AppError::Request(format!("{} is there; choose another name, or --replace it", path.display())))
}

/// Refuses a name under which no file can be written, for those who work long before they write.
///
/// # Errors
/// [`AppError::File`] if its folder is not there, or it is a folder itself.
pub fn can_be_written(path: &Path) -> Result<(), AppError> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    folder.map_or(Ok(()), |folder| folder.metadata().map(|_| ())).map_err(failed(path))?;
    if path.is_dir() { Err(failed(path)(ErrorKind::IsADirectory.into())) } else { Ok(()) }
}

/// The form of a table that `--table` writes, by the name of its file.
pub(crate) fn table_form(path: &Path) -> Result<Form, AppError> {
    Form::of(path).ok_or_else(|| {
        AppError::Request(format!("--table is {}; the name must end in .csv or .parquet", path.display()))
    })
}

/// Writes a table called `name` in one go.
pub(crate) fn save_table<'c, const N: usize>(
    path: &Path,
    name: &str,
    columns: [(&str, Kind); N],
    rows: impl IntoIterator<Item = [Cell<'c>; N]>,
) -> Result<(), AppError> {
    let failed = |problem: ColumnsError| AppError::Request(format!("{}: {problem}", path.display()));
    let mut table = TableWriter::new(table_form(path)?, Vec::new(), name, columns).map_err(failed)?;
    for row in rows {
        table.row(row).map_err(failed)?;
    }
    save(path, &table.finish().map_err(failed)?)
}

/// A word before the ending of a file's name.
pub(crate) fn numbered(path: &Path, word: &str) -> PathBuf {
    let ending = path.extension().map_or_else(String::new, |ending| format!(".{}", ending.to_string_lossy()));
    path.with_extension(format!("{word}{ending}"))
}
