use thiserror::Error;

/// Why a mesh cannot be shown.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum MeshError {
    /// It is nowhere to be found.
    #[error("{name} is not at hand; give its folder with --mesh-root")]
    Missing {
        /// As the URDF has it.
        name: String,
    },
    /// A name that leads out of the folders that were given, or nowhere.
    #[error("{name} is no name of a file below a folder: {reason}")]
    Name {
        /// As the URDF has it.
        name: String,
        /// What is wrong with it.
        reason: &'static str,
    },
    /// A file that cannot be read.
    #[error("{file}: {reason}")]
    File {
        /// The file.
        file: String,
        /// What the operating system said.
        reason: String,
    },
    /// A file of another kind.
    #[error("{file} is neither STL nor glTF; convert it to one of these")]
    Kind {
        /// The file.
        file: String,
    },
    /// A file that is malformed.
    #[error("{file} is malformed: {reason}")]
    Malformed {
        /// The file.
        file: String,
        /// What is wrong.
        reason: String,
    },
    /// More than is drawn.
    #[error("{file} has more than {most} {what}; make it coarser")]
    TooLarge {
        /// The file.
        file: String,
        /// What is counted.
        what: &'static str,
        /// The most allowed.
        most: u64,
    },
}

/// What is wrong inside a file, whose name is not known there.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Fault {
    Malformed(String),
    TooMany,
}

impl Fault {
    pub(crate) fn of(reason: impl Into<String>) -> Self {
        Self::Malformed(reason.into())
    }

    pub(crate) fn named(self, file: &std::path::Path, most: u64) -> MeshError {
        let file = file.display().to_string();
        match self {
            Self::Malformed(reason) => MeshError::Malformed { file, reason },
            Self::TooMany => MeshError::TooLarge { file, what: "triangles", most },
        }
    }
}
