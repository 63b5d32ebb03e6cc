use std::fs::Permissions;
use std::io::ErrorKind;
use std::os::unix::fs::{FileTypeExt, PermissionsExt};
use std::os::unix::net::{UnixListener, UnixStream};
use std::path::Path;

use crate::LiveError;

/// Listens at `path`, for this user alone. A socket that nobody listens at any more is replaced.
pub(crate) fn bind(path: &Path) -> Result<UnixListener, LiveError> {
    let failed = |error: std::io::Error| LiveError::socket(path, &error);
    let taken = |by| LiveError::Taken { path: path.to_owned(), by };
    match path.symlink_metadata() {
        Err(error) if error.kind() == ErrorKind::NotFound => {}
        Err(error) => return Err(failed(error)),
        Ok(found) if !found.file_type().is_socket() => return Err(taken("it is no socket")),
        Ok(_) => match UnixStream::connect(path) {
            Ok(_) => return Err(taken("another program listens there")),
            Err(_) => std::fs::remove_file(path).map_err(failed)?,
        },
    }
    let listener = UnixListener::bind(path).map_err(failed)?;
    std::fs::set_permissions(path, Permissions::from_mode(0o600)).map_err(failed)?;
    Ok(listener)
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
