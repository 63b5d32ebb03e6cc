use std::path::{Path, PathBuf};

use thiserror::Error;

/// What can be wrong with stored work.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum JobsError {
    /// A file or folder could not be read or written.
    #[error("{}: {problem}; check the path, the permissions and the free space", path.display())]
    File {
        /// The file or folder.
        path: PathBuf,
        /// What the system says.
        problem: std::io::Error,
    },
    /// A file of a store that is not one that a store writes.
    #[error("{} is no result of a sweep; delete it, and it is made again", path.display())]
    NoResult {
        /// The file.
        path: PathBuf,
    },
    /// A result whose bytes are not those that were written.
    #[error("{} is damaged; delete it, and it is made again", path.display())]
    Damaged {
        /// The file.
        path: PathBuf,
    },
    /// A journal of a run with other inputs, or of another version of the program.
    #[error(
        "{} is of a run with another {what} ({found}; this one: {wanted}); to go on with that run give its options \
         again, to start anew delete the file or write to another place",
        path.display()
    )]
    OtherRun {
        /// The journal.
        path: PathBuf,
        /// Which input differs.
        what: &'static str,
        /// Its value in the journal.
        found: String,
        /// Its value now.
        wanted: String,
    },
    /// A journal that begins with something else than a journal does.
    #[error(
        "{} is not the journal of a run of this kind: {problem}; to start anew delete the file or write to another \
         place",
        path.display()
    )]
    NoJournal {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        problem: serde_json::Error,
    },
    /// No share of work.
    #[error("it must be I/N with I from 1 to N, such as 2/4")]
    Shard,
    /// A thread could not be started, or ended unexpectedly.
    #[error("a thread {0}; close some programs and start again")]
    Thread(String),
}

impl JobsError {
    /// For `map_err` of what is done with a file.
    pub(crate) fn file<E: Into<std::io::Error>>(path: &Path) -> impl Fn(E) -> Self + use<'_, E> {
        |problem| Self::File { path: path.to_owned(), problem: problem.into() }
    }
}
