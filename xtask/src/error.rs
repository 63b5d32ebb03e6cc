//! What can go wrong in a chore.

use std::fmt;
use std::process::ExitStatus;

/// Why a chore stopped.
#[derive(Debug)]
pub(crate) enum XtaskError {
    /// A program ran and failed.
    Failed { step: String, command: String, status: ExitStatus },
    /// A program could not be started.
    NotStarted { step: String, command: String, problem: std::io::Error },
    /// A file could not be read or written.
    File { step: String, file: String, problem: std::io::Error },
    /// The machine lacks something that xtask cannot provide.
    Missing { step: String, what: String, remedy: String },
}

impl XtaskError {
    /// A file that could not be read or written in a step.
    pub(crate) fn file(step: &str, file: &std::path::Path, problem: std::io::Error) -> Self {
        Self::File { step: step.to_owned(), file: file.display().to_string(), problem }
    }
}

impl fmt::Display for XtaskError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            // ExitStatus prints as "exit status: 1" or "signal: 9 (SIGKILL)".
            Self::Failed { step, command, status } => {
                write!(f, "step \"{step}\" failed with {status}; the command was: {command}")
            }
            Self::NotStarted { step, command, problem } => {
                write!(f, "step \"{step}\" failed: cannot start \"{command}\": {problem}")
            }
            Self::File { step, file, problem } => write!(f, "step \"{step}\" failed: {file}: {problem}"),
            Self::Missing { step, what, remedy } => write!(f, "step \"{step}\" failed: {what}; {remedy}"),
        }
    }
}

impl std::error::Error for XtaskError {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn messages_name_step_command_and_status() {
        let failed = XtaskError::Failed {
            step: "rust tests".into(),
            command: "cargo test".into(),
            status: std::process::Command::new("false").status().unwrap(),
        };
        let text = failed.to_string();
        for part in ["rust tests", "cargo test", "1"] {
            assert!(text.contains(part), "{text}");
        }
    }
}
