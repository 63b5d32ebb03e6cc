use std::fs::Permissions;
use std::io::ErrorKind;
use std::os::unix::fs::{FileTypeExt, PermissionsExt};
use std::os::unix::net::UnixListener;
use std::path::Path;

use crate::LiveError;

/// A connection.
pub type Stream = std::os::unix::net::UnixStream;

/// Takes those who connect to a path.
#[derive(Debug)]
pub struct Listener(UnixListener);

/// Listens at `path`, for this user alone. A socket that nobody listens at any more is replaced.
///
/// # Errors
/// [`LiveError::Taken`] or [`LiveError::Socket`].
pub fn bind(path: &Path) -> Result<Listener, LiveError> {
    let failed = |error: std::io::Error| LiveError::socket(path, &error);
    let taken = |by| LiveError::Taken { path: path.to_owned(), by };
    match path.symlink_metadata() {
        Err(error) if error.kind() == ErrorKind::NotFound => {}
        Err(error) => return Err(failed(error)),
        Ok(found) if !found.file_type().is_socket() => return Err(taken("it is no socket")),
        Ok(_) => match Stream::connect(path) {
            Ok(_) => return Err(taken("another program listens there")),
            Err(_) => std::fs::remove_file(path).map_err(failed)?,
        },
    }
    let listener = UnixListener::bind(path).map_err(failed)?;
    std::fs::set_permissions(path, Permissions::from_mode(0o600)).map_err(failed)?;
    Ok(Listener(listener))
}

/// Connects to who listens at `path`.
///
/// # Errors
/// The system's, if nobody listens there.
pub fn connect(path: &Path) -> std::io::Result<Stream> {
    Stream::connect(path)
}

impl Listener {
    /// The next who connects; waits for one.
    ///
    /// # Errors
    /// The system's.
    pub fn accept(&mut self) -> std::io::Result<Stream> {
        self.0.set_nonblocking(false)?;
        Ok(self.0.accept()?.0)
    }

    /// The next who has connected, or none.
    pub fn poll(&mut self) -> Option<Stream> {
        self.0.set_nonblocking(true).ok()?;
        self.0.accept().ok().map(|(stream, _)| stream)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_dead_socket_is_replaced() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("s");
        let first = bind(&path).unwrap();
        assert!(matches!(bind(&path), Err(LiveError::Taken { .. })));
        drop(first);
        drop(bind(&path).unwrap());
        let file = dir.path().join("f");
        std::fs::write(&file, "x").unwrap();
        assert!(matches!(bind(&file), Err(LiveError::Taken { .. })));
        assert!(matches!(bind(&dir.path().join("none/s")), Err(LiveError::Socket { .. })));
    }
}
