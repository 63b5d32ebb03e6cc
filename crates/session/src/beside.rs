//! Files that have their name only once they are whole.

use std::path::{Path, PathBuf};

use crate::SessionError;

/// A file in the making beside the one that it becomes; it goes away unless it is kept.
pub struct Beside<'a> {
    path: PathBuf,
    out: &'a Path,
}

impl<'a> Beside<'a> {
    /// For `out`; a device or pipe is written to as it is.
    #[must_use]
    pub fn new(out: &'a Path) -> Self {
        let special = out.metadata().is_ok_and(|found| !found.is_file());
        let mut name = out.as_os_str().to_owned();
        if !special {
            name.push(".part");
        }
        Self { path: name.into(), out }
    }

    /// Where to write meanwhile.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Gives the file its name.
    ///
    /// # Errors
    /// [`SessionError::File`] if it cannot be renamed.
    pub fn keep(&self) -> Result<(), SessionError> {
        if self.path == self.out {
            return Ok(());
        }
        std::fs::rename(&self.path, self.out).map_err(|error| SessionError::file(self.out, &error))
    }
}

impl Drop for Beside<'_> {
    fn drop(&mut self) {
        if self.path != self.out {
            // After `keep` there is nothing left to remove.
            let _ = std::fs::remove_file(&self.path);
        }
    }
}
