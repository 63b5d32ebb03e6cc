use std::path::PathBuf;

use soilctl_limit_analysis::DescriptionError;
use soilctl_web::WebError;
use thiserror::Error;

/// Why a workbench could not be started, or its file not be read or written.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum WorkbenchError {
    /// The address cannot be listened at, or there is no token or no thread.
    #[error(transparent)]
    Web(#[from] WebError),
    /// The name of the file does not tell its format.
    #[error("{}: the name must end in .toml or .json; a file that is not there yet is begun", path.display())]
    Ending {
        /// The file.
        path: PathBuf,
    },
    /// The file cannot be read.
    #[error("{}: {message}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// What the system says.
        message: String,
    },
    /// The file is longer than a problem file may be.
    #[error("{}: more than {limit} bytes; a problem file has at most that many", path.display())]
    TooLarge {
        /// The file.
        path: PathBuf,
        /// The limit in bytes.
        limit: u64,
    },
    /// The file cannot be written.
    #[error(
        "{name} could not be saved: {message}; nothing was changed, and the page can download it instead"
    )]
    Write {
        /// Name of the file.
        name: String,
        /// What the system says.
        message: String,
    },
    /// The file was changed since the page read it.
    #[error(
        "{name} was changed by another program since it was opened; save again to write over that, or reload the page to read it"
    )]
    Changed {
        /// Name of the file.
        name: String,
    },
    /// The file held something else than a problem when it was opened.
    #[error("{name} holds what is no problem file; save again to write over that")]
    Strange {
        /// Name of the file.
        name: String,
    },
    /// There is no file to save to.
    #[error("the workbench was started without a file; download the problem instead")]
    NoFile,
    /// What is to be read or saved is no problem file.
    #[error("this is no problem file: {0}")]
    Format(#[from] DescriptionError),
}
