use std::fs::File;
use std::io::Read;
use std::path::Path;

use crate::packed::{ZSTD, zstd};
use crate::{BagError, folder};

/// What a recording is kept in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Container {
    /// An MCAP file.
    Mcap,
    /// A file of SQLite, as ROS 2 writes it.
    Db3,
    /// A bag of ROS 1.
    Ros1,
    /// A folder with the parts of a recording, and mostly a `metadata.yaml`.
    Folder,
}

impl std::fmt::Display for Container {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Mcap => "MCAP",
            Self::Db3 => "ROS 2 bag (SQLite)",
            Self::Ros1 => "ROS 1 bag",
            Self::Folder => "folder of a bag",
        })
    }
}

const MCAP: &[u8] = b"\x89MCAP0\r\n";
const SQLITE: &[u8] = b"SQLite format 3\0";
const ROS1: &[u8] = b"#ROSBAG V2.0\n";

/// What a recording is kept in, by its first bytes whatever its name; what is compressed as a whole counts as what it holds.
///
/// # Errors
/// [`BagError::File`] if it cannot be read, [`BagError::NotARecording`] if it is none.
pub fn kind(path: &Path) -> Result<Container, BagError> {
    look(path).map(|(container, _)| container)
}

/// [`kind`], and whether the file is compressed as a whole.
pub(crate) fn look(path: &Path) -> Result<(Container, bool), BagError> {
    let about = std::fs::metadata(path).map_err(|error| BagError::file(path, &error))?;
    if about.is_dir() {
        return folder::parts(path).map(|_| (Container::Folder, false));
    }
    if !about.is_file() {
        return Err(BagError::not_a_recording(path, "it is neither a file nor a folder"));
    }
    let mut file = File::open(path).map_err(|error| BagError::file(path, &error))?;
    let bytes = beginning(&mut file).map_err(|error| BagError::file(path, &error))?;
    if !bytes.starts_with(&ZSTD) {
        return told(path, &bytes).map(|container| (container, false));
    }
    let mut inside = File::open(path).and_then(zstd).map_err(|error| BagError::file(path, &error))?;
    let bytes = beginning(&mut inside).map_err(|error| {
        BagError::not_a_recording(
            path,
            format!("it is compressed with zstd and damaged at its beginning: {error}"),
        )
    })?;
    told(path, &bytes).map(|container| (container, true))
}

fn beginning(source: &mut dyn Read) -> std::io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    source.take(16).read_to_end(&mut bytes)?;
    Ok(bytes)
}

fn told(path: &Path, bytes: &[u8]) -> Result<Container, BagError> {
    for (magic, container) in [(MCAP, Container::Mcap), (SQLITE, Container::Db3), (ROS1, Container::Ros1)] {
        if bytes.starts_with(magic) {
            return Ok(container);
        }
    }
    let reason = if bytes.is_empty() {
        "it is empty".to_owned()
    } else if bytes.starts_with(b"#ROSBAG V1") {
        "it is a ROS 1 bag of a version before 2.0, which `rosbag fix` of ROS 1 brings up to date".to_owned()
    } else {
        format!(
            "it begins with the bytes {}",
            bytes.iter().take(8).map(|b| format!("{b:02x}")).collect::<Vec<_>>().join(" ")
        )
    };
    Err(BagError::not_a_recording(path, reason))
}

/// Whether a file or folder looks like a recording by its name, for collecting those of a folder. Nothing but `metadata.yaml` is
/// opened; [`kind`] tells for certain.
#[must_use]
pub fn is_recording(path: &Path) -> bool {
    if path.is_dir() {
        return folder::has_metadata(path);
    }
    let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default();
    // A file that is called only `.bag` has no name.
    let stem = name.strip_suffix(".zstd").unwrap_or(name);
    [".mcap", ".db3", ".bag"].iter().any(|ending| stem.len() > ending.len() && stem.ends_with(ending))
        && path.is_file()
}
