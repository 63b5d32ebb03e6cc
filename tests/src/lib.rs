//! What the cross-crate tests share: the repository's data files, and the tables that the documentation shows.

use std::path::PathBuf;

/// Path of a file in `data/`.
#[must_use]
pub fn data(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../data").join(name)
}

/// Path of a file in `docs/verification`: rows that `docs/verification.md` is made from.
#[must_use]
pub fn rows(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../docs/verification").join(name)
}
