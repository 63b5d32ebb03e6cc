//! Whether a log is well.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_session::info_until;

pub use super::Answer;
use super::watched;
use crate::{AppError, Watch};

/// Checks a log: whole, checksums, types, quality of service, missing steps, key frames
#[derive(Debug, Clone, Default, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
pub struct Request {
    /// A log (.mcap)
    pub log: PathBuf,
}

/// Checks a log.
///
/// # Errors
/// [`AppError::Session`] if the file cannot be read, or is no log.
pub fn run(request: &Request, watch: &dyn Watch) -> Result<Answer, AppError> {
    watched(watch, |stop| Ok(Answer::doctor(info_until(&request.log, stop)?)))
}
