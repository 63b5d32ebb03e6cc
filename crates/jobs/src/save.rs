//! Files that are whole or as they were before, whatever happens meanwhile.

use std::fs::OpenOptions;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Writes a file in one go: whoever reads it sees the old one or the new one, also after a crash, a kill or a full disk.
/// Several processes may write the same file; the last one wins. A link stays one, a device or pipe is written to as it is.
///
/// # Errors
/// What the system says. Nothing new lies in the folder then.
pub fn write_atomically(path: &Path, bytes: &[u8]) -> io::Result<()> {
    if is_special(path) {
        return std::fs::write(path, bytes);
    }
    let path = if path.is_symlink() { std::fs::canonicalize(path)? } else { path.to_owned() };
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    // `tempfile` puts the name that it chose into its message; the same failure should read the same each time.
    let mut refused = None;
    let open = |name: &Path| {
        let opened = OpenOptions::new().write(true).create_new(true).open(name);
        opened.inspect_err(|problem| refused = problem.raw_os_error())
    };
    let made = tempfile::Builder::new().prefix(".").make_in(folder, open);
    let mut file = made.map_err(|problem| refused.map_or(problem, io::Error::from_raw_os_error))?;
    file.as_file_mut().write_all(bytes)?;
    file.as_file().sync_all()?;
    file.persist(path).map_err(|refused| refused.error)?;
    Ok(())
}

fn is_special(path: &Path) -> bool {
    path.metadata().is_ok_and(|found| !found.is_file())
}

/// A file in the making under another name, for what is too long to be kept in memory. It goes away unless it is kept.
#[derive(Debug)]
pub struct Beside<'a> {
    path: PathBuf,
    out: &'a Path,
}

impl<'a> Beside<'a> {
    /// For `out`; a device or pipe is written to as it is.
    #[must_use]
    pub fn new(out: &'a Path) -> Self {
        let mut name = out.as_os_str().to_owned();
        if !is_special(out) {
            // Always the same, so that what a kill leaves is overwritten the next time.
            name.push(".part");
        }
        Self { path: name.into(), out }
    }

    /// Where to write meanwhile.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Gives the file its name, once all of it is on the disk.
    ///
    /// # Errors
    /// What the system says.
    pub fn keep(self) -> io::Result<()> {
        if self.path == self.out {
            return Ok(());
        }
        // Windows flushes only what may be written to.
        OpenOptions::new().write(true).open(&self.path)?.sync_all()?;
        std::fs::rename(&self.path, self.out)
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

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;

    fn names(folder: &Path) -> Vec<String> {
        let entries = std::fs::read_dir(folder).unwrap();
        let mut names: Vec<_> =
            entries.map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }

    #[test]
    fn a_file_is_replaced_and_nothing_else_lies_there() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("a.txt");
        for text in ["old", "new"] {
            write_atomically(&path, text.as_bytes()).unwrap();
            assert_eq!(std::fs::read_to_string(&path).unwrap(), text);
            assert_eq!(names(dir.path()), ["a.txt"]);
        }
        let missing = dir.path().join("none/a.txt");
        assert_eq!(write_atomically(&missing, b"").unwrap_err().kind(), io::ErrorKind::NotFound);
    }

    #[cfg(unix)]
    #[test]
    fn a_link_stays_a_link_a_device_a_device_and_rights_are_those_of_any_new_file() {
        use std::os::unix::fs::{MetadataExt, symlink};
        let dir = tempfile::tempdir().unwrap();
        let [link, target, plain] = ["link", "target", "plain"].map(|name| dir.path().join(name));
        std::fs::write(&plain, "").unwrap();
        write_atomically(&target, b"1").unwrap();
        assert_eq!(target.metadata().unwrap().mode(), plain.metadata().unwrap().mode());
        symlink(&target, &link).unwrap();
        write_atomically(&link, b"2").unwrap();
        assert!(link.is_symlink());
        assert_eq!(std::fs::read(&target).unwrap(), b"2");
        write_atomically(Path::new("/dev/null"), b"3").unwrap();
        assert!(is_special(Path::new("/dev/null")));
    }

    #[test]
    fn what_is_not_kept_goes_away() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("log");
        for kept in [false, true] {
            let beside = Beside::new(&path);
            std::fs::write(beside.path(), "text").unwrap();
            assert_eq!(names(dir.path()), ["log.part"]);
            if kept {
                beside.keep().unwrap();
            } else {
                drop(beside);
            }
            assert_eq!(path.exists(), kept);
            assert!(!names(dir.path()).contains(&"log.part".to_owned()));
        }
    }
}
