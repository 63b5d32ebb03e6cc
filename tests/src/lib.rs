//! What the cross-crate tests share: the repository's data files.

use std::path::PathBuf;

/// Path of a file in `data/`.
#[must_use]
pub fn data(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../data").join(name)
}
