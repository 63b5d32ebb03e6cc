//! Files in and out.

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
