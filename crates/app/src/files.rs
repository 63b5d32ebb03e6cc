//! Files in and out.

use std::io::ErrorKind;
use std::path::Path;

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
